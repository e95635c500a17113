#pragma once
// Clicks on vessels, and borders that a hand set, as Python gives them: (vessel or border, place) each.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "choices.h"
#include "vasculature/systems.h"

namespace glisson::python {

using NamedPlaces = std::vector<std::pair<std::string, Numbers>>;

// The main stems first, as far as they are given. Failure: "choice-unknown".
inline vasculature::Clicks clicks_from(const std::optional<Numbers>& portal_mm,
                                       const std::optional<Numbers>& hepatic_mm, const NamedPlaces& named) {
  using vasculature::Vessel;
  vasculature::Clicks clicks;
  if (portal_mm) clicks.push_back({Vessel::portal_vein, vector_from(*portal_mm, "portal_mm")});
  if (hepatic_mm) clicks.push_back({Vessel::hepatic_vein, vector_from(*hepatic_mm, "hepatic_mm")});
  std::vector<std::pair<const char*, Vessel>> choices;
  for (const Vessel vessel : vasculature::all_vessels) choices.emplace_back(vasculature::vessel_name(vessel), vessel);
  for (const auto& [name, place] : named) {
    clicks.push_back({chosen<Vessel>("clicks", name, choices), vector_from(place, "clicks")});
  }
  return clicks;
}

// Failure: "choice-unknown".
inline vasculature::BorderPlaces borders_from(const NamedPlaces& named) {
  vasculature::BorderPlaces borders;
  for (const auto& [name, place] : named) {
    const auto segments = vasculature::border_named(name);
    if (!segments)
      raise("choice-unknown", "{0} cannot be \"{1}\".", {"borders", name},
            "There are " + vasculature::names_of_borders() + ".");
    borders.push_back({*segments, vector_from(place, "borders")});
  }
  return borders;
}

}  // namespace glisson::python
