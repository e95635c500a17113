#include "scene/markers.h"

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
vtkNew<vtkMatrix4x4> placement(const ArrowItem& arrow) {
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
    shown.actor->SetUserMatrix(placement(arrows[k]));
    make_glossy(*shown.actor, arrows[k].colour);
  }
}

}  // namespace glisson::scene
