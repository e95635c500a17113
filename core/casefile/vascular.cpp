#include "casefile/vascular.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include "base/files.h"
#include "casefile/internal/vessel_masks.h"
#include "imaging/segments_file.h"
#include "imaging/volume_file.h"
#include "segmentation/grid_part.h"
#include "vasculature/center_lines.h"
#include "vasculature/territories.h"
#include "vasculature/tree_file.h"

namespace glisson::casefile {
namespace {

using imaging::Mask;
using vasculature::System;
using vasculature::VesselTrees;

constexpr const char* doubt_id = "territories/doubt";
std::string territory_id(System system) { return std::string("territories/") + vasculature::system_name(system); }

// Made of what the case holds now, by this version.
bool is_current(const Case& patient, const std::string& id) {
  return patient.find(id) != nullptr && patient.find(id)->version == version() &&
         patient.freshness(id) == Freshness::current;
}

constexpr const char* from_key = "from";

void add_borders(const vasculature::BorderPlaces& borders, Provenance& made) {
  for (std::size_t n = 0; n < borders.size(); ++n) {
    made.options[fmt::format("border-{}_mm", n + 1)] = vasculature::border_text(borders[n]);
  }
}

Provenance provenance_of(SegmentsBy by, const vasculature::BorderPlaces& borders) {
  Provenance made{"territories", {{from_key, by == SegmentsBy::trees ? "tree" : "prior"}}, {"labels/liver"}, {}, {}};
  if (by == SegmentsBy::trees) made.from.emplace_back(trees_id);
  add_borders(borders, made);
  return made;
}

// Those that segments by the shape alone were told.
vasculature::BorderPlaces borders_kept(const Case& patient) {
  vasculature::BorderPlaces borders;
  const Entry* entry = patient.find(couinaud_id);
  if (entry == nullptr) return borders;
  const auto& options = entry->made.options;
  for (std::size_t n = 1;; ++n) {
    const auto told = options.find(fmt::format("border-{}_mm", n));
    const auto place = told != options.end() ? vasculature::border_of_text(told->second) : std::nullopt;
    if (!place) return borders;
    borders.push_back(*place);
  }
}

// Portal and hepatic veins where each has a structure of its own.
Result<vasculature::LiverAnatomy> known_anatomy(const std::vector<NamedMask>& veins, const Mask& liver,
                                                const vasculature::Told& told, const Progress& progress) {
  std::array<vasculature::VesselGraph, 2> graphs;
  for (std::size_t n = 0; n < 2; ++n) {
    auto graph = vasculature::center_lines(
        veins.at(n).mask, {}, progress.part(0.4 * static_cast<double>(n), 0.4 + 0.4 * static_cast<double>(n)));
    if (!graph) return failure(std::move(graph.error()));
    graphs.at(n) = std::move(*graph);
  }
  for (const vasculature::Click& click : told.clicks) {
    const auto& graph = graphs.at(static_cast<std::size_t>(vasculature::system_of(click.vessel)));
    if (auto on_vessel = vasculature::lie_on_vessels(graph, {click}); !on_vessel) {
      return failure(std::move(on_vessel.error()));
    }
  }
  const auto expected = vasculature::expected_entries(liver);
  if (!expected) return failure(expected.error());
  vasculature::VesselEntries entries = vasculature::possible_entries(graphs[0], *expected, told.clicks, 1).front();
  entries.hepatic_mm = vasculature::possible_entries(graphs[1], *expected, told.clicks, 1).front().hepatic_mm;
  VesselTrees trees = vasculature::known_vessels(graphs[0], graphs[1], entries);
  trees.clicks = told.clicks;
  trees.borders = told.borders;
  auto segments = vasculature::couinaud_segments(liver, &trees, {}, progress.part(0.8, 1));
  if (!segments) return failure(std::move(segments.error()));
  trees.border_doubts = segments->border_doubts;
  return vasculature::LiverAnatomy{std::move(trees), std::move(*segments)};
}

// Of portal and hepatic veins, or of one outline that holds both.
Result<vasculature::LiverAnatomy> anatomy_of(const std::vector<NamedMask>& veins, const Mask& liver,
                                             const vasculature::Told& told, const Progress& progress) {
  if (veins.size() == 2) return known_anatomy(veins, liver, told, progress);
  const auto graph = vasculature::center_lines(veins.front().mask, {}, progress.part(0, 0.5));
  if (!graph) return failure(graph.error());
  return vasculature::explain_vessels(*graph, liver, told, progress.part(0.5, 1));
}

Error no_vessels() {
  return Error{"vessels-missing",
               GLISSON_TEXT("The case has no vessels to make trees of."),
               {},
               GLISSON_TEXT("Mark the structures portal-vein and hepatic-vein, or both as one structure, vessels."),
               {}};
}

// By their names, in colours that differ from one to the next.
std::vector<imaging::SegmentInfo> branch_infos(const VesselTrees& trees, System system) {
  std::vector<imaging::SegmentInfo> infos;
  for (std::size_t b = 0; b < trees.branches.size(); ++b) {
    if (trees.branches[b].system != system) continue;
    constexpr double golden = 0.618033988749895;
    const double turn = static_cast<double>(infos.size()) * golden;
    std::array<double, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) {
      color[c] = 0.55 + 0.4 * std::cos(2 * std::numbers::pi * (turn + static_cast<double>(c) / 3));
    }
    const std::string& name = trees.branches[b].name;
    infos.push_back({name.empty() ? fmt::format("branch {}", b) : name, static_cast<int>(b) + 1, color});
  }
  return infos;
}

// With the trees that the case has, or by the shape alone with none.
Result<FoundTerritories> with_trees(const Case& patient, SegmentsBy by) {
  FoundTerritories found;
  if (by == SegmentsBy::shape) return found;
  if (patient.find(trees_id) == nullptr) {
    return failure(Error{"vessels-missing",
                         GLISSON_TEXT("The case has no vessel trees."),
                         {},
                         GLISSON_TEXT("Find them first (vessels), or take the liver's shape alone (--from prior)."),
                         patient.folder()});
  }
  auto trees = patient.file_of(trees_id).and_then(vasculature::read_trees);
  if (!trees) return failure(std::move(trees.error()));
  found.trees = std::move(*trees);
  return found;
}

// Volumes and confidence follow from the maps.
Result<FoundTerritories> kept_in(const Case& patient, SegmentsBy by) {
  auto with = with_trees(patient, by);
  if (!with) return with;
  FoundTerritories& found = *with;
  vasculature::CouinaudSegments& couinaud = found.couinaud;
  couinaud.from = by == SegmentsBy::trees ? vasculature::SegmentsFrom::trees : vasculature::SegmentsFrom::shape;
  auto segments = patient.file_of(couinaud_id).and_then(imaging::read_labels_file);
  if (!segments) return failure(std::move(segments.error()));
  couinaud.segment = std::move(*segments);
  const auto doubt = patient.volume(doubt_id);
  if (!doubt) return failure(doubt.error());
  couinaud.doubt.assign(doubt->values.begin(), doubt->values.end());
  vasculature::measure(couinaud);
  for (const System system : vasculature::vein_systems) {
    if (by == SegmentsBy::shape || patient.find(territory_id(system)) == nullptr) continue;
    auto territory = patient.file_of(territory_id(system)).and_then(imaging::read_labels_file);
    if (!territory) return failure(std::move(territory.error()));
    found.territory.at(static_cast<std::size_t>(system)) = std::move(*territory);
  }
  return with;
}

Result<FoundTerritories> made_of(const Case& patient, SegmentsBy by, const vasculature::BorderPlaces& borders,
                                 const Progress& progress) {
  auto with = with_trees(patient, by);
  if (!with) return with;
  FoundTerritories& found = *with;
  const auto whole = structure_mask(patient, "liver");
  if (!whole) return failure(whole.error());
  const Mask liver = segmentation::cut_out(*whole, segmentation::part_around(*whole, 1));
  for (const System system : vasculature::vein_systems) {
    const auto& branches = found.trees.branches;
    if (std::none_of(branches.begin(), branches.end(), [&](const auto& b) { return b.system == system; })) continue;
    const auto territories = vasculature::territories_of(found.trees, system, liver);
    if (!territories) return failure(territories.error());
    auto& map = found.territory.at(static_cast<std::size_t>(system)).emplace(imaging::LabelMap{liver.grid, {}});
    for (const std::int32_t branch : territories->branch) map.values.push_back(static_cast<std::uint16_t>(branch + 1));
  }
  auto segments =
      vasculature::couinaud_segments(liver, by == SegmentsBy::trees ? &found.trees : nullptr, borders, progress);
  if (!segments) return failure(std::move(segments.error()));
  found.couinaud = std::move(*segments);
  return with;
}

}  // namespace

std::vector<imaging::SegmentInfo> couinaud_segment_infos() {
  std::vector<imaging::SegmentInfo> infos;
  for (std::size_t n = 1; n <= 8; ++n) {
    infos.push_back(
        {fmt::format("segment {}", vasculature::segment_name(n)), static_cast<int>(n), vasculature::segment_colour(n)});
  }
  return infos;
}

Result<VesselTrees> find_vessels(Case& patient, const std::optional<std::string>& structure,
                                 const vasculature::Told& told, const Progress& progress) {
  const bool apart =
      !structure && patient.find("labels/portal-vein") != nullptr && patient.find("labels/hepatic-vein") != nullptr;
  const std::string name = structure.value_or("vessels");
  if (!apart && patient.find("labels/" + name) == nullptr) return failure(no_vessels());
  const std::vector<std::string> veins =
      apart ? std::vector<std::string>{"portal-vein", "hepatic-vein"} : std::vector{name};
  Provenance made{"vessels", {{"of", fmt::format("{}", fmt::join(veins, ", "))}}, {"labels/liver"}, {}, {}};
  for (const std::string& label : veins) made.from.push_back("labels/" + label);
  std::vector<std::string> beside;
  for (const System system : {System::artery, System::biliary_tract}) {
    for (std::string& label : structures_beside_veins(patient, system)) beside.push_back(std::move(label));
  }
  std::erase(beside, veins.front());
  for (const std::string& label : beside) made.from.push_back("labels/" + label);
  if (!beside.empty()) made.options["beside"] = fmt::format("{}", fmt::join(beside, ", "));
  const vasculature::Clicks& clicks = told.clicks;
  for (std::size_t n = 0; n < clicks.size(); ++n) {
    const Eigen::Vector3d& place = clicks[n].position_mm;
    made.options[fmt::format("click-{}_mm", n + 1)] =
        fmt::format("{}={},{},{}", vasculature::vessel_name(clicks[n].vessel), place.x(), place.y(), place.z());
  }
  add_borders(told.borders, made);
  const Entry* kept = patient.find(trees_id);
  if (kept != nullptr && kept->made.options == made.options && is_current(patient, trees_id)) {
    return patient.file_of(trees_id).and_then(vasculature::read_trees);
  }

  const auto liver = structure_mask(patient, "liver");
  if (!liver) return failure(liver.error());
  std::vector<NamedMask> masks;
  for (const std::string& label : veins) {
    auto mask = vessel_mask(patient, label, *liver);
    if (!mask) return failure(std::move(mask.error()));
    masks.push_back(std::move(*mask));
  }
  if (apart) {
    if (auto held = hold_apart(masks[0], masks[1], patient.folder()); !held) return failure(std::move(held.error()));
  }
  auto anatomy = anatomy_of(masks, *liver, told, progress.part(0, beside.empty() ? 1 : 0.8));
  if (!anatomy) return failure(std::move(anatomy.error()));
  if (auto grown = add_arteries_and_ducts(patient, *liver, masks, *anatomy, progress.part(beside.empty() ? 1 : 0.8, 1));
      !grown) {
    return failure(std::move(grown.error()));
  }
  VesselTrees& trees = anatomy->trees;
  auto added = patient.add(trees_id, ".json", std::move(made),
                           [&](const std::filesystem::path& file) { return vasculature::write_trees(file, trees); });
  if (!added) return failure(std::move(added.error()));
  return std::move(trees);
}

Result<FoundTerritories> find_territories(Case& patient, SegmentsBy by, const vasculature::BorderPlaces& borders,
                                          const Progress& progress) {
  const bool kept = kept_territories(patient, by) == Kept::current &&
                    patient.find(couinaud_id)->made.options == provenance_of(by, borders).options;
  auto found = kept ? kept_in(patient, by) : made_of(patient, by, borders, progress);
  if (!found || kept) return found;
  auto saved = patient.together([&]() -> Result<void> {
    const auto add = [&](const std::string& id,
                         const std::function<Result<void>(const std::filesystem::path&)>& write) {
      return patient.add(id, ".nrrd", provenance_of(by, borders), write);
    };
    const vasculature::CouinaudSegments& couinaud = found->couinaud;
    auto added = add(couinaud_id, [&](const std::filesystem::path& file) {
      return imaging::write_segments_file(file, couinaud.segment, couinaud_segment_infos());
    });
    if (!added) return added;
    added = add(doubt_id, [&](const std::filesystem::path& file) {
      imaging::Volume doubt{{couinaud.segment.grid, {}}, "%"};
      doubt.values.assign(couinaud.doubt.begin(), couinaud.doubt.end());
      return imaging::write_volume_file(file, doubt);
    });
    for (const System system : vasculature::vein_systems) {
      const auto& territory = found->territory.at(static_cast<std::size_t>(system));
      if (!added || by == SegmentsBy::shape) break;
      if (!territory) {
        added = patient.find(territory_id(system)) != nullptr ? patient.remove(territory_id(system)) : added;
        continue;
      }
      added = add(territory_id(system), [&](const std::filesystem::path& file) {
        return imaging::write_segments_file(file, *territory, branch_infos(found->trees, system));
      });
    }
    return added;
  });
  if (!saved) return failure(std::move(saved.error()));
  return found;
}

Kept kept_territories(const Case& patient, SegmentsBy by) {
  const Entry* entry = patient.find(couinaud_id);
  if (entry == nullptr || patient.find(doubt_id) == nullptr) return Kept::no;
  const auto from = entry->made.options.find(from_key);
  if (from == entry->made.options.end() || from->second != provenance_of(by, {}).options.at(from_key)) return Kept::no;
  std::vector<std::string> needed{couinaud_id, doubt_id};
  for (const System system : vasculature::vein_systems) {
    if (by == SegmentsBy::trees && patient.find(territory_id(system)) != nullptr) {
      needed.push_back(territory_id(system));
    }
  }
  return std::all_of(needed.begin(), needed.end(), [&](const std::string& id) { return is_current(patient, id); })
             ? Kept::current
             : Kept::changed;
}

Result<FoundTerritories> territories_in(const Case& patient, SegmentsBy by, const Progress& progress) {
  if (kept_territories(patient, by) == Kept::current) return kept_in(patient, by);
  const bool by_shape = by == SegmentsBy::shape && kept_territories(patient, by) != Kept::no;
  return made_of(patient, by, by_shape ? borders_kept(patient) : vasculature::BorderPlaces(), progress);
}

vasculature::Told told_in(const Case& patient) {
  if (patient.find(trees_id) == nullptr) return {{}, borders_kept(patient)};
  const auto trees = patient.file_of(trees_id).and_then(vasculature::read_trees);
  return trees ? vasculature::Told{trees->clicks, trees->borders} : vasculature::Told();
}

}  // namespace glisson::casefile
