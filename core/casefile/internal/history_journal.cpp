#include "casefile/internal/history_journal.h"

#include <algorithm>
#include <cctype>

#include "base/files.h"
#include "casefile/internal/entry_record.h"

namespace glisson::casefile {
namespace {

constexpr const char* history_format = "glisson-history/1";

constexpr const char* name_of(Side side) { return side == Side::before ? "before" : "after"; }

}  // namespace

Json json_of(const Listing& listing) {
  Json json{{"format", history_format}, {"done", listing.done}, {"next", listing.next}};
  if (listing.moving) json["moving"] = Json{{"step", listing.moving->first}, {"to", name_of(listing.moving->second)}};
  if (listing.forgotten) json["forgotten"] = true;
  json["values"] = Json::object();
  for (const auto& [key, value] : listing.values) json["values"][key] = value;
  json["steps"] = Json::array();
  for (const Step& step : listing.steps) {
    Json one{{"number", step.number}, {"name", json_of(step.name)}};
    if (!step.kept.empty()) one["kept"] = step.kept;
    for (const ValueChange& value : step.values) {
      one["values"].push_back(Json{{"key", value.key}, {"before", value.before}, {"after", value.after}});
    }
    for (const FileChange& file : step.followed) {
      one["followed"].push_back(Json{{"file", file.file}, {"before", file.before}, {"after", file.after}});
    }
    json["steps"].push_back(std::move(one));
  }
  return json;
}

Listing listing_from(const Json& json) {
  Listing listing;
  listing.done = json.at("done");
  listing.next = json.at("next");
  listing.forgotten = json.value("forgotten", false);
  listing.values = json.at("values").get<std::map<std::string, std::string>>();
  for (const Json& one : json.at("steps")) {
    Step step{one.at("number"), sentence_from(one.at("name")), {}, one.value("kept", std::vector<std::string>{})};
    for (const Json& value : one.value("values", Json::array())) {
      step.values.push_back({value.at("key"), value.at("before"), value.at("after")});
    }
    for (const Json& file : one.value("followed", Json::array())) {
      step.followed.push_back({file.at("file"), file.at("before"), file.at("after")});
    }
    listing.steps.push_back(std::move(step));
  }
  if (json.contains("moving")) {
    listing.moving = {json.at("moving").at("step"),
                      json.at("moving").at("to") == name_of(Side::before) ? Side::before : Side::after};
  }
  listing.done = std::min(listing.done, listing.steps.size());
  return listing;
}

Result<Listing> read_listing(const std::filesystem::path& case_folder) {
  const std::filesystem::path file = case_folder / "history" / "journal.json";
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return Listing{};
  const auto document = read_json_file(file);
  if (!document) return history_damaged(file);
  try {
    return listing_from(*document);
  } catch (const Json::exception&) {
    return history_damaged(file);
  }
}

std::filesystem::path file_of_step(const std::filesystem::path& case_folder, int number) {
  return case_folder / "history" / "steps" / (std::to_string(number) + ".json");
}

std::filesystem::path file_of_runs(const std::filesystem::path& case_folder, int number, std::string id) {
  std::replace(id.begin(), id.end(), '/', '~');
  return case_folder / "history" / "steps" / (std::to_string(number) + "-" + id + ".runs");
}

std::filesystem::path file_of_session(const std::filesystem::path& case_folder, const std::string& session) {
  std::string name;
  for (const unsigned char c : session) {
    if (std::isalnum(c) != 0 || c == '-') name += static_cast<char>(c);
  }
  return case_folder / "history" / "kept" / ("session-" + name + ".json");
}

std::string recording_beside(const std::filesystem::path& case_folder, const std::string& session) {
  return read_text_file(file_of_session(case_folder, session), std::uint64_t{64} << 20).value_or("");
}

Json json_of(const std::vector<EntryChange>& changes) {
  Json json = Json::array();
  for (const EntryChange& change : changes) {
    Json one{{"id", change.id}, {"content", change.content}};
    if (change.sides.before) one["before"] = Json::parse(record_of(*change.sides.before));
    if (change.sides.after) one["after"] = Json::parse(record_of(*change.sides.after));
    json.push_back(std::move(one));
  }
  return json;
}

Result<std::vector<EntryChange>> read_changes(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return history_damaged(file);
  std::vector<EntryChange> changes;
  try {
    for (const Json& one : *document) {
      EntryChange change{one.at("id"), {}, one.at("content")};
      for (const auto& [side, into] :
           {std::pair("before", &change.sides.before), std::pair("after", &change.sides.after)}) {
        if (!one.contains(side)) continue;
        auto entry = entry_of(one.at(side).dump(), file);
        if (!entry) return history_damaged(file);
        *into = std::move(*entry);
      }
      changes.push_back(std::move(change));
    }
  } catch (const Json::exception&) {
    return history_damaged(file);
  }
  return changes;
}

Json json_of(const BegunStep& begun) {
  Json entries = Json::array();
  for (const Entry& entry : begun.entries) entries.push_back(Json::parse(record_of(entry)));
  Json json{{"number", begun.number}, {"name", json_of(begun.name)}, {"touches", begun.touches}, {"entries", entries}};
  if (begun.followed) json["followed"] = *begun.followed;
  return json;
}

Result<BegunStep> read_begun_step(const std::filesystem::path& file) {
  const auto json = read_json_file(file);
  if (!json) return history_damaged(file);
  try {
    BegunStep begun{json->at("number"), sentence_from(json->at("name")), json->at("touches"), {}, {}};
    for (const Json& one : json->at("entries")) {
      auto entry = entry_of(one.dump(), file);
      if (!entry) return history_damaged(file);
      begun.entries.push_back(std::move(*entry));
    }
    if (json->contains("followed")) begun.followed = json->at("followed").get<FollowedFiles>();
    return begun;
  } catch (const Json::exception&) {
    return history_damaged(file);
  }
}

Failure history_damaged(const std::filesystem::path& file) {
  return failure(Error{
      "history-damaged", GLISSON_TEXT("The history of the case cannot be read: {0}."), {file.string()}, {}, file});
}

}  // namespace glisson::casefile
