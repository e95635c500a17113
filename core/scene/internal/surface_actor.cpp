#include "scene/internal/surface_actor.h"

// glew must come before any other OpenGL header.
#include <GL/glew.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <set>

namespace glisson::scene {
namespace {

// Clear where it faces the viewer, denser towards its rim; a highlight stays as bright as on something solid.
constexpr const char* glass_shader =
    "//VTK::Light::Impl\n"
    "  float facing = clamp(abs(normalVCVSOutput.z), 0.0, 1.0);\n"
    "  float density = opacity * mix(1.0, 0.38, pow(facing, 1.2));\n"
    "  gl_FragData[0].a = clamp(density + 0.8 * specular.g, 0.0, 1.0);\n";

// The more, the more the surface is seen from the side: an x-ray's look.
constexpr const char* light_shader =
    "//VTK::Light::Impl\n"
    "  float facing = clamp(abs(normalVCVSOutput.z), 0.0, 1.0);\n"
    "  gl_FragData[0].a = opacity * mix(1.0, 0.45, facing);\n";

// Darker towards its rim, so that a vessel stands out of what lies behind it.
constexpr const char* solid_shader =
    "//VTK::Light::Impl\n"
    "  float facing = clamp(abs(normalVCVSOutput.z), 0.0, 1.0);\n"
    "  gl_FragData[0].rgb *= mix(0.45, 1.0, smoothstep(0.05, 0.50, facing));\n";

// Adds to what is there instead of covering it. In VTK's opaque pass, because the passes for what is translucent bring
// their own blending; and without the test of depth, as light has it.
class AddingActor : public vtkOpenGLActor {
 public:
  static AddingActor* New();
  vtkTypeMacro(AddingActor, vtkOpenGLActor)

      void Render(vtkRenderer* renderer, vtkMapper* mapper) override {
    vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth_as_before(state, GL_DEPTH_TEST);
    const vtkOpenGLState::ScopedglEnableDisable blend_as_before(state, GL_BLEND);
    const vtkOpenGLState::ScopedglBlendFuncSeparate blending_as_before(state);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ONE, GL_ONE);
    vtkOpenGLActor::Render(renderer, mapper);
  }
};
vtkStandardNewMacro(AddingActor)

    // Glass, which either waits for VTK's sorting of what is translucent or is drawn in its turn over what is there.
    class GlassActor : public vtkOpenGLActor {
 public:
  static GlassActor* New();
  vtkTypeMacro(GlassActor, vtkOpenGLActor)

      void Render(vtkRenderer* renderer, vtkMapper* mapper) override {
    if (!GetForceOpaque()) {
      vtkOpenGLActor::Render(renderer, mapper);
      return;
    }
    vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
    const vtkOpenGLState::ScopedglDepthMask depth_as_before(state);
    const vtkOpenGLState::ScopedglEnableDisable blend_as_before(state, GL_BLEND);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_BLEND);
    mapper->Render(renderer, this);
  }
};
vtkStandardNewMacro(GlassActor)

    vtkSmartPointer<vtkActor> actor_for(const SurfaceItem& item) {
  if (item.finish == Finish::light) return vtkSmartPointer<AddingActor>::New();
  if (item.finish == Finish::glass && item.opacity < 1) return vtkSmartPointer<GlassActor>::New();
  return vtkSmartPointer<vtkActor>::New();
}

vtkNew<vtkLookupTable> lookup_table(const Colouring& colouring) {
  constexpr int steps = 256;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(steps);
  table->SetTableRange(colouring.range[0], colouring.range[1]);
  for (int k = 0; k < steps; ++k) {
    const Colour colour = colour_at(colouring.map, k / double(steps - 1));
    table->SetTableValue(k, colour.red, colour.green, colour.blue, 1);
  }
  return table;
}

}  // namespace

SurfaceActor::SurfaceActor(vtkRenderer& renderer, const SurfaceItem& item)
    : renderer_(renderer), surface_(*item.surface), actor_(actor_for(item)) {
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(surface_.triangles.size()),
                           3 * static_cast<vtkIdType>(surface_.triangles.size()));
  for (const auto& triangle : surface_.triangles) {
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  }
  points_->SetDataTypeToFloat();
  normals_->SetNumberOfComponents(3);
  mesh_->SetPoints(points_);
  mesh_->SetPolys(triangles);
  mesh_->GetPointData()->SetNormals(normals_);
  move(surface_.points_mm);

  mapper_->SetInputData(mesh_);
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  vtkProperty& property = *actor_->GetProperty();
  property.SetColor(item.colour.red, item.colour.green, item.colour.blue);
  property.SetOpacity(item.opacity);
  property.SetAmbient(0.10);
  property.SetDiffuse(0.85);
  property.SetSpecular(0.22);
  property.SetSpecularPower(28);
  if (item.finish == Finish::glass && item.opacity < 1) shade_as_glass();
  if (item.finish == Finish::light) shade_as_light();
  // Colours that stand for values stay as the legend has them.
  if (item.finish == Finish::solid && item.opacity >= 1 && !item.colouring)
    actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, solid_shader, false);
  if (item.colouring) colour_by(*item.colouring);
  renderer_.AddActor(actor_);
}

SurfaceActor::~SurfaceActor() { renderer_.RemoveActor(actor_); }

void SurfaceActor::sort_what_is_clear(bool sorted) {
  if (GlassActor::SafeDownCast(actor_) != nullptr) actor_->SetForceOpaque(!sorted);
}

void SurfaceActor::draw_last() {
  vtkPropCollection& all = *renderer_.GetViewProps();  // RemoveActor would let go of its buffers
  all.RemoveItem(actor_);
  all.AddItem(actor_);
}

// Surfaces with few triangles, and those whose triangles carry values, stay as they are.
void SurfaceActor::set_detail(Detail detail) {
  constexpr std::size_t few = 4000;
  const bool has_cell_values = mesh_->GetCellData()->GetScalars() != nullptr;
  if (surface_.triangles.size() <= few || has_cell_values) return;
  if (detail == Detail::coarse && coarse_mapper_ == nullptr) make_coarse();
  actor_->SetMapper(detail == Detail::coarse ? coarse_mapper_.GetPointer() : mapper_.GetPointer());
}

void SurfaceActor::make_coarse() {
  // Cubes whose faces the surface fills with about a twelfth of its triangles, two a square.
  double area_mm2 = 0;
  for (const auto& triangle : surface_.triangles) {
    const auto at = [&](std::size_t k) { return surface_.points_mm[static_cast<std::size_t>(triangle[k])]; };
    area_mm2 += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  const double wanted = std::max(2000.0, static_cast<double>(surface_.triangles.size()) / 12);
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : clustered_triangles(surface_, std::sqrt(2 * area_mm2 / wanted))) {
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  }
  coarse_mesh_->ShallowCopy(mesh_);
  coarse_mesh_->SetPolys(triangles);
  coarse_mapper_ = vtkSmartPointer<vtkPolyDataMapper>::New();
  coarse_mapper_->SetInputData(coarse_mesh_);
  coarse_mapper_->SetLookupTable(mapper_->GetLookupTable());
  coarse_mapper_->SetScalarVisibility(mapper_->GetScalarVisibility());
  coarse_mapper_->SetScalarMode(mapper_->GetScalarMode());
  coarse_mapper_->SetInterpolateScalarsBeforeMapping(mapper_->GetInterpolateScalarsBeforeMapping());
  coarse_mapper_->SetUseLookupTableScalarRange(mapper_->GetUseLookupTableScalarRange());
}

void SurfaceActor::move(const std::vector<Eigen::Vector3d>& points_mm) {
  GLISSON_ASSERT(points_mm.size() == surface_.points_mm.size());
  surface_.points_mm = points_mm;
  const std::vector<Eigen::Vector3d> normals = geometry::point_normals(surface_);
  const auto count = static_cast<vtkIdType>(points_mm.size());
  points_->SetNumberOfPoints(count);
  normals_->SetNumberOfTuples(count);
  auto* positions = static_cast<vtkFloatArray*>(points_->GetData())->GetPointer(0);
  auto* directions = normals_->GetPointer(0);
  for (std::size_t p = 0; p < points_mm.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      *positions++ = static_cast<float>(points_mm[p][c]);
      *directions++ = static_cast<float>(normals[p][c]);
    }
  }
  points_->Modified();
  normals_->Modified();
  mesh_->Modified();
  coarse_mesh_->Modified();
}

void SurfaceActor::recolour(const std::vector<double>& values) {
  GLISSON_ASSERT(static_cast<vtkIdType>(values.size()) == values_->GetNumberOfTuples());
  for (std::size_t k = 0; k < values.size(); ++k) {
    values_->SetValue(static_cast<vtkIdType>(k), static_cast<float>(values[k]));
  }
  values_->Modified();
  mesh_->Modified();
  coarse_mesh_->Modified();
}

void SurfaceActor::colour_by(const Colouring& colouring) {
  const geometry::Field* on_points = geometry::find_field(surface_.point_fields, colouring.field);
  const geometry::Field* field =
      on_points != nullptr ? on_points : geometry::find_field(surface_.cell_fields, colouring.field);
  GLISSON_ASSERT(field != nullptr);
  const std::vector<double> values = values_to_colour(*field);
  values_->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  recolour(values);
  if (on_points != nullptr) {
    mesh_->GetPointData()->SetScalars(values_);
    mapper_->SetScalarModeToUsePointData();
    mapper_->InterpolateScalarsBeforeMappingOn();
  } else {
    mesh_->GetCellData()->SetScalars(values_);
    mapper_->SetScalarModeToUseCellData();
  }
  mapper_->SetLookupTable(lookup_table(colouring));
  mapper_->UseLookupTableScalarRangeOn();
  mapper_->ScalarVisibilityOn();
}

void SurfaceActor::shade_as_glass() {
  vtkProperty& property = *actor_->GetProperty();
  property.BackfaceCullingOn();
  property.SetAmbient(0.16);
  property.SetSpecular(0.34);
  property.SetSpecularPower(36);
  actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, glass_shader, false);
}

void SurfaceActor::shade_as_light() {
  actor_->GetProperty()->BackfaceCullingOn();
  actor_->ForceOpaqueOn();
  actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, light_shader, false);
}

std::vector<std::array<int, 3>> clustered_triangles(const geometry::Surface& surface, double edge_mm) {
  std::map<std::array<int, 3>, int> first_in_cube;
  std::vector<int> stands_for(surface.points_mm.size());
  for (std::size_t p = 0; p < stands_for.size(); ++p) {
    const Eigen::Vector3d cube = (surface.points_mm[p] / edge_mm).array().floor();
    const std::array<int, 3> key{static_cast<int>(cube.x()), static_cast<int>(cube.y()), static_cast<int>(cube.z())};
    stands_for[p] = first_in_cube.try_emplace(key, static_cast<int>(p)).first->second;
  }
  std::set<std::array<int, 3>> triangles;
  for (const auto& triangle : surface.triangles) {
    std::array<int, 3> now{};
    for (std::size_t k = 0; k < 3; ++k) now[k] = stands_for[static_cast<std::size_t>(triangle[k])];
    if (now[0] == now[1] || now[1] == now[2] || now[2] == now[0]) continue;
    std::rotate(now.begin(), std::min_element(now.begin(), now.end()), now.end());  // so that equal ones look equal
    triangles.insert(now);
  }
  return {triangles.begin(), triangles.end()};
}

std::vector<double> values_to_colour(const geometry::Field& field) {
  if (field.components == 1) return field.values;
  const auto components = static_cast<std::size_t>(field.components);
  std::vector<double> lengths(field.items());
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    lengths[k] = Eigen::Map<const Eigen::VectorXd>(&field.values[k * components], field.components).norm();
  }
  return lengths;
}

}  // namespace glisson::scene
