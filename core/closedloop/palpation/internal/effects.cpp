#include "closedloop/palpation/internal/effects.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <optional>

#include "base/units.h"

namespace glisson::closedloop {
namespace {

// What is large and small in an experiment.
struct Sizes {
  Eigen::AlignedBox3d box;
  double extent_mm = 0;  // the shortest side of the box
  double edge_mm = 0;    // of a middling cell
  double youngs_kPa = 0;
  double largest_force_N = 0;
  double shortest_s = std::numeric_limits<double>::infinity();  // between samples
  double longest_s = 0;                                         // of a trial
};
Sizes sizes_of(const Palpation& experiment, const SpecimenBody& specimen);

Effect stiffness_scale();
std::vector<Effect> strain_stiffening();
std::vector<Effect> support_compliance(const Sizes& sizes, const SpecimenBody& specimen);
Effect stiff_inclusion(const Sizes& sizes);
std::vector<Parameter> ball_parameters(const Sizes& sizes, const Eigen::Vector3d& center_mm, double beyond_mm);
Effect undeclared_attachment(const Sizes& sizes, const DeclaredSupports& supports, const Eigen::Vector3d& center_mm);
Effect missing_attachment(const Sizes& sizes, const DeclaredSupports& supports, std::size_t support);
std::optional<Eigen::Vector3d> free_place(const SpecimenBody& specimen);
Effect creep(const Sizes& sizes, int terms);
Effect force_bias(const Sizes& sizes, const Palpation& experiment);
Effect frame_misalignment(const Sizes& sizes);
std::vector<Effect> anisotropy(double poisson_ratio);
Effect capsule(const Sizes& sizes);
std::vector<Effect> preload(const Sizes& sizes);

}  // namespace

std::vector<Effect> palpation_catalogue(const Palpation& experiment, const SpecimenBody& specimen) {
  const Sizes sizes = sizes_of(experiment, specimen);
  std::vector<Effect> catalogue;
  const auto add = [&](std::vector<Effect> effects) {
    catalogue.insert(catalogue.end(), effects.begin(), effects.end());
  };
  add({stiffness_scale()});
  add(strain_stiffening());
  if (specimen.soft) add(support_compliance(sizes, specimen));
  add({stiff_inclusion(sizes)});
  if (sizes.longest_s > 0) add({creep(sizes, 1), creep(sizes, 2)});
  add({force_bias(sizes, experiment), frame_misalignment(sizes)});
  add(anisotropy(experiment.poisson_ratio));
  add({capsule(sizes)});
  add(preload(sizes));
  return catalogue;
}

std::vector<Effect> attachment_effects(const Palpation& experiment, const SpecimenBody& specimen) {
  std::vector<Effect> effects;
  const auto place_mm = specimen.soft ? free_place(specimen) : std::nullopt;
  if (!place_mm) return effects;
  const Sizes sizes = sizes_of(experiment, specimen);
  const DeclaredSupports supports = declared_supports(specimen);
  effects.push_back(undeclared_attachment(sizes, supports, *place_mm));
  for (std::size_t s = 0; s < specimen.soft->fixed_without.size(); ++s) {
    const auto& faces = specimen.soft->faces;
    const bool covers_faces =
        std::any_of(faces.begin(), faces.end(), [&](const auto& face) { return face.support == s; });
    if (covers_faces) effects.push_back(missing_attachment(sizes, supports, s));
  }
  return effects;
}

DeclaredSupports declared_supports(const SpecimenBody& specimen) {
  const auto& moduli = specimen.body.youngs_kPa;
  Eigen::AlignedBox3d box;
  for (const auto& position : specimen.body.layout.positions_mm) box.extend(position);
  const double usual_kPa_per_mm = *std::max_element(moduli.begin(), moduli.end()) / box.sizes().minCoeff();
  DeclaredSupports supports{1e4 * usual_kPa_per_mm, 1e-4 * usual_kPa_per_mm, {}};
  for (const mechanics::Support& support : specimen.body.supports) {
    const auto* named = std::get_if<mechanics::NamedPoints>(&support.where);
    const bool is_new =
        named != nullptr && std::count(supports.names.begin(), supports.names.end(), named->point_array) == 0;
    supports.names.push_back(is_new ? named->point_array : "support-" + std::to_string(supports.names.size() + 1));
  }
  return supports;
}

double untouched_reading_mN(const Palpation& experiment) {
  double sum_mN = 0;
  int count = 0;
  for (const PalpationTrial& trial : experiment.trials) {
    if (trial.samples.empty()) continue;
    double largest_mN = 0;
    for (const PalpationSample& sample : trial.samples) largest_mN = std::max(largest_mN, std::abs(sample.force_mN));
    const PalpationSample& first = trial.samples.front();
    if (!first.markers.empty() && std::abs(first.force_mN) > 0.25 * largest_mN) continue;
    sum_mN += first.force_mN;
    ++count;
  }
  return count > 0 ? sum_mN / count : 0.0;
}

namespace {

Sizes sizes_of(const Palpation& experiment, const SpecimenBody& specimen) {
  Sizes sizes;
  for (const auto& position : specimen.body.layout.positions_mm) sizes.box.extend(position);
  sizes.extent_mm = sizes.box.sizes().minCoeff();
  const auto middling = [](std::vector<double> all) {
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    return all[all.size() / 2];
  };
  sizes.edge_mm = middling(specimen.elements.edge_mm);
  sizes.youngs_kPa = middling(specimen.body.youngs_kPa);
  for (const PalpationTrial& trial : experiment.trials) {
    for (std::size_t s = 0; s < trial.samples.size(); ++s) {
      sizes.largest_force_N = std::max(sizes.largest_force_N, std::abs(units::N_from_mN(trial.samples[s].force_mN)));
      if (s == 0) continue;
      const double gap_s = trial.samples[s].time_s - trial.samples[s - 1].time_s;
      if (gap_s > 0) sizes.shortest_s = std::min(sizes.shortest_s, gap_s);
    }
    if (!trial.samples.empty()) {
      sizes.longest_s = std::max(sizes.longest_s, trial.samples.back().time_s - trial.samples.front().time_s);
    }
  }
  return sizes;
}

Effect stiffness_scale() {
  return {palpation::stiffness_scale,
          "",
          {{"factor", 1, 0.05, 20, 0.5, 2, Scale::logarithmic}},
          GLISSON_TEXT("The whole specimen is stiffer or softer than declared, everywhere by the same factor."),
          {numbers_of({1.1})}};
}

std::vector<Effect> strain_stiffening() {
  const std::string sentence = GLISSON_TEXT(
      "The tissue stiffens the further it is strained: pressing twice as hard dents it less "
      "than twice as deep.");
  const auto form = [&](const std::string& name, const Parameter& coefficient, double start) {
    return Effect{palpation::strain_stiffening, name, {coefficient}, sentence, {numbers_of({start})}};
  };
  // Coefficients that stiffen by a tenth at a tenth of strain are 1 (linear) and 10 (exponential); of Yeoh's law and
  // Ogden's, those of soft tissue and gels.
  std::vector<Effect> effects = {
      form(palpation::form_exponential, {"coefficient", 0, 0, 1000, 0, 50, Scale::linear}, 2),
      form(palpation::form_linear, {"coefficient", 0, 0, 200, 0, 10, Scale::linear}, 1),
      form(palpation::form_yeoh, {"coefficient", 0, 0.01, 100, 0.5, 10, Scale::logarithmic}, 2),
      form(palpation::form_ogden, {"exponent", 0, 1, 40, 4, 20, Scale::logarithmic}, 6)};
  effects[2].late = true;  // Ogden's tells as well whether large strain is it
  return effects;
}

std::vector<Effect> support_compliance(const Sizes& sizes, const SpecimenBody& specimen) {
  const double usual = sizes.youngs_kPa / sizes.extent_mm, held = declared_supports(specimen).fixed_from_kPa_per_mm;
  const auto stiffness = [&](const std::string& name) {
    return Parameter{name, held, 1e-3 * usual, held, 0.1 * usual, 10 * usual, Scale::logarithmic};
  };
  const std::string sentence =
      GLISSON_TEXT("What holds the specimen gives way like a spring: all of it moves a little when it is pressed.");
  Effect spring{
      palpation::support_compliance, "", {stiffness("foundation_kPa_per_mm")}, sentence, {numbers_of({usual})}};
  // A confined layer of foam shears four times as easily as it is pressed together.
  Effect layer{palpation::support_compliance,
               palpation::form_layer,
               {stiffness("foundation_kPa_per_mm"), stiffness("sideways_kPa_per_mm")},
               sentence,
               {numbers_of({usual, 0.25 * usual})}};
  layer.late = true;
  return {std::move(spring), std::move(layer)};
}

// Its centre, in the box or so far beyond it, and a radius.
std::vector<Parameter> ball_parameters(const Sizes& sizes, const Eigen::Vector3d& center_mm, double beyond_mm) {
  std::vector<Parameter> parameters;
  for (int d = 0; d < 3; ++d) {
    const double low = sizes.box.min()[d], high = sizes.box.max()[d];
    parameters.push_back({"center_mm", center_mm[d], low - beyond_mm, high + beyond_mm, low, high, Scale::linear});
  }
  const double smallest = 0.5 * sizes.edge_mm, largest = 0.5 * sizes.extent_mm;
  parameters.push_back({"radius_mm", 0.25 * sizes.extent_mm, std::min(smallest, 0.5 * largest), largest, smallest,
                        largest, Scale::logarithmic});
  return parameters;
}

Effect stiff_inclusion(const Sizes& sizes) {
  const Eigen::Vector3d center = sizes.box.center();
  Effect effect{
      palpation::stiff_inclusion,
      "",
      ball_parameters(sizes, center, 0),
      GLISSON_TEXT("Somewhere inside lies a stiff lump, as a tumour would: around it the specimen moves less."),
      {numbers_of({center[0], center[1], center[2], 0.25 * sizes.extent_mm, 2})}};
  effect.parameters.push_back({"ratio", 1, 0.1, 100, 1, 20, Scale::logarithmic});
  return effect;
}

// From hardly felt to as good as held. The box ends where the surface is: a patch there has room on both sides.
Effect undeclared_attachment(const Sizes& sizes, const DeclaredSupports& supports, const Eigen::Vector3d& center_mm) {
  const double usual = sizes.youngs_kPa / sizes.extent_mm;
  Effect effect{palpation::undeclared_attachment,
                "",
                ball_parameters(sizes, center_mm, 0.5 * sizes.extent_mm),
                GLISSON_TEXT("Something that nobody declared holds a part of the surface, as an adhesion or a ligament "
                             "does: there it moves less."),
                {numbers_of({center_mm[0], center_mm[1], center_mm[2], 0.25 * sizes.extent_mm, usual})}};
  effect.parameters.push_back({"foundation_kPa_per_mm", supports.nothing_to_kPa_per_mm, supports.nothing_to_kPa_per_mm,
                               100 * usual, 0.1 * usual, 10 * usual, Scale::logarithmic});
  return effect;
}

Effect missing_attachment(const Sizes& sizes, const DeclaredSupports& supports, std::size_t support) {
  const double usual = sizes.youngs_kPa / sizes.extent_mm, held = supports.fixed_from_kPa_per_mm;
  Effect effect{palpation::missing_attachment,
                supports.names[support],
                {{"left_kPa_per_mm", held, 1e-3 * usual, held, 1e-3 * usual, 10 * usual, Scale::logarithmic}},
                GLISSON_TEXT("One of the declared attachments holds less than declared, or is not there at all."),
                {numbers_of({usual}), numbers_of({0.01 * usual})}};
  effect.lower_end_may_be = true;
  return effect;
}

// Of the surface that no support holds, what is farthest from what they hold.
std::optional<Eigen::Vector3d> free_place(const SpecimenBody& specimen) {
  const auto& boundary = specimen.body.boundary;
  std::vector<bool> held(boundary.size(), false);
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (const SoftSupports::Face& face : specimen.soft->faces) {
    held[face.face] = true;
    middle_mm += boundary[face.face].centroid_mm / static_cast<double>(specimen.soft->faces.size());
  }
  std::optional<Eigen::Vector3d> farthest;
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    const Eigen::Vector3d& place_mm = boundary[f].centroid_mm;
    if (!held[f] && (!farthest || (place_mm - middle_mm).norm() > (*farthest - middle_mm).norm())) farthest = place_mm;
  }
  return farthest;
}

Effect creep(const Sizes& sizes, int terms) {
  const double shortest = 0.1 * sizes.shortest_s, longest = 10 * sizes.longest_s;
  Effect effect{palpation::viscoelastic_creep,
                terms == 1 ? palpation::form_prony_1 : palpation::form_prony_2,
                {},
                GLISSON_TEXT("The tissue creeps: held under a steady force it goes on giving way for a while."),
                {}};
  for (int i = 0; i < terms; ++i) effect.parameters.push_back({"amplitude", 0, 0, 20, 0, 1, Scale::linear});
  for (int i = 0; i < terms; ++i) {
    effect.parameters.push_back({"time_s", std::sqrt(sizes.shortest_s * sizes.longest_s), shortest, longest,
                                 sizes.shortest_s, sizes.longest_s, Scale::logarithmic});
  }
  // The usual relaxation times of soft tissue are as long as a trial, a good deal shorter, or in between.
  const double fast = sizes.shortest_s, slow = sizes.longest_s, middle = std::sqrt(fast * slow);
  if (terms == 1) {
    effect.starts = {numbers_of({0.2, middle}), numbers_of({0.2, 0.5 * fast}), numbers_of({0.2, slow})};
  } else {
    effect.starts = {numbers_of({0.2, 0.2, fast, slow}), numbers_of({0.2, 0.2, 0.5 * fast, middle})};
  }
  return effect;
}

// The first samples say what the untouched load cell read: the zero cannot be far from there.
Effect force_bias(const Sizes& sizes, const Palpation& experiment) {
  const double untouched_N = units::N_from_mN(untouched_reading_mN(experiment));
  const double known_within_N = std::max(0.01 * sizes.largest_force_N, 1e-6);
  const double low = std::min(0.0, untouched_N - known_within_N), high = std::max(0.0, untouched_N + known_within_N);
  return {
      palpation::force_bias,
      "",
      {{"zero_N", 0, low, high, -0.1 * sizes.largest_force_N, 0.1 * sizes.largest_force_N, Scale::linear},
       {"gain", 1, 0.1, 10, 0.7, 1.4, Scale::logarithmic}},
      GLISSON_TEXT("The load cell is off: it does not read zero when untouched, or it reads too much or too little."),
      {numbers_of({untouched_N, 1.05})}};
}

Effect frame_misalignment(const Sizes& sizes) {
  Effect effect{
      palpation::frame_misalignment,
      "",
      {},
      GLISSON_TEXT("The camera's coordinates do not match the specimen's: all markers seem shifted or turned alike."),
      {Eigen::VectorXd::Zero(6)}};
  // Cameras are registered to some 2 mm and 3 degrees, which turn about the origin of coordinates.
  constexpr double usual_mm = 2, usual_deg = 3;
  const double far_mm = sizes.box.sizes().norm() + 0.4 * sizes.box.center().norm();
  const double expected_mm = usual_mm + usual_deg * std::numbers::pi / 180 * sizes.box.center().norm();
  for (int d = 0; d < 3; ++d)
    effect.parameters.push_back({"rotation_deg", 0, -20, 20, -usual_deg, usual_deg, Scale::linear});
  for (int d = 0; d < 3; ++d)
    effect.parameters.push_back({"translation_mm", 0, -far_mm, far_mm, -expected_mm, expected_mm, Scale::linear});
  return effect;
}

std::vector<Effect> anisotropy(double poisson_ratio) {
  const double definite_above = (4 * poisson_ratio - 1) / (2 - 2 * poisson_ratio);
  std::vector<Effect> effects;
  for (const std::string& form : {palpation::form_fibres, palpation::form_engineering}) {
    const double lowest = form == palpation::form_fibres ? 0.1 : std::min(0.95, std::max(0.1, 1.05 * definite_above));
    effects.push_back(
        {palpation::anisotropy,
         form,
         {{"axis", 0, -2, 2, -1, 1, Scale::linear},
          {"axis", 0, -2, 2, -1, 1, Scale::linear},
          {"axis", 1, -2, 2, -1, 1, Scale::linear},
          {"ratio", 1, lowest, 20, 0.5, 4, Scale::logarithmic}},
         GLISSON_TEXT("The tissue has fibres: it is stiffer (or softer) along one direction than across it."),
         {numbers_of({1, 0, 0, 1.3}), numbers_of({0, 1, 0, 1.3}), numbers_of({0, 0, 1, 1.3})},
         form == palpation::form_engineering});
  }
  Effect sheared = effects.back();
  sheared.form = palpation::form_three_moduli;
  sheared.parameters.push_back({"shear_ratio", 1, 0.1, 10, 0.5, 2, Scale::logarithmic});
  for (Eigen::VectorXd& start : sheared.starts) {
    start.conservativeResize(5);
    start[4] = 1.1;
  }
  effects.push_back(std::move(sheared));
  return effects;
}

Effect capsule(const Sizes& sizes) {
  const double usual = units::N_from_mN(sizes.youngs_kPa * sizes.extent_mm);
  return {palpation::capsule,
          "",
          {{"stiffness_N_per_mm", 0, 0, 50 * usual, 0, usual, Scale::linear}},
          GLISSON_TEXT("A skin around the specimen (as Glisson's capsule around the liver) carries part of the load."),
          {numbers_of({0.05 * usual})}};
}

std::vector<Effect> preload(const Sizes& sizes) {
  const std::string sentence = GLISSON_TEXT(
      "Something else loaded the specimen while it was measured, and not when its shape was "
      "taken: its weight, or a pressure around it.");
  return {{palpation::preload,
           palpation::form_pressure,
           {{"pressure_kPa", 0, -0.5 * sizes.youngs_kPa, 0.5 * sizes.youngs_kPa, -0.1 * sizes.youngs_kPa,
             0.1 * sizes.youngs_kPa, Scale::linear}},
           sentence,
           {numbers_of({0})}},
          {palpation::preload,
           palpation::form_gravity,
           {{"gravity_m_s2", 0, -30, 30, -10, 10, Scale::linear},
            {"gravity_m_s2", 0, -30, 30, -10, 10, Scale::linear},
            {"gravity_m_s2", 0, -30, 30, -10, 10, Scale::linear}},
           sentence,
           {Eigen::VectorXd::Zero(3)}}};
}

}  // namespace
}  // namespace glisson::closedloop
