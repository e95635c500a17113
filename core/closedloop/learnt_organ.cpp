#include "closedloop/learnt_organ.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "base/json.h"
#include "base/units.h"
#include "closedloop/palpation/internal/attachment.h"
#include "closedloop/palpation/internal/effects.h"
#include "closedloop/palpation/internal/structure.h"
#include "mechanics/elements/boundary.h"
#include "mechanics/elements/node_layout.h"
#include "mechanics/elements/quadrature.h"
#include "mechanics/elements/shape_functions.h"

namespace glisson::closedloop {
namespace {

// A number that no organ can have.
struct Misfit {
  std::string name;
};

// One effect of the file.
struct Learnt {
  std::string kind;
  std::string form;
  const Json& parameters;

  [[nodiscard]] double number(const char* name) const { return numbers(name, 1)[0]; }
  [[nodiscard]] double above_zero(const char* name) const {
    const double value = number(name);
    if (value <= 0) throw Misfit{name};
    return value;
  }
  [[nodiscard]] Eigen::Vector3d vector(const char* name) const { return Eigen::Vector3d::Map(numbers(name, 3).data()); }
  // A list, or a single number; of any length where `size` is 0.
  [[nodiscard]] std::vector<double> numbers(const char* name, std::size_t size = 0) const {
    const Json& json = parameters.at(name);
    auto values = json.is_array() ? json.get<std::vector<double>>() : std::vector<double>{json.get<double>()};
    const bool finite = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (!finite || values.empty() || (size > 0 && values.size() != size)) throw Misfit{name};
    return values;
  }
};

struct Circumstances {
  const geometry::TetMesh& mesh;
  bool material_test;
  bool same_organ;       // the specimen was this organ in this place
  std::size_t supports;  // as many as were declared: others were learnt
};

LearntEffect take(const Learnt& effect, const Circumstances& about, OrganModel& organ);
std::vector<Sentence> remarks_on(const Json& document);
SpecimenPlace place_from(const Json& json);
Failure not_complete(const std::filesystem::path& file);

}  // namespace

Result<LearntOrgan> learn_organ(OrganModel declared, const geometry::TetMesh& mesh,
                                const std::filesystem::path& model_file, const std::vector<std::string>& kinds) {
  const auto document = read_json_file(model_file);
  if (!document) return failure(document.error());
  LearntOrgan learnt{std::move(declared), {}, {}, {}};
  const auto wanted = [&](const std::string& kind) {
    return kinds.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  };
  try {
    const bool material_test = document->at("kind") == "material";
    if (document->at("format") != "glisson-closedloop-model/1" ||
        (!material_test && document->at("kind") != "palpation" && document->at("kind") != "guidance")) {
      return failure(Error{"model-invalid",
                           GLISSON_TEXT("{0} was not learnt from tissue."),
                           {model_file.filename().string()},
                           GLISSON_TEXT("Use the model.json that glisson-cli explain wrote for a palpation or a "
                                        "material test; a platform's goes to glisson-cli platform learn."),
                           model_file});
    }
    const bool same_organ =
        document->contains("specimen") && same_place(place_from(document->at("specimen")), place_of(mesh));
    const Circumstances about{mesh, material_test, same_organ, learnt.organ.supports.size()};
    learnt.specimen = {document->value("title", document->value("learnt_from", std::string())), same_organ};
    for (const Json& json : document->at("effects")) {
      const Learnt effect{json.at("kind").get<std::string>(), json.value("law", std::string()), json.at("parameters")};
      if (wanted(effect.kind)) learnt.effects.push_back(take(effect, about, learnt.organ));
    }
    learnt.remarks = remarks_on(*document);
  } catch (const Json::exception&) {
    return not_complete(model_file);
  } catch (const Misfit& misfit) {
    return failure(Error{"model-invalid",
                         GLISSON_TEXT("In {0} no tissue can have such a {1}."),
                         {model_file.filename().string(), misfit.name},
                         {},
                         model_file});
  }
  for (const std::string& kind : kinds) {
    if (std::any_of(learnt.effects.begin(), learnt.effects.end(), [&](const auto& one) { return one.kind == kind; }))
      continue;
    return failure(Error{"effect-missing",
                         GLISSON_TEXT("{0} has no effect {1}."),
                         {model_file.filename().string(), kind},
                         {},
                         model_file});
  }
  return learnt;
}

SpecimenPlace place_of(const geometry::TetMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& cell : mesh.cells) {
    for (const int point : cell) box.extend(mesh.points_mm[static_cast<std::size_t>(point)]);
  }
  return {box.min(), box.max(), geometry::volume_mm3(mesh)};
}

bool same_place(const SpecimenPlace& a, const SpecimenPlace& b) {
  constexpr double part = 0.01;
  const double near_mm = part * (b.max_mm - b.min_mm).norm();
  return (a.min_mm - b.min_mm).norm() <= near_mm && (a.max_mm - b.max_mm).norm() <= near_mm &&
         std::abs(a.volume_mm3 - b.volume_mm3) <= part * b.volume_mm3;
}

namespace {

std::string shown(double value) { return fmt::format("{:.3g}", value); }

void scale(OrganModel& organ, double factor) {
  for (double& youngs_kPa : organ.youngs_kPa) youngs_kPa *= factor;
}

// A palpation's terms are of the creep function, a material test's of the relaxation function.
mechanics::Relaxation relaxation_in(const Learnt& effect, bool material_test) {
  const std::vector<double> amplitudes = effect.numbers("amplitude");
  const std::vector<double> times_s = effect.numbers("time_s", amplitudes.size());
  mechanics::Relaxation relaxation;
  std::vector<mechanics::CreepTerm> creep;
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    if (amplitudes[k] < 0) throw Misfit{"amplitude"};
    if (times_s[k] <= 0) throw Misfit{"time_s"};
    if (amplitudes[k] > 0) relaxation.push_back({amplitudes[k], times_s[k]});
    creep.push_back({amplitudes[k], times_s[k]});
  }
  if (!material_test) relaxation = mechanics::relaxation_of(std::move(creep));
  if (!mechanics::check_relaxation(relaxation)) throw Misfit{"amplitude"};
  return relaxation;
}

void put_in(const Inclusion& inclusion, const geometry::TetMesh& mesh, std::vector<double>& youngs_kPa) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const double edge_mm = mechanics::regular_edge_mm(geometry::cell_volume_mm3(mesh, c));
    double mean = 0;
    for (const mechanics::TetPoint& at : mechanics::tet_points_degree_2()) {
      Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();
      for (int i = 0; i < 4; ++i) {
        place_mm += at.barycentric[i] * mesh.points_mm[static_cast<std::size_t>(mesh.cells[c][std::size_t(i)])];
      }
      mean += at.weight * modulus_factor(inclusion, place_mm, edge_mm);
    }
    youngs_kPa[c] *= mean;
  }
}

// What holds in some directions only, or is a ligament, stays as it is.
bool give_way(mechanics::Support& support, double foundation_kPa_per_mm) {
  if (auto* spring = std::get_if<mechanics::Foundation>(&support.how)) {
    spring->stiffness_kPa_per_mm = 1 / (1 / spring->stiffness_kPa_per_mm + 1 / foundation_kPa_per_mm);
    return true;
  }
  const auto* held = std::get_if<mechanics::Fixed>(&support.how);
  if (held == nullptr || held->directions != std::array<bool, 3>{true, true, true}) return false;
  support.how = mechanics::Foundation{foundation_kPa_per_mm};
  return true;
}

// A support names whole faces: those of a ball that names any, with springs as stiff in all as the attachment's.
// Nothing where it is nowhere near the surface.
std::optional<mechanics::Support> support_of(const Attachment& attachment, const geometry::TetMesh& mesh) {
  const auto boundary =
      mechanics::boundary_faces(mesh, mechanics::lay_out_nodes(mesh, mechanics::ElementOrder::linear));
  const double held_mm2 = held_area_mm2(mesh, boundary, attachment.patch);
  const auto reach_mm = [&](const mechanics::BoundaryFace& face) {
    double farthest_mm = 0;
    for (const int point : face.points)
      farthest_mm =
          std::max(farthest_mm, (mesh.points_mm[static_cast<std::size_t>(point)] - attachment.patch.center_mm).norm());
    return farthest_mm;
  };
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const mechanics::BoundaryFace& face : boundary) nearest_mm = std::min(nearest_mm, reach_mm(face));
  constexpr double whole = 1.001;  // no point is lost to rounding
  const mechanics::Ball ball{attachment.patch.center_mm, std::max(attachment.patch.radius_mm, whole * nearest_mm)};
  double named_mm2 = 0;
  for (const mechanics::BoundaryFace& face : boundary)
    if (reach_mm(face) <= ball.radius_mm) named_mm2 += face.area_mm2;
  const double foundation_kPa_per_mm = attachment.foundation_kPa_per_mm * held_mm2 / named_mm2;
  if (!(foundation_kPa_per_mm > 1e-3 * attachment.foundation_kPa_per_mm)) return std::nullopt;
  return mechanics::Support{ball, mechanics::Foundation{foundation_kPa_per_mm}};
}

void put_skin_on(double stiffness_mN_per_mm, std::optional<mechanics::Capsule>& capsule) {
  if (!capsule) capsule.emplace();
  capsule->thickness_mm += stiffness_mN_per_mm / capsule->youngs_modulus_kPa;
}

LearntEffect carried(const Learnt& effect, std::string text, std::vector<std::string> arguments) {
  return {effect.kind, true, {std::move(text), std::move(arguments)}};
}
LearntEffect left_out(const Learnt& effect, std::string text, std::vector<std::string> arguments = {}) {
  return {effect.kind, false, {std::move(text), std::move(arguments)}};
}

// Nominal stress per Young's modulus of a bar by that stretch: state.h's laws and stretch.h's, incompressible.
double found_stress(const Learnt& effect, double stretch) {
  const double strain = stretch - 1, neo_hookean = (stretch - 1 / (stretch * stretch)) / 3;
  if (effect.form == palpation::form_ogden) {
    const double a = effect.above_zero("exponent");
    return 2 / (3 * a) * (std::pow(stretch, a - 1) - std::pow(stretch, -a / 2 - 1));
  }
  const double b = effect.number("coefficient");
  if (b < 0) throw Misfit{"coefficient"};
  if (effect.form == palpation::form_yeoh) {
    return neo_hookean * (1 + b * (stretch * stretch + 2 / stretch - 3));
  }
  return strain * (effect.form == palpation::form_linear ? 1 + b * std::abs(strain) : std::exp(b * strain * strain));
}

// The same of Veronda and Westmann's law: 2 (l - l^-2) (dw/dI1 + dw/dI2 / l).
double veronda_westmann_stress(double c2, double stretch) {
  return 2.0 / 3 * (stretch - 1 / (stretch * stretch)) *
         (std::exp(c2 * (stretch * stretch + 2 / stretch - 3)) - 1 / (2 * stretch));
}

// Where a bar that is pressed by a fifth resists alike: a palpation presses. Nothing where even the softest resists
// more.
std::optional<double> equally_stiffening(const Learnt& effect) {
  constexpr double pressed = 0.8, stiffest = 100;
  const double found = found_stress(effect, pressed);
  const auto lacks = [&](double c2) { return veronda_westmann_stress(c2, pressed) > found; };  // both below zero
  if (!lacks(0)) return {};
  double below = 0, above = stiffest;
  for (int halving = 0; halving < 60; ++halving) (lacks((below + above) / 2) ? below : above) = (below + above) / 2;
  return above;
}

LearntEffect stiffening(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  const std::optional<double> c2 = about.material_test ? std::nullopt : equally_stiffening(effect);
  if (!c2) return left_out(effect, GLISSON_TEXT("That the specimen stiffens with strain is not carried to the organ."));
  organ.strain_stiffening = c2;
  return carried(
      effect,
      GLISSON_TEXT("With large deformations the organ stiffens as it is strained (Veronda and Westmann's law, "
                   "strain_stiffening {0}); with small ones it does not."),
      {shown(*c2)});
}

LearntEffect relaxing(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  mechanics::Relaxation relaxation = relaxation_in(effect, about.material_test);
  const double left = mechanics::long_term_share(relaxation);
  std::string times_s;
  for (const auto& term : relaxation) times_s += (times_s.empty() ? "" : ", ") + shown(term.time_s);
  scale(organ, left / mechanics::long_term_share(organ.relaxation));
  organ.relaxation = std::move(relaxation);
  return carried(effect,
                 GLISSON_TEXT("Held for long, the organ creeps: it is {0} times as stiff as at once. In motion it "
                              "relaxes on the way there, with times of {1} s."),
                 {shown(left), times_s});
}

LearntEffect preloaded(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  if (!about.same_organ) {
    return left_out(effect, GLISSON_TEXT("What loaded the specimen while it was measured does not load the organ."));
  }
  if (effect.form == palpation::form_pressure) {
    const double pressure_kPa = effect.number("pressure_kPa");
    organ.standing_loads.emplace_back(mechanics::PressureLoad{pressure_kPa});
    return carried(effect, GLISSON_TEXT("A pressure of {0} kPa acts on the organ all the time."),
                   {shown(pressure_kPa)});
  }
  const Eigen::Vector3d gravity_m_s2 = effect.vector("gravity_m_s2");
  organ.standing_loads.emplace_back(mechanics::GravityLoad{units::mm_s2_from_m_s2(1.0) * gravity_m_s2});
  return carried(effect, GLISSON_TEXT("A weight acts on the organ all the time, by ({0}, {1}, {2}) m/s2."),
                 {shown(gravity_m_s2.x()), shown(gravity_m_s2.y()), shown(gravity_m_s2.z())});
}

LearntEffect anisotropic(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  const mechanics::TransverseIsotropy anisotropy{
      anisotropy_law(effect.form), effect.vector("axis"), effect.above_zero("ratio"),
      effect.form == palpation::form_three_moduli ? effect.above_zero("shear_ratio") : 1.0};
  if (!mechanics::check_anisotropy(anisotropy, mechanics::Scenario{}.poisson_ratio)) throw Misfit{"ratio"};
  organ.anisotropy = anisotropy;
  const Eigen::Vector3d axis = anisotropy.axis.normalized();
  const std::vector<std::string> arguments{shown(anisotropy.ratio), shown(axis.x()), shown(axis.y()), shown(axis.z())};
  return about.same_organ
             ? carried(effect, GLISSON_TEXT("The organ is {0} times as stiff along ({1}, {2}, {3}) as across."),
                       arguments)
             : carried(effect,
                       GLISSON_TEXT("The organ is {0} times as stiff along ({1}, {2}, {3}) as across: the specimen's "
                                    "axes are taken for the patient's."),
                       arguments);
}

LearntEffect attached(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  const Attachment attachment{{effect.vector("center_mm"), effect.above_zero("radius_mm")},
                              effect.above_zero("foundation_kPa_per_mm")};
  const auto support = about.same_organ ? support_of(attachment, about.mesh) : std::nullopt;
  if (!support) {
    return left_out(effect, GLISSON_TEXT("What held the specimen has no place on the organ's surface: the specimen is "
                                         "not this organ in this place."));
  }
  organ.supports.push_back(*support);
  const Eigen::Vector3d& center_mm = attachment.patch.center_mm;
  return carried(
      effect, GLISSON_TEXT("Around ({0}, {1}, {2}) the surface is held within {3} mm by springs of {4} kPa/mm."),
      {fmt::format("{:.0f}", center_mm.x()), fmt::format("{:.0f}", center_mm.y()), fmt::format("{:.0f}", center_mm.z()),
       shown(attachment.patch.radius_mm), shown(attachment.foundation_kPa_per_mm)});
}

LearntEffect loosened(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  const double left_kPa_per_mm = effect.above_zero("left_kPa_per_mm");
  for (std::size_t s = 0; s < about.supports && about.same_organ; ++s) {
    const auto* named = std::get_if<mechanics::NamedPoints>(&organ.supports[s].where);
    if (named == nullptr || named->point_array != effect.form) continue;
    if (!give_way(organ.supports[s], left_kPa_per_mm)) continue;
    return carried(effect, GLISSON_TEXT("What is declared to hold the organ at {0} holds it with {1} kPa/mm alone."),
                   {effect.form, shown(left_kPa_per_mm)});
  }
  return left_out(effect, GLISSON_TEXT("The organ has no support {0} that could hold less."), {effect.form});
}

LearntEffect take(const Learnt& effect, const Circumstances& about, OrganModel& organ) {
  if (effect.kind == palpation::stiffness_scale) {
    const double factor = effect.above_zero("factor");
    scale(organ, factor);
    return carried(effect, GLISSON_TEXT("The whole organ is {0} times as stiff as was declared."), {shown(factor)});
  }
  if (effect.kind == palpation::viscoelastic_creep) {
    return relaxing(effect, about, organ);
  }
  if (effect.kind == palpation::stiff_inclusion) {
    const Inclusion inclusion{{effect.vector("center_mm"), effect.above_zero("radius_mm")}, effect.above_zero("ratio")};
    if (!about.same_organ) {
      return left_out(effect, GLISSON_TEXT("The specimen's hard spot has no place in the organ: the specimen is not "
                                           "this organ in this place."));
    }
    put_in(inclusion, about.mesh, organ.youngs_kPa);
    return carried(effect,
                   GLISSON_TEXT("A spot of {0} mm radius at ({1}, {2}, {3}) is {4} times as stiff as around it."),
                   {shown(inclusion.ball.radius_mm), fmt::format("{:.0f}", inclusion.ball.center_mm.x()),
                    fmt::format("{:.0f}", inclusion.ball.center_mm.y()),
                    fmt::format("{:.0f}", inclusion.ball.center_mm.z()), shown(inclusion.ratio)});
  }
  if (effect.kind == palpation::support_compliance && effect.form == palpation::form_layer) {
    return left_out(effect,
                    GLISSON_TEXT("What holds the specimen gives way otherwise along its surface than across it; "
                                 "the rehearsal knows springs that are alike in all directions alone."));
  }
  if (effect.kind == palpation::support_compliance) {
    const double foundation_kPa_per_mm = effect.above_zero("foundation_kPa_per_mm");
    for (std::size_t s = 0; s < about.supports; ++s) give_way(organ.supports[s], foundation_kPa_per_mm);
    return carried(effect, GLISSON_TEXT("What holds the organ gives way like a spring of {0} kPa/mm."),
                   {shown(foundation_kPa_per_mm)});
  }
  if (effect.kind == palpation::undeclared_attachment) return attached(effect, about, organ);
  if (effect.kind == palpation::missing_attachment) return loosened(effect, about, organ);
  if (effect.kind == palpation::capsule) {
    const double stiffness_N_per_mm = effect.number("stiffness_N_per_mm");
    if (stiffness_N_per_mm < 0) throw Misfit{"stiffness_N_per_mm"};
    put_skin_on(units::mN_from_N(stiffness_N_per_mm), organ.capsule);
    return carried(effect, GLISSON_TEXT("A skin of {0} N/mm lies around the organ."), {shown(stiffness_N_per_mm)});
  }
  if (effect.kind == palpation::anisotropy) return anisotropic(effect, about, organ);
  if (effect.kind == palpation::strain_stiffening) return stiffening(effect, about, organ);
  if (effect.kind == palpation::preload) return preloaded(effect, about, organ);
  if (effect.kind == palpation::force_bias) {
    return left_out(effect, GLISSON_TEXT("The load cell was off: that is of the measurement, and leaves the organ as "
                                         "it is."));
  }
  if (effect.kind == palpation::frame_misalignment) {
    return left_out(effect, GLISSON_TEXT("The camera's frame was off: that is of the measurement, and leaves the organ "
                                         "as it is."));
  }
  return left_out(effect, GLISSON_TEXT("This linear rehearsal cannot hold the effect {0}."), {effect.kind});
}

std::vector<Sentence> remarks_on(const Json& document) {
  std::vector<Sentence> remarks;
  if (document.contains("smooth_correction")) {
    remarks.push_back({GLISSON_TEXT("A smooth correction has no cause and is left out of the rehearsal."), {}});
  }
  if (document.value("verdict", std::string()) == "unexplained") {
    remarks.push_back({GLISSON_TEXT("These measurements are not explained by the effects found: they take a part of "
                                    "the error away, and are no proof of a cause."),
                       {}});
  }
  return remarks;
}

SpecimenPlace place_from(const Json& json) {
  const auto corner = [&](const char* name) {
    const auto values = json.at(name).get<std::array<double, 3>>();
    return Eigen::Vector3d(values[0], values[1], values[2]);
  };
  return {corner("min_mm"), corner("max_mm"), json.at("volume_mm3").get<double>()};
}

Failure not_complete(const std::filesystem::path& file) {
  return failure(
      Error{"model-invalid", GLISSON_TEXT("{0} is not a complete model."), {file.filename().string()}, {}, file});
}

}  // namespace
}  // namespace glisson::closedloop
