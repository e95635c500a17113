#include "closedloop/next_trials_file.h"

#include <utility>

#include "base/json_reading.h"
#include "closedloop/explanation_file.h"

namespace glisson::closedloop {

Json next_trials_json(const NextTrials& next, const Experiment& experiment) {
  Json json{{"format", "glisson-next-trials/1"},
            {"kind", kind_of(experiment)},
            {"title", experiment.title},
            {"trials", Json::array()}};
  for (const NextMeasurement& trial : next.to_make)
    json["trials"].push_back({{"sentence", trial.sentence.message()},
                              {"tells_apart", trial.alternatives},
                              {"doubt_removed", trial.doubt_removed},
                              {"trial", *trial.conditions}});
  json["possible"] = Json::array();
  for (const PossibleTrial& possible : next.possible) {
    Json separations = Json::array();
    for (const auto& [kinds, noises] : possible.separations)
      separations.push_back({{"kinds", kinds}, {"noises", noises}});
    json["possible"].push_back({{"sentence", possible.sentence.message()},
                                {"doubt_removed", possible.doubt_removed},
                                {"separations", std::move(separations)},
                                {"trial", *possible.conditions}});
  }
  return null_where_not_finite(std::move(json));
}

}  // namespace glisson::closedloop
