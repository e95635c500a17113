#include "vision/draw.h"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "vision/internal/opencv.h"

namespace glisson::vision {
namespace {

// OpenCV's drawing knows only a picture of three numbers a pixel: ours are red, green, blue.
cv::Mat pixels_of(Frame& frame) { return {frame.height, frame.width, CV_8UC3, frame.rgb.data()}; }
constexpr int shift = 4;  // OpenCV's corners in sixteenths of a pixel
cv::Point in_sixteenths(const Eigen::Vector2d& at) {
  const auto within = [](double px) { return std::clamp(px, -1e5, 1e5); };
  return {static_cast<int>(std::lround(within(at.x()) * (1 << shift))),
          static_cast<int>(std::lround(within(at.y()) * (1 << shift)))};
}
cv::Scalar scalar(const Rgb& colour) { return {double(colour[0]), double(colour[1]), double(colour[2])}; }

}  // namespace

std::vector<std::optional<Eigen::Vector2d>> project(const Camera& camera,
                                                    const std::vector<Eigen::Vector3d>& points_mm) {
  constexpr double nearest_mm = 1e-6;
  std::vector<std::optional<Eigen::Vector2d>> seen(points_mm.size());
  std::vector<cv::Point3d> in_front;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < points_mm.size(); ++i) {
    if (!points_mm[i].allFinite() || points_mm[i].z() < nearest_mm) continue;
    in_front.emplace_back(points_mm[i].x(), points_mm[i].y(), points_mm[i].z());
    which.push_back(i);
  }
  if (in_front.empty()) return seen;
  cv::Mat matrix;
  cv::eigen2cv(camera.matrix, matrix);
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(in_front, cv::Vec3d(0, 0, 0), cv::Vec3d(0, 0, 0), matrix, cv::Mat(camera.distortion, true), pixels);
  for (std::size_t i = 0; i < pixels.size(); ++i) seen[which[i]] = Eigen::Vector2d(pixels[i].x, pixels[i].y);
  return seen;
}

std::vector<std::optional<Eigen::Vector3d>> rays(const Camera& camera, const std::vector<Eigen::Vector2d>& pixels) {
  constexpr double off_px = 0.5;  // of a ray from its pixel: its polynomial was not turned round
  std::vector<std::optional<Eigen::Vector3d>> found(pixels.size());
  if (pixels.empty()) return found;
  std::vector<cv::Point2d> seen, straight;
  for (const Eigen::Vector2d& pixel : pixels) seen.emplace_back(pixel.x(), pixel.y());
  cv::Mat matrix;
  cv::eigen2cv(camera.matrix, matrix);
  cv::undistortPoints(seen, straight, matrix, cv::Mat(camera.distortion, true), cv::noArray(), cv::noArray(),
                      cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4));
  std::vector<Eigen::Vector3d> directions;
  for (const cv::Point2d& point : straight) directions.emplace_back(point.x, point.y, 1);
  const auto back = project(camera, directions);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (back[i] && (*back[i] - pixels[i]).norm() < off_px) found[i] = directions[i];
  }
  return found;
}

void draw_triangles(Frame& frame, const std::vector<FlatTriangle>& triangles, double opacity) {
  cv::Mat picture = pixels_of(frame);
  cv::Mat layer = picture.clone();
  for (const FlatTriangle& triangle : triangles) {
    const std::array<cv::Point, 3> corners{in_sixteenths(triangle.corners_px[0]), in_sixteenths(triangle.corners_px[1]),
                                           in_sixteenths(triangle.corners_px[2])};
    cv::fillConvexPoly(layer, corners.data(), 3, scalar(triangle.colour), cv::LINE_AA, shift);
    const cv::Point* outline = corners.data();
    const int count = 3;
    cv::polylines(layer, &outline, &count, 1, true, 0.6 * scalar(triangle.colour), 1, cv::LINE_AA, shift);
  }
  cv::addWeighted(layer, opacity, picture, 1 - opacity, 0, picture);
}

std::vector<std::vector<Eigen::Vector2d>> outlines(int width, int height,
                                                   const std::vector<std::array<Eigen::Vector2d, 3>>& triangles_px) {
  cv::Mat covered(height, width, CV_8UC1, cv::Scalar(0));
  for (const auto& triangle : triangles_px) {
    const std::array<cv::Point, 3> corners{in_sixteenths(triangle[0]), in_sixteenths(triangle[1]),
                                           in_sixteenths(triangle[2])};
    cv::fillConvexPoly(covered, corners.data(), 3, cv::Scalar(255), cv::LINE_8, shift);
  }
  std::vector<std::vector<cv::Point>> found;
  cv::findContours(covered, found, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::vector<std::vector<Eigen::Vector2d>> lines;
  for (const auto& contour : found) {
    auto& line = lines.emplace_back();
    for (const cv::Point& pixel : contour) line.emplace_back(pixel.x, pixel.y);
  }
  return lines;
}

void draw_line(Frame& frame, const std::vector<Eigen::Vector2d>& points_px, Rgb colour, int width_px) {
  std::vector<cv::Point> points;
  for (const Eigen::Vector2d& point : points_px) points.push_back(in_sixteenths(point));
  cv::Mat picture = pixels_of(frame);
  cv::polylines(picture, points, false, scalar(colour), width_px, cv::LINE_AA, shift);
}

void draw_rectangle(Frame& frame, int x, int y, int width, int height, Rgb colour) {
  cv::Mat picture = pixels_of(frame);
  cv::rectangle(picture, cv::Rect(x, y, width, height), scalar(colour), cv::FILLED);
}

void draw_text(Frame& frame, int x, int y, int height_px, const std::string& text, Rgb colour) {
  constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
  cv::Mat picture = pixels_of(frame);
  const int thickness = std::max(1, height_px / 9);
  cv::putText(picture, text, {x, y}, font, cv::getFontScaleFromHeight(font, height_px, thickness), scalar(colour),
              thickness, cv::LINE_AA);
}

}  // namespace glisson::vision
