#include "scene/internal/markers.h"

#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <algorithm>
#include <Eigen/Geometry>

namespace glisson::scene {
namespace {

void make_glossy(vtkActor& actor, const Colour& colour) {
  vtkProperty& property = *actor.GetProperty();
  property.SetColor(colour.red, colour.green, colour.blue);
  property.SetAmbient(0.25);
  property.SetDiffuse(0.75);
  property.SetSpecular(0.4);
  property.SetSpecularPower(40);
}

// Takes the unit arrow, which lies along x, to where it belongs; its radii are in mm already.
vtkNew<vtkMatrix4x4> arrow_placement(const ArrowItem& arrow) {
  const Eigen::Vector3d way = arrow.tip_mm - arrow.tail_mm;
  const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), way).toRotationMatrix();
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    matrix->SetElement(row, 0, turn(row, 0) * way.norm());
    matrix->SetElement(row, 1, turn(row, 1));
    matrix->SetElement(row, 2, turn(row, 2));
    matrix->SetElement(row, 3, arrow.tail_mm[row]);
  }
  return matrix;
}

}  // namespace

Markers::Markers(vtkRenderer& renderer) : renderer_(renderer) {
  ball_->SetRadius(1);
  ball_->SetThetaResolution(32);
  ball_->SetPhiResolution(24);
  ball_mapper_->SetInputConnection(ball_->GetOutputPort());
}

Markers::~Markers() {
  for (const auto& ball : balls_) renderer_.RemoveActor(ball);
  for (const auto& arrow : arrows_) renderer_.RemoveActor(arrow->actor);
  for (const auto& rod : rods_) {
    renderer_.RemoveActor(rod->shaft);
    for (const auto& end : rod->ends) renderer_.RemoveActor(end);
  }
}

void Markers::set_landmarks(const std::vector<LandmarkItem>& landmarks) {
  while (balls_.size() < landmarks.size()) {
    balls_.push_back(vtkSmartPointer<vtkActor>::New());
    balls_.back()->SetMapper(ball_mapper_);
    renderer_.AddActor(balls_.back());
  }
  for (std::size_t k = 0; k < balls_.size(); ++k) {
    balls_[k]->SetVisibility(k < landmarks.size() ? 1 : 0);
    if (k >= landmarks.size()) continue;
    const LandmarkItem& landmark = landmarks[k];
    balls_[k]->SetPosition(landmark.position_mm.x(), landmark.position_mm.y(), landmark.position_mm.z());
    balls_[k]->SetScale(landmark.radius_mm);
    make_glossy(*balls_[k], landmark.colour);
  }
}

void Markers::set_rods(const std::vector<RodItem>& rods) {
  while (rods_.size() < rods.size()) {
    Rod& rod = *rods_.emplace_back(std::make_unique<Rod>());
    rod.tube->SetInputConnection(rod.axis->GetOutputPort());
    rod.tube->SetNumberOfSides(20);
    rod.mapper->SetInputConnection(rod.tube->GetOutputPort());
    rod.shaft->SetMapper(rod.mapper);
    renderer_.AddActor(rod.shaft);
    for (const auto& end : rod.ends) {
      end->SetMapper(ball_mapper_);
      renderer_.AddActor(end);
    }
  }
  for (std::size_t k = 0; k < rods_.size(); ++k) {
    Rod& shown = *rods_[k];
    const bool there = k < rods.size();
    const bool is_ball = there && (rods[k].to_mm - rods[k].from_mm).norm() < 1e-6;
    shown.shaft->SetVisibility(there && !is_ball ? 1 : 0);
    for (std::size_t e = 0; e < 2; ++e) {
      shown.ends[e]->SetVisibility(there ? 1 : 0);
      if (!there) continue;
      const Eigen::Vector3d& at = e == 0 ? rods[k].from_mm : rods[k].to_mm;
      shown.ends[e]->SetPosition(at.x(), at.y(), at.z());
      shown.ends[e]->SetScale(rods[k].radius_mm);
      make_glossy(*shown.ends[e], rods[k].colour);
    }
    if (!there || is_ball) continue;
    shown.axis->SetPoint1(rods[k].from_mm.x(), rods[k].from_mm.y(), rods[k].from_mm.z());
    shown.axis->SetPoint2(rods[k].to_mm.x(), rods[k].to_mm.y(), rods[k].to_mm.z());
    shown.tube->SetRadius(rods[k].radius_mm);
    make_glossy(*shown.shaft, rods[k].colour);
  }
}

void Markers::set_arrows(const std::vector<ArrowItem>& arrows) {
  while (arrows_.size() < arrows.size()) {
    Arrow& arrow = *arrows_.emplace_back(std::make_unique<Arrow>());
    arrow.shape->SetShaftResolution(32);
    arrow.shape->SetTipResolution(32);
    arrow.mapper->SetInputConnection(arrow.shape->GetOutputPort());
    arrow.actor->SetMapper(arrow.mapper);
    renderer_.AddActor(arrow.actor);
  }
  for (std::size_t k = 0; k < arrows_.size(); ++k) {
    Arrow& shown = *arrows_[k];
    const double length_mm = k < arrows.size() ? (arrows[k].tip_mm - arrows[k].tail_mm).norm() : 0;
    shown.actor->SetVisibility(length_mm > 1e-6 ? 1 : 0);
    if (!(length_mm > 1e-6)) continue;
    shown.shape->SetShaftRadius(0.5 * arrows[k].thickness_mm);
    shown.shape->SetTipRadius(1.25 * arrows[k].thickness_mm);
    shown.shape->SetTipLength(std::min(0.6, 3 * arrows[k].thickness_mm / length_mm));
    shown.actor->SetUserMatrix(arrow_placement(arrows[k]));
    make_glossy(*shown.actor, arrows[k].colour);
  }
}

}  // namespace glisson::scene
