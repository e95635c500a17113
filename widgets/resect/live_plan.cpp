#include "widgets/resect/live_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "casefile/vascular.h"
#include "meshing/mask_surface.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

// A smooth surface around what is wanted of an image, seen on about two millimetres: enough for a picture.
template <typename Value, typename Wanted>
std::shared_ptr<const geometry::Surface> surface_of(const imaging::Image<Value>& image, const Wanted& wanted) {
  constexpr double apart_mm = 2;
  const imaging::Grid& grid = image.grid;
  imaging::Mask coarse;
  coarse.grid = grid;
  std::array<int, 3> step{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    step[a] = std::max(1, static_cast<int>(std::lround(apart_mm / grid.spacing_mm[axis])));
    coarse.grid.size[a] = (grid.size[a] + step[a] - 1) / step[a];
    coarse.grid.spacing_mm[axis] *= step[a];
  }
  coarse.values.reserve(coarse.grid.voxels());
  for (int k = 0; k < coarse.grid.size[2]; ++k) {
    for (int j = 0; j < coarse.grid.size[1]; ++j) {
      for (int i = 0; i < coarse.grid.size[0]; ++i) {
        coarse.values.push_back(wanted(image.at(i * step[0], j * step[1], k * step[2])) ? 1 : 0);
      }
    }
  }
  auto surface = meshing::mask_surface(coarse, meshing::organ_smoothing);
  return surface ? std::make_shared<const geometry::Surface>(std::move(*surface)) : nullptr;
}

// By name, those that surgeons name: a branch of a segment counted "2" has none of its own.
std::vector<NamedTerritory> named_territories(const planning::Planner& planner) {
  std::map<std::string, double> ml;
  const auto tissue = planner.branches();
  for (std::size_t b = 0; b < tissue.size(); ++b) {
    const std::string& name = planner.trees().branches[b].name;
    for (std::size_t from = name.find('/'); from != std::string::npos;) {
      const std::size_t to = name.find('/', from + 1);
      const std::string part = name.substr(from + 1, to - from - 1);
      const bool has_name = !part.empty() && part != "stem" && part.find_first_of("0123456789") == std::string::npos;
      if (!has_name) break;
      ml[name.substr(0, to)] += tissue[b].ml;
      from = to;
    }
  }
  std::vector<NamedTerritory> named;
  for (const auto& [branch, volume_ml] : ml) {
    if (volume_ml >= 1) named.push_back({branch, volume_ml});
  }
  return named;
}

// Of each tumour the smallest portal territory that takes all of it.
std::map<std::string, std::string> territories_around(const planning::Planner& planner,
                                                      std::vector<NamedTerritory> territories) {
  std::map<std::string, std::string> around;
  std::sort(territories.begin(), territories.end(),
            [](const NamedTerritory& a, const NamedTerritory& b) { return a.ml < b.ml; });
  for (const NamedTerritory& territory : territories) {
    if (around.size() == planner.tumours().size()) break;
    if (territory.branch.rfind("portal/", 0) != 0) continue;
    const auto answer = planner.answer({planning::TerritoryCut{territory.branch}});
    if (!answer) continue;
    for (const planning::MarginAnswer& tumour : answer->tumours) {
      if (tumour.side == planning::Side::removed) around.try_emplace(tumour.tumour, territory.branch);
    }
  }
  return around;
}

Result<std::shared_ptr<const OpenedAnatomy>> opened_anatomy(const std::filesystem::path& folder) {
  using casefile::SegmentsBy;
  const auto patient = casefile::Case::open(folder);
  if (!patient) return failure(patient.error());
  casefile::FoundTerritories found;
  const bool has_trees = patient->find(casefile::trees_id) != nullptr;
  const SegmentsBy by = has_trees ? SegmentsBy::trees : SegmentsBy::shape;
  if (has_trees || casefile::kept_territories(*patient, by) == casefile::Kept::current) {
    auto read = casefile::territories_in(*patient, by);
    if (!read) return failure(std::move(read.error()));
    found = std::move(*read);
  }
  auto opened = casefile::open_planner(*patient, found);
  if (!opened) return failure(std::move(opened.error()));
  auto anatomy = std::make_shared<OpenedAnatomy>(OpenedAnatomy{std::move(opened->planner),
                                                               std::move(opened->remarks),
                                                               false,
                                                               has_trees,
                                                               casefile::told_in(*patient),
                                                               {},
                                                               {},
                                                               {},
                                                               {}});
  anatomy->territories = named_territories(anatomy->planner);
  anatomy->territory_around = territories_around(anatomy->planner, anatomy->territories);
  const imaging::LabelMap& segments = found.couinaud.segment;
  anatomy->has_segments = !segments.values.empty();
  anatomy->borders = vasculature::drawn_borders(segments);
  for (std::size_t s = 1; s <= 8 && anatomy->has_segments; ++s) {
    anatomy->segments[s] = surface_of(segments, [s](std::uint16_t value) { return value == s; });
  }
  return anatomy;
}

bool is_a_surface(const planning::Cut& cut) {
  return std::holds_alternative<planning::PlaneCut>(cut) || std::holds_alternative<planning::SheetCut>(cut);
}

Result<std::shared_ptr<const LivePlanResult>> answered(const OpenedAnatomy& anatomy,
                                                       const std::vector<planning::Cut>& cuts, bool unrolling,
                                                       const std::optional<Embolisation>& embolisation) {
  using planning::Planner;
  auto answer = unrolling ? anatomy.planner.answer_unrolled(cuts)
                          : anatomy.planner.answer(cuts).map([](const planning::PlanAnswer& plain) {
                              return Planner::Unrolled{plain, {}};
                            });
  if (!answer) return failure(std::move(answer.error()));
  auto result = std::make_shared<LivePlanResult>(
      LivePlanResult{cuts, std::move(answer->answer), {}, {}, std::move(answer->resectograms), {}, {}});
  if (embolisation) {
    const auto stages =
        planning::two_stages(anatomy.planner, {embolisation->branch}, cuts, embolisation->growth_percent);
    if (stages)
      result->stages = *stages;
    else
      result->stages_problem = stages.error();
  }
  if (cuts.size() == 1 && is_a_surface(cuts.front())) return result;
  const auto parts = anatomy.planner.parts(cuts);
  if (!parts) return failure(parts.error());
  result->removed = surface_of(*parts, [](std::uint8_t part) { return part == 2; });
  result->left = surface_of(*parts, [](std::uint8_t part) { return part == 1; });
  return result;
}

}  // namespace

LivePlan::LivePlan(QObject* parent) : QObject(parent) {}

void LivePlan::open(const std::filesystem::path& case_folder) {
  const int opening = ++openings_;
  if (case_folder != folder_ || case_folder.empty()) {
    folder_ = case_folder;
    anatomy_.reset();
    result_.reset();
    kept_.clear();
  }
  problem_.reset();
  opening_ = !folder_.empty();
  Q_EMIT opened();
  Q_EMIT changed();
  Q_EMIT kept_changed();
  if (!opening_) return;
  run_in_background(
      this, [folder = folder_] { return opened_anatomy(folder); },
      [this, opening](const Result<std::shared_ptr<const OpenedAnatomy>>& anatomy) {
        if (opening != openings_) return;
        opening_ = false;
        anatomy_ = anatomy.value_or(nullptr);
        problem_ = anatomy ? std::nullopt : std::optional(anatomy.error());
        Q_EMIT opened();
        set_cuts(wanted_);
        read_kept();
      });
}

void LivePlan::set_cuts(const std::vector<planning::Cut>& cuts) {
  ++asked_;
  wanted_ = cuts;
  if (wanted_.empty()) {
    result_.reset();
    if (anatomy_) problem_.reset();
    Q_EMIT changed();
    return;
  }
  compute();
}

void LivePlan::set_unrolling(bool unrolling) {
  if (std::exchange(unrolling_, unrolling) == unrolling || !unrolling) return;
  ++asked_;
  compute();
}

void LivePlan::set_embolisation(const std::optional<Embolisation>& embolisation) {
  embolisation_ = embolisation;
  ++asked_;
  compute();
}

void LivePlan::compute() {
  if (computing_ || wanted_.empty() || !anatomy_) return;
  computing_ = true;
  run_in_background(
      this,
      [anatomy = anatomy_, cuts = wanted_, unrolling = unrolling_, embolisation = embolisation_] {
        return answered(*anatomy, cuts, unrolling, embolisation);
      },
      [this, asked = asked_, opening = openings_](const Result<std::shared_ptr<const LivePlanResult>>& result) {
        computing_ = false;
        if (asked != asked_) compute();
        // An answer to a cut that has moved on is shown all the same, unless there is none any more: it keeps pace.
        if (wanted_.empty() || opening != openings_) return;
        result_ = result.value_or(nullptr);
        problem_ = result ? std::nullopt : std::optional(result.error());
        Q_EMIT changed();
      });
}

void LivePlan::read_kept() {
  if (folder_.empty() || !anatomy_) return;
  run_in_background(
      this,
      [folder = folder_, anatomy = anatomy_] {
        std::vector<KeptPlanAnswer> answers;
        const auto patient = casefile::Case::open(folder);
        const auto plans = patient ? casefile::kept_plans(*patient) : failure(patient.error());
        if (!plans) return answers;
        for (const casefile::KeptPlan& kept : *plans) {
          auto answer = anatomy->planner.answer(kept.plan.cuts);
          answers.push_back({kept, {}, {}, casefile::is_followed(*patient, kept.plan)});
          if (answer) {
            answers.back().answer = std::move(*answer);
          } else {
            answers.back().problem = answer.error();
          }
        }
        return answers;
      },
      [this, opening = openings_](const std::vector<KeptPlanAnswer>& answers) {
        if (opening != openings_) return;
        kept_ = answers;
        Q_EMIT kept_changed();
      });
}

}  // namespace glisson::widgets
