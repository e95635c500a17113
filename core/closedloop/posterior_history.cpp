#include "closedloop/posterior_history.h"

#include <algorithm>
#include <utility>

#include "base/json.h"
#include "closedloop/inference/posterior.h"

namespace glisson::closedloop {
namespace {

PosteriorHistory read_history(const std::filesystem::path& report);
bool are_among(const std::vector<std::string>& trials, const std::vector<std::string>& all);

}  // namespace

PosteriorHistory history_after(const std::filesystem::path& earlier_report, const Explanation& explanation,
                               const Observations& observations) {
  PosteriorHistory history = read_history(earlier_report);
  std::erase_if(history, [&](const PosteriorStep& step) {
    return step.trials.size() >= observations.trials.size() || !are_among(step.trials, observations.trials);
  });
  PosteriorStep now{observations.trials, explanation.posterior};
  for (WeighedExplanation& one : now.posterior) one.fit = {};
  history.push_back(std::move(now));
  return history;
}

Json json_of(const Posterior& posterior) {
  Json json = Json::array();
  for (const WeighedExplanation& one : posterior) {
    json.push_back({{"name", name_of(one)},
                    {"kinds", one.something_else ? Json(nullptr) : Json(one.kinds)},
                    {"probability", one.probability}});
    if (one.beside > 0) json.back()["beside"] = one.beside;
  }
  return json;
}

Json json_of(const PosteriorHistory& history) {
  Json json = Json::array();
  for (const PosteriorStep& step : history) {
    json.push_back({{"trials", step.trials}, {"explanations", json_of(step.posterior)}});
  }
  return json;
}

namespace {

// Nothing where the file is not there or is not what json_of wrote.
PosteriorHistory read_history(const std::filesystem::path& report) {
  const auto json = read_json_file(report);
  if (!json || !json->is_object() || !json->contains("history")) return {};
  PosteriorHistory history;
  try {
    for (const Json& step : json->at("history")) {
      PosteriorStep read{step.at("trials").get<std::vector<std::string>>(), {}};
      for (const Json& one : step.at("explanations")) {
        const Json& kinds = one.at("kinds");
        read.posterior.push_back({kinds.is_null() ? std::vector<std::string>{} : kinds.get<std::vector<std::string>>(),
                                  kinds.is_null(), one.at("probability").get<double>()});
      }
      history.push_back(std::move(read));
    }
  } catch (const Json::exception&) {
    return {};
  }
  return history;
}

bool are_among(const std::vector<std::string>& trials, const std::vector<std::string>& all) {
  return std::all_of(trials.begin(), trials.end(),
                     [&](const std::string& id) { return std::count(all.begin(), all.end(), id) > 0; });
}

}  // namespace
}  // namespace glisson::closedloop
