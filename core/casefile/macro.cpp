#include "casefile/macro.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "casefile/found_liver.h"
#include "casefile/internal/history_journal.h"
#include "casefile/internal/macro_values.h"
#include "casefile/model_upkeep.h"
#include "vasculature/systems.h"

namespace glisson::casefile {
namespace fs = std::filesystem;
namespace {

std::vector<Command> commands_of(const Step& step, const std::vector<EntryChange>& changes);
std::string heading(const Macro& macro, const char* for_whom);
std::string heading(const MacroStep& step);
std::string one_line(const std::string& text);
std::string in_shell(const std::string& word);
std::string word_in_shell(const std::string& word, const Macro& macro);

}  // namespace

Result<Macro> macro_of(const fs::path& case_folder) {
  if (auto there = Case::open(case_folder); !there) return failure(std::move(there.error()));
  const auto listing = read_listing(case_folder);
  if (!listing) return failure(listing.error());
  std::error_code ignored;
  Macro macro{fs::absolute(case_folder, ignored), listing->forgotten, {}};
  for (std::size_t n = 0; n < listing->done; ++n) {
    const Step& step = listing->steps[n];
    MacroStep told{step.number, step.name, {}};
    if (step.values.empty()) {
      const auto changes = read_changes(file_of_step(case_folder, step.number));
      if (!changes) return failure(changes.error());
      told.commands = commands_of(step, *changes);
    }
    macro.steps.push_back(std::move(told));
  }
  add_commands_of_values(case_folder, *listing, macro);
  return macro;
}

std::string as_command_line(const Macro& macro) {
  std::string text = heading(macro, "for a shell");
  text += "CASE=before.glisson  # a copy of the case as it was\n";
  text += "RECORDED=" + in_shell(macro.recorded.string()) + "  # whose history holds what was done by hand\n";
  for (std::size_t n = 0; n < macro.sequences.size(); ++n) {
    text += fmt::format("SEQUENCE_{}=sequence.json  # the file whose SHA-256 is {}\n", n + 1, macro.sequences[n]);
  }
  for (const MacroStep& step : macro.steps) {
    text += heading(step);
    for (const Command& command : step.commands) {
      if (!command.file.empty()) text += fmt::format("cat > {} <<'END' &&\n{}\nEND\n", command.file, command.document);
      text += "glisson-cli";
      for (const std::string& word : command.words) {
        text += " " + word_in_shell(word, macro);
      }
      text += " &&\n";
    }
  }
  return text + "\ntrue\n";
}

std::string as_python(const Macro& macro) {
  std::string text = heading(macro, "in Python");
  text += "import glisson\n\npatient = glisson.Case(\"before.glisson\")  # a copy of the case as it was\n";
  text += "recorded = " + in_python(macro.recorded.string()) + "  # whose history holds what was done by hand\n";
  for (std::size_t n = 0; n < macro.sequences.size(); ++n) {
    text += fmt::format("sequence_{} = \"sequence.json\"  # the file whose SHA-256 is {}\n", n + 1, macro.sequences[n]);
  }
  for (const MacroStep& step : macro.steps) {
    text += heading(step);
    for (const Command& command : step.commands) text += command.python + "\n";
  }
  return text;
}

namespace {

std::string heading(const Macro& macro, const char* for_whom) {
  return "# What was done to a case in Glisson " + version() + ", " + for_whom +
         ". It begins with the case as it was before the first step.\n" +
         (macro.earlier_forgotten ? "# Earlier steps are no longer known: the history keeps a limited number.\n" : "");
}

std::string heading(const MacroStep& step) {
  const std::string remark = step.told_in != 0       ? fmt::format(" (in the session of step {})", step.told_in)
                             : step.commands.empty() ? " (moved a view, and changed nothing in the case)"
                                                     : "";
  return fmt::format("\n# {}. {}{}\n", step.number, one_line(step.name.message()), remark);
}

using Options = std::map<std::string, std::string>;

std::string option(const Options& options, const std::string& name) {
  const auto found = options.find(name);
  return found == options.end() ? std::string() : found->second;
}

// As it is to be typed; empty where it is no finite number. A case may come from anywhere.
std::string number_in(const std::string& text) {
  const auto number = read_number(text);
  return number ? fmt::format("{}", *number) : std::string();
}

// "1,2,3"; empty where it is no position.
std::string position_in(const std::string& text) {
  std::string position;
  int numbers = 0;
  for (std::size_t begin = 0; begin <= text.size(); ++numbers) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string number = number_in(text.substr(begin, end - begin));
    if (number.empty()) return {};
    position += (numbers == 0 ? "" : ",") + number;
    begin = end + 1;
  }
  return numbers == 3 ? position : std::string();
}

// The points kept as "NAME-1_mm" and so on, for Python; each follows "--NAME" among the words. Nothing where one is
// none.
std::optional<std::vector<std::string>> points_in(const Options& options, const std::string& name,
                                                  std::vector<std::string>& words) {
  std::vector<std::string> points;
  for (std::size_t n = 1; options.count(fmt::format("{}-{}_mm", name, n)) != 0; ++n) {
    const std::string point = position_in(option(options, fmt::format("{}-{}_mm", name, n)));
    if (point.empty()) return {};
    words.insert(words.end(), {"--" + name, point});
    points.push_back("[" + point + "]");
  }
  return points;
}

// Nothing where how the entry was made does not say all that the command needs.
std::optional<Command> segment(const std::string& id, const Provenance& made) {
  const std::string method = option(made.options, "method");
  const bool by_shape = method == "tubes";
  // A shape model's file is not kept, only what it was called.
  const bool found = method == "shape" && option(made.options, "shapes") == simulated_shapes;
  if ((method != "seeds" && !by_shape && !found) || made.options.count("edited") != 0) return {};
  const std::string name = id.substr(std::string("labels/").size());
  Command command{{"segment", the_case, "--structure", name}, {}};
  const auto seeds = points_in(made.options, "seed", command.words);
  if (!seeds) return {};
  if (found) {
    const auto outside = points_in(made.options, "not", command.words);
    if (!outside) return {};
    command.words.insert(command.words.end(), {"--shapes", simulated_shapes});
    const std::string more = outside->empty() ? "" : fmt::format(", outside_mm=[{}]", fmt::join(*outside, ", "));
    command.python = fmt::format("patient.find_liver([{}]{})", fmt::join(*seeds, ", "), more);
    return command;
  }
  if (seeds->empty() && !by_shape) return {};
  const std::string within = option(made.options, "within");
  if (!within.empty()) command.words.insert(command.words.end(), {"--inside", within});
  std::string more = within.empty() ? "" : ", within=" + in_python(within);
  const std::string brightness = option(made.options, "brightness");
  if (by_shape) {
    command.words.emplace_back("--tubes");
    if (brightness == "bright" || brightness == "dark") {
      command.words.insert(command.words.end(), {"--brightness", brightness});
      more += ", brightness=" + in_python(brightness);
    }
  }
  command.python = fmt::format("patient.{}({}, [{}]{})", by_shape ? "segment_vessels" : "grow_structure",
                               in_python(name), fmt::join(*seeds, ", "), more);
  return command;
}

std::optional<Command> invert(const std::string&, const Provenance& made) {
  const std::string method = option(made.options, "method"), long_waves = option(made.options, "long-waves");
  const std::string directions = option(made.options, "directions");
  if (method.empty() || long_waves.empty() || directions.empty()) return {};
  Command command{{"invert", the_case, "--method", method, "--long-waves", long_waves}, {}};
  std::string more;
  if (directions == "apart") {
    command.words.emplace_back("--directional");
    more += ", directional=True";
  }
  for (const auto& [asked, word] :
       {std::pair("asked-frequency_Hz", "frequency_Hz"), std::pair("asked-directions", "directions")}) {
    if (made.options.count(asked) == 0) continue;
    const std::string number = number_in(option(made.options, asked));
    if (number.empty()) return {};
    command.words.insert(command.words.end(),
                         {word == std::string("directions") ? "--directions" : "--frequency-Hz", number});
    more += fmt::format(", {}={}", word, number);
  }
  command.python =
      fmt::format("patient.invert_waves(method={}, long_waves={}{})", in_python(method), in_python(long_waves), more);
  return command;
}

// Adds them to the command; for Python "borders=[...]", empty where there are none.
std::string borders_told(const Options& options, Command& command) {
  std::vector<std::string> in_list;
  for (std::size_t n = 1;; ++n) {
    const auto place = vasculature::border_of_text(option(options, fmt::format("border-{}_mm", n)));
    if (!place) break;
    const std::string text = vasculature::border_text(*place);
    command.words.insert(command.words.end(), {"--border", text});
    in_list.push_back(fmt::format("({}, [{}])", in_python(vasculature::border_name(place->segments)),
                                  text.substr(text.find('=') + 1)));
  }
  return in_list.empty() ? std::string() : fmt::format("borders=[{}]", fmt::join(in_list, ", "));
}

std::optional<Command> vessels(const std::string&, const Provenance& made) {
  const std::string of = option(made.options, "of");
  if (of.empty()) return {};
  Command command{{"vessels", the_case}, {}};
  std::vector<std::string> named;
  if (of.find(',') == std::string::npos) {
    command.words.insert(command.words.end(), {"--structure", of});
    named.push_back("structure=" + in_python(of));
  }
  std::vector<std::pair<std::string, std::string>> told;  // in the order of the clicks: the tenth after the ninth
  std::copy_if(made.options.begin(), made.options.end(), std::back_inserter(told), [](const auto& made_by) {
    return made_by.first.ends_with("_mm") && made_by.first.find("click") != std::string::npos;
  });
  std::stable_sort(told.begin(), told.end(),
                   [](const auto& a, const auto& b) { return a.first.size() < b.first.size(); });
  std::vector<std::string> clicks;
  for (const auto& [name, value] : told) {
    // "click-1_mm": the vessel and where; by earlier versions "portal-click_mm": where alone.
    const std::size_t equals = value.find('=');
    const std::string vessel = equals != std::string::npos  ? value.substr(0, equals)
                               : name.starts_with("portal") ? "portal-vein"
                                                            : "hepatic-vein";
    const std::string place = position_in(equals != std::string::npos ? value.substr(equals + 1) : value);
    if (place.empty() || !vasculature::vessel_named(vessel)) return {};
    command.words.insert(command.words.end(), {"--click", vessel + "=" + place});
    clicks.push_back(fmt::format("({}, [{}])", in_python(vessel), place));
  }
  const std::string borders = borders_told(made.options, command);
  if (!borders.empty()) named.push_back(borders);
  if (!clicks.empty()) named.push_back(fmt::format("clicks=[{}]", fmt::join(clicks, ", ")));
  command.python = fmt::format("patient.segment_vessels({})", fmt::join(named, ", "));
  return command;
}

std::optional<Command> territories(const std::string&, const Provenance& made) {
  const std::string from = option(made.options, "from");
  if (from != "tree" && from != "prior") return {};
  Command command{{"territories", the_case, "--from", from}, {}};
  const std::string borders = borders_told(made.options, command);
  command.python =
      fmt::format("patient.find_territories(by={}{}{})", in_python(from), borders.empty() ? "" : ", ", borders);
  return command;
}

std::optional<Command> mesh(const std::string&, const Provenance& made) {
  const std::string cells = number_in(option(made.options, "target-cells"));
  if (cells.empty()) return {};
  return Command{{"mesh", the_case, "--target-cells", cells},
                 fmt::format("patient.mesh_liver(target_cells={})", cells)};
}

std::optional<Command> stiffness(const std::string&, const Provenance& made) {
  const StiffnessChoice choice = stiffness_choice_in(made);
  if (const auto* uniform = std::get_if<Uniform>(&choice)) {
    return Command{{"stiffness", the_case, "--uniform-kPa", fmt::format("{}", uniform->youngs_kPa)},
                   fmt::format("patient.assign_stiffness(uniform_kPa={})", uniform->youngs_kPa)};
  }
  if (const auto* mean = std::get_if<FromPopulationMean>(&choice)) {
    const char* shear_kPa = mean->mean == elastography::PopulationMean::published_cohort ? "2.6" : "2.1";
    return Command{{"stiffness", the_case, "--atlas", shear_kPa},
                   fmt::format("patient.assign_stiffness(atlas_kPa={})", shear_kPa)};
  }
  return Command{{"stiffness", the_case}, "patient.assign_stiffness()"};
}

// In the order of the work. Of a stage that makes several entries one tells how; empty: each of them does.
struct Stage {
  const char* by;
  const char* told_by;
  std::optional<Command> (*command)(const std::string& id, const Provenance& made);
};
constexpr Stage stages[] = {{"segment", "", segment},
                            {"invert", "volumes/stiffness", invert},
                            {"vessels", "vessels/trees", vessels},
                            {"territories", "territories/couinaud", territories},
                            {"mesh", "meshes/liver", mesh},
                            {"stiffness", "meshes/model", stiffness}};

Command redo(const Step& step) {
  const std::string number = std::to_string(step.number);
  return {{"redo", the_case, "--from", recorded_case, "--step", number},
          fmt::format("patient.redo(recorded, {})", number)};
}

// Those of all stages that the step went through; where one of its changes came from nothing but a hand or from
// outside, the whole step is redone.
std::vector<Command> commands_of(const Step& step, const std::vector<EntryChange>& changes) {
  std::vector<Command> commands;
  std::set<std::string> computed;
  for (const Stage& stage : stages) {
    for (const EntryChange& change : changes) {
      const auto& after = change.sides.after;
      if (!after || after->made.by != stage.by || (*stage.told_by != '\0' && change.id != stage.told_by)) continue;
      auto command = stage.command(change.id, after->made);
      if (!command) return {redo(step)};
      commands.push_back(*std::move(command));
      computed.insert(stage.by);
    }
  }
  const bool all = std::all_of(changes.begin(), changes.end(), [&](const EntryChange& change) {
    return computed.count(change.sides.after ? change.sides.after->made.by : change.sides.before->made.by) != 0;
  });
  return all && step.followed.empty() ? commands : std::vector<Command>{redo(step)};
}

// What stands in a comment must not end it.
std::string one_line(const std::string& text) {
  std::string line = text;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return line;
}

std::string word_in_shell(const std::string& word, const Macro& macro) {
  if (word == the_case) return "\"$CASE\"";
  if (word == recorded_case) return "\"$RECORDED\"";
  for (std::size_t n = 1; n <= macro.sequences.size(); ++n) {
    if (word == fmt::format("{}{}}}", sequence_word, n)) return fmt::format("\"$SEQUENCE_{}\"", n);
  }
  return in_shell(word);
}

std::string in_shell(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-_./,:=+").find(char(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace
}  // namespace glisson::casefile
