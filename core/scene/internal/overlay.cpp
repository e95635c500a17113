#include "scene/internal/overlay.h"

// glew must come before any other OpenGL header.
#include <GL/glew.h>

#include <vtkActor2D.h>
#include <vtkCellData.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProp.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <algorithm>
#include <cmath>
#include <mutex>

namespace glisson::scene {
namespace {

unsigned char byte_of(double share) {
  return static_cast<unsigned char>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

// VTK's fonts are shared by the whole program, whichever thread writes.
std::mutex& fonts() {
  static std::mutex one_at_a_time;
  return one_at_a_time;
}

void justify(vtkTextProperty& property, Anchor anchor) {
  switch (anchor) {
    case Anchor::lower_left: property.SetJustificationToLeft(), property.SetVerticalJustificationToBottom(); break;
    case Anchor::lower_centre:
      property.SetJustificationToCentered(), property.SetVerticalJustificationToBottom();
      break;
    case Anchor::upper_left: property.SetJustificationToLeft(), property.SetVerticalJustificationToTop(); break;
    case Anchor::upper_right: property.SetJustificationToRight(), property.SetVerticalJustificationToTop(); break;
    case Anchor::lower_right: property.SetJustificationToRight(), property.SetVerticalJustificationToBottom(); break;
    case Anchor::centre: property.SetJustificationToCentered(), property.SetVerticalJustificationToCentered(); break;
    case Anchor::left_centre: property.SetJustificationToLeft(), property.SetVerticalJustificationToCentered(); break;
    case Anchor::right_centre: property.SetJustificationToRight(), property.SetVerticalJustificationToCentered(); break;
  }
}

}  // namespace

// Draws the shapes and then the texts, each over what came before: VTK's own 2D actors test depth against each other,
// and with depth peeling on the first one drawn would win.
class FlatProp : public vtkProp {
 public:
  static FlatProp* New();
  vtkTypeMacro(FlatProp, vtkProp)

      vtkNew<vtkActor2D> shapes;
  std::vector<vtkSmartPointer<vtkTextActor>> texts;

  int RenderOverlay(vtkViewport* viewport) override {
    vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(viewport->GetVTKWindow())->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth_test_as_before(state, GL_DEPTH_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    int drawn = shapes->RenderOverlay(viewport);
    const std::lock_guard lock(fonts());
    for (const auto& text : texts) drawn += text->GetVisibility() != 0 ? text->RenderOverlay(viewport) : 0;
    return drawn;
  }
  int RenderOpaqueGeometry(vtkViewport* viewport) override {
    const std::lock_guard lock(fonts());
    for (const auto& text : texts) {
      if (text->GetVisibility() != 0) text->RenderOpaqueGeometry(viewport);
    }
    return 0;
  }
  void ReleaseGraphicsResources(vtkWindow* window) override {
    shapes->ReleaseGraphicsResources(window);
    for (const auto& text : texts) text->ReleaseGraphicsResources(window);
  }
};
vtkStandardNewMacro(FlatProp)

    Overlay::Overlay(vtkRenderer& renderer)
    : renderer_(renderer), prop_(vtkSmartPointer<FlatProp>::New()) {
  colours_->SetNumberOfComponents(4);
  shapes_->SetPoints(points_);
  shapes_->SetPolys(polygons_);
  shapes_->GetCellData()->SetScalars(colours_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shapes_);
  mapper->SetScalarModeToUseCellData();
  prop_->shapes->SetMapper(mapper);
  renderer_.AddViewProp(prop_);
}

Overlay::~Overlay() { renderer_.RemoveViewProp(prop_); }

void Overlay::begin() {
  points_->Reset();
  polygons_->Reset();
  colours_->Reset();
  texts_used_ = 0;
}

void Overlay::fill(const std::vector<Eigen::Vector2d>& corners, const Colour& colour, double opacity) {
  polygons_->InsertNextCell(static_cast<int>(corners.size()));
  for (const Eigen::Vector2d& corner : corners) {
    polygons_->InsertCellPoint(points_->InsertNextPoint(corner.x(), corner.y(), 0));
  }
  const std::array<unsigned char, 4> rgba{byte_of(colour.red), byte_of(colour.green), byte_of(colour.blue),
                                          byte_of(opacity)};
  colours_->InsertNextTypedTuple(rgba.data());
}

void Overlay::rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Colour& colour, double opacity) {
  fill({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, colour, opacity);
}

void Overlay::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width_px, const Colour& colour,
                   double opacity) {
  const Eigen::Vector2d along = to - from;
  if (along.norm() < 1e-9) return;
  const Eigen::Vector2d aside = 0.5 * width_px * Eigen::Vector2d(-along.y(), along.x()).normalized();
  fill({from - aside, to - aside, to + aside, from + aside}, colour, opacity);
}

Eigen::Vector2d Overlay::text(const std::string& words, const Eigen::Vector2d& place, Anchor anchor,
                              const TextStyle& style) {
  if (words.empty()) return {0, 0};
  if (texts_used_ == prop_->texts.size()) {
    prop_->texts.push_back(vtkSmartPointer<vtkTextActor>::New());
    prop_->texts.back()->SetTextScaleModeToNone();
  }
  vtkTextActor& actor = *prop_->texts[texts_used_++];
  actor.SetVisibility(1);
  actor.SetInput(words.c_str());
  actor.SetPosition(std::round(place.x()), std::round(place.y()));
  vtkTextProperty& property = *actor.GetTextProperty();
  property.SetFontFamilyToArial();
  property.SetFontSize(static_cast<int>(std::lround(style.size_px)));
  property.SetBold(style.bold ? 1 : 0);
  property.SetColor(style.colour.red, style.colour.green, style.colour.blue);
  property.SetOpacity(style.opacity);
  property.SetBackgroundColor(style.plate.red, style.plate.green, style.plate.blue);
  property.SetBackgroundOpacity(style.plate_opacity);
  justify(property, anchor);
  std::array<double, 2> size{0, 0};
  const std::lock_guard lock(fonts());
  actor.GetSize(&renderer_, size.data());
  return {size[0], size[1]};
}

void Overlay::end() {
  for (std::size_t k = texts_used_; k < prop_->texts.size(); ++k) prop_->texts[k]->SetVisibility(0);
  points_->Modified();
  polygons_->Modified();
  colours_->Modified();
  shapes_->Modified();
}

}  // namespace glisson::scene
