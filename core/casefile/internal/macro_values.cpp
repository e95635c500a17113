#include "casefile/internal/macro_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <map>
#include <optional>

#include "casefile/marked_lines.h"
#include "guidance/guidance_file.h"
#include "planning/plan_file.h"
#include "rehearsal/session.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

// Who keeps them: widgets/session/rehearsal_undo.cpp, widgets/resect/kept_cuts.h, widgets/guide/guide_page_hand.cpp,
// widgets/guide/guide_page_lines.cpp.
constexpr const char* tool_key = "rehearse/tool";
constexpr const char* surface_key = "resect/surface";
constexpr const char* taken_key = "resect/taken";
constexpr const char* pose_key = "guide/pose";
constexpr const char* lines_key = "guide/lines";

using KeptValues = std::map<std::string, std::string>;

KeptValues values_before(const Listing& listing);
Json kept_value(const KeptValues& values, const std::string& key);
std::string session_of(const Json& tools);
std::optional<Command> session_command(const fs::path& case_folder, const Json& tools, int step);
std::optional<Command> simulation_command(const Json& tools, int step);
std::optional<Command> plan_command(const KeptValues& values, int step);
std::optional<Command> guide_command(const KeptValues& values, int step, std::vector<std::string>& sequences);

}  // namespace

void add_commands_of_values(const fs::path& case_folder, const Listing& listing, Macro& macro) {
  std::vector<MacroStep>& steps = macro.steps;
  KeptValues now = values_before(listing);
  std::map<std::string, std::vector<std::size_t>> sessions;  // the steps of each
  for (std::size_t n = 0; n < steps.size(); ++n) {
    MacroStep& step = steps[n];
    std::optional<Command> command;
    for (const ValueChange& change : listing.steps[n].values) {
      now[change.key] = change.after;
      const Json value = kept_value(now, change.key);
      if (change.key == tool_key) {
        const std::string session = session_of(value);
        command =
            session.empty() ? simulation_command(value, step.number) : session_command(case_folder, value, step.number);
        if (command && !session.empty()) sessions[session].push_back(n);
      } else if (change.key == pose_key || change.key == lines_key) {
        command = guide_command(now, step.number, macro.sequences);
      } else if (change.key == surface_key || change.key == taken_key) {
        command = plan_command(now, step.number);
      }
    }
    if (command) step.commands.push_back(*std::move(command));
  }
  for (const auto& [session, of] : sessions) {
    for (const std::size_t n : of) {
      if (n == of.back()) continue;
      steps[n].commands.clear();
      steps[n].told_in = steps[of.back()].number;
    }
  }
}

std::string in_python(const Json& json) { return json.dump(-1, ' ', true, Json::error_handler_t::replace); }
std::string in_python(const std::string& text) { return in_python(Json(text)); }

namespace {

// As they stood before the first step that is still known.
KeptValues values_before(const Listing& listing) {
  KeptValues values = listing.values;
  for (std::size_t n = listing.done; n > 0; --n) {
    for (const ValueChange& change : listing.steps[n - 1].values) values[change.key] = change.before;
  }
  return values;
}

// A value stands in a list of one; null where there is none, or it is damaged: a case may come from anywhere.
Json kept_value(const KeptValues& values, const std::string& key) {
  const auto found = values.find(key);
  if (found == values.end()) return {};
  const Json list = Json::parse(found->second, nullptr, false);
  return list.is_array() && list.size() == 1 ? list.at(0) : Json();
}

// Of the window's that answered; empty where none did.
std::string session_of(const Json& tools) {
  const auto session = tools.find("session");
  return session != tools.end() && session->is_string() ? session->get<std::string>() : std::string();
}

// What the window's session had carried out by then.
std::optional<Command> session_command(const fs::path& case_folder, const Json& tools, int step) {
  try {
    const auto count = tools.at("commands").get<std::size_t>();
    auto recording = rehearsal::parse_recording(recording_beside(case_folder, tools.at("session")));
    if (!recording || count == 0 || recording->size() < count) return {};
    recording->resize(count);
    const std::string document = Json::parse(rehearsal::recording_text(*recording)).dump();
    const std::string kind = tools.value("deformations", "small");
    const std::string material = kind == "large" ? "neo-hookean" : "linear";
    const std::string file = fmt::format("session-{}.json", step), out = fmt::format("rehearsal-{}", step);
    std::vector<std::string> words{"session", the_case, "--live", "--material", material, "--settle", "last"};
    std::string how = "material=" + in_python(material);
    if (kind == "meshfree") {
      words.insert(words.end(), {"--engine", kind});
      how += ", engine=" + in_python(kind);
    }
    if (kind == "moving") {
      const std::string step_s = fmt::format("{:g}", rehearsal::step_in_the_hand_s);
      words.insert(words.end(), {"--motion", step_s});
      how += ", step_s=" + step_s;
    }
    words.insert(words.end(), {"--commands", file, "--out", out});
    return Command{std::move(words),
                   fmt::format("rehearsal_{0} = patient.session({1})\n"
                               "if rehearsal_{0}.replay({2}) is not None:\n"
                               "    raise SystemExit(\"step {0} led to another state than in the window\")",
                               step, how, in_python(document)),
                   file, document};
  } catch (const Json::exception&) {
    return {};
  }
}

// A tool that presses with a known force on a patch, as a load of a scenario.
std::optional<Command> simulation_command(const Json& tools, int step) {
  Json loads = Json::array();
  try {
    if (tools.at("touch") != "patch") return {};
    for (const Json& tool : tools.at("tools")) {
      Json force_N = Json::array();
      for (std::size_t k = 0; k < 3; ++k) {
        force_N.push_back(tool.at("force_N").get<double>() * tool.at("direction").at(k).get<double>());
      }
      loads.push_back({{"tool",
                        {{"center_mm", tool.at("center_mm")},
                         {"radius_mm", tool.at("radius_mm").get<double>()},
                         {"force_N", std::move(force_N)}}}});
    }
  } catch (const Json::exception&) {
    return {};
  }
  if (loads.empty()) return {};
  const Json scenario{{"loads", std::move(loads)}};
  const std::string file = fmt::format("scenario-{}.json", step), out = fmt::format("rehearsal-{}", step);
  return Command{{"simulate", the_case, "--scenario", file, "--out", out},
                 fmt::format("asked = patient.question({})\nrehearsal_{} = glisson.simulate(asked[\"mesh\"], "
                             "asked[\"scenario\"])",
                             in_python(scenario), step),
                 file,
                 scenario.dump()};
}

// The plane or sheet, and what is taken besides.
std::optional<Command> plan_command(const KeptValues& values, int step) {
  planning::Plan plan{fmt::format("step {}", step), {}};
  for (const char* key : {surface_key, taken_key}) {
    const Json text = kept_value(values, key);
    const Json document = text.is_string() ? Json::parse(text.get<std::string>(), nullptr, false) : Json();
    if (!document.is_object()) continue;
    const auto part = planning::plan_from(document);
    if (part) plan.cuts.insert(plan.cuts.end(), part->cuts.begin(), part->cuts.end());
  }
  if (plan.cuts.empty()) return {};
  const Json document = planning::plan_json(plan);
  const std::string file = fmt::format("plan-{}.json", step), out = fmt::format("plan-{}", step);
  return Command{{"plan", the_case, "--answer", file, "--out", out},
                 fmt::format("plan_{} = patient.planner().answer({})", step, in_python(document.at("cuts"))),
                 file,
                 document.dump()};
}

// Where a hand laid the liver, on which frame of which sequence.
struct LaidByHand {
  std::string sequence;
  std::size_t frame = 0;
  std::vector<double> pose;
};

std::optional<LaidByHand> laid_by_hand(const Json& json) {
  try {
    LaidByHand laid{json.at("sequence").get<std::string>(), json.at("frame").get<std::size_t>(),
                    json.at("pose").get<std::vector<double>>()};
    return guidance::rigid_pose(laid.pose) ? std::optional(laid) : std::nullopt;
  } catch (const Json::exception&) {
    return {};
  }
}

// From where the hand laid it, or from the first frame with a line.
std::optional<Command> guide_command(const KeptValues& values, int step, std::vector<std::string>& sequences) {
  const auto laid = laid_by_hand(kept_value(values, pose_key));
  const MarkedLines lines = marked_lines_from(kept_value(values, lines_key)).value_or(MarkedLines{});
  const auto first = first_marked_frame(lines);
  if (!laid && !first) return {};
  const bool is_marked = first && (!laid || laid->sequence == lines.sequence);  // else of another video
  std::size_t frame = 0;
  if (laid) {
    frame = laid->frame;
  } else if (first) {
    frame = *first;
  }
  const std::string content = laid ? laid->sequence : lines.sequence;
  constexpr std::size_t sha256_digits = 64;
  const bool is_content =
      content.size() == sha256_digits && content.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!is_content) return {};
  const auto known = std::find(sequences.begin(), sequences.end(), content);
  const auto sequence = known - sequences.begin() + 1;
  if (known == sequences.end()) sequences.push_back(content);
  const std::string out = fmt::format("guided-{}", step);
  Command command{{"guide", the_case, "--sequence", fmt::format("{}{}}}", sequence_word, sequence), "--sequence-sha256",
                   content, "--frame", std::to_string(frame)},
                  fmt::format("guided_{} = patient.guide(sequence_{}, frame={}", step, sequence, frame)};
  if (laid) {
    command.words.push_back(fmt::format("--pose={}", fmt::join(laid->pose, ",")));
    command.python += fmt::format(", pose=[{}]", fmt::join(laid->pose, ", "));
  }
  if (is_marked) {
    command.file = fmt::format("lines-{}.json", step);
    const Json document = json_of(lines);
    command.document = document.dump();
    command.words.insert(command.words.end(), {"--lines", command.file});
    command.python += fmt::format(", lines={}", in_python(document));
  }
  command.words.insert(command.words.end(), {"--out", out});
  command.python +=
      fmt::format(",\n                         sequence_sha256={}, folder={})", in_python(content), in_python(out));
  return command;
}

}  // namespace
}  // namespace glisson::casefile
