#include "report/patient_page.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "casefile/model_upkeep.h"
#include "casefile/structures.h"
#include "rehearsal/tool_presets.h"
#include "report/internal/patient_sections.h"

namespace glisson::report {
namespace {

using casefile::Case;
using casefile::Entry;
using casefile::Freshness;

void add_figures(Page& page, const std::vector<Figure>& figures);
void add_images(Page& page, const Case& patient, const Words& words);
Result<void> add_structures(Page& page, const Case& patient, const Words& words);
void add_retraction(Page& page, const Case& patient, const PatientPageContent& content);
void add_plan(Page& page, const std::optional<hardware::Plan>& plan, const Words& words);
void add_files(Page& page, const Case& patient, const Words& words);

}  // namespace

Result<Page> patient_page(const Case& patient, const PatientPageContent& content, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the case"));
  const Words& words = content.words;
  Page page;
  page.language = words.language;
  page.title = content.name ? *content.name : words.say(GLISSON_TEXT("Patient: name withheld"));
  page.subtitle = words.say(GLISSON_TEXT("What was planned and rehearsed"));
  if (!content.when.empty()) page.subtitle += ", " + content.when;
  page.warning = (patient.origin().empty() ? "" : words.sentence({patient.origin(), {}}) + ". ") +
                 words.say(GLISSON_TEXT("Not a medical device."));
  page.footer =
      words.say(GLISSON_TEXT("Glisson {0}. Not a medical device: not for diagnosis or treatment."), {version()});
  add_figures(page, content.figures);
  add_resection(page, patient, words);
  if (auto added = add_kept_plans(page, patient, words); !added) return failure(std::move(added.error()));
  add_retraction(page, patient, content);
  if (auto added = add_orders(page, patient, words); !added) return failure(std::move(added.error()));
  if (auto added = add_structures(page, patient, words); !added) return failure(std::move(added.error()));
  add_plan(page, content.plan, words);
  progress.report(0.3, GLISSON_TEXT("Reading the model"));
  add_images(page, patient, words);
  if (auto added = add_model(page, patient, words); !added) return failure(std::move(added.error()));
  if (auto added = add_evidence(page, patient, words); !added) return failure(std::move(added.error()));
  progress.report(0.7, GLISSON_TEXT("Comparing the files with what they were made from"));
  add_files(page, patient, words);
  return page;
}

namespace {

Cell length_mm(double value_mm) {
  const bool significant = value_mm >= 5.0;
  return {fmt::format("{:.1f}{}", value_mm, significant ? " !" : ""),
          significant ? Cell::Emphasis::flag : Cell::Emphasis::none};
}

void add_figures(Page& page, const std::vector<Figure>& figures) {
  if (figures.empty()) return;
  page.blocks.push_back(FigureRow{{figures.front()}});
  if (figures.size() > 1) page.blocks.push_back(FigureRow{{figures.begin() + 1, figures.end()}});
}

void add_images(Page& page, const Case& patient, const Words& words) {
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Images"))});
  Table table{
      "", {words.say(GLISSON_TEXT("Volume")), words.say(GLISSON_TEXT("From")), words.say(GLISSON_TEXT("Made by"))}, {}};
  for (const Entry& entry : patient.entries()) {
    if (!entry.id.starts_with("volumes/")) continue;
    const std::size_t files = entry.made.sources.size();
    table.rows.push_back({{words.name(entry.id.substr(std::string("volumes/").size()))},
                          {files == 0 ? words.say(GLISSON_TEXT("the case"))
                                      : words.say(GLISSON_TEXT("files: {0}"), {std::to_string(files)})},
                          {words.way(entry.made.by)}});
  }
  if (table.rows.empty()) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("The case holds no images."))});
  } else {
    page.blocks.push_back(std::move(table));
  }
}

Result<void> add_structures(Page& page, const Case& patient, const Words& words) {
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Structures"))});
  const auto structures = casefile::read_structures(patient);
  if (!structures) return failure(structures.error());
  if (structures->empty()) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("Nothing is outlined yet."))});
    return {};
  }
  Table table{"", {words.say(GLISSON_TEXT("Structure")), "ml", words.say(GLISSON_TEXT("Outlined by"))}, {}};
  for (const auto& structure : *structures) {
    const Entry* entry = patient.find("labels/" + structure.name);
    table.rows.push_back({{words.name(structure.name)},
                          {fmt::format("{:.1f}", segmentation::volume_ml(structure.mask))},
                          {entry != nullptr ? words.way(entry->made.by) : ""}});
  }
  page.blocks.push_back(std::move(table));
  return {};
}

// "Retractor with 2.0 N over 15 mm radius"
std::string tool_words(const RehearsedTool& tool, const Words& words) {
  const auto preset = rehearsal::tool_preset(tool.name);
  return words.say(GLISSON_TEXT("{0} with {1} N over {2} mm radius"),
                   {preset ? words.sentence({preset->name, {}}) : tool.name, fmt::format("{:.1f}", tool.force_N),
                    fmt::format("{:.0f}", tool.radius_mm)});
}

void add_retraction(Page& page, const Case& patient, const PatientPageContent& content) {
  const Words& words = content.words;
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Rehearsed retraction"))});
  if (!content.retraction) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("No tool is on the liver: nothing is being rehearsed."))});
    return;
  }
  const RehearsedRetraction& retraction = *content.retraction;
  std::string tools;
  for (const RehearsedTool& tool : retraction.tools) tools += (tools.empty() ? "" : ", ") + tool_words(tool, words);
  const mechanics::Validity& validity = retraction.validity;
  std::string told = words.say(GLISSON_TEXT("Tools: {0}."), {tools});
  if (validity.usable()) {
    told += " " + words.say(GLISSON_TEXT("The liver moves by up to {0} mm."),
                            {fmt::format("{:.1f}", retraction.max_displacement_mm)});
  }
  told += " " + words.sentence(validity.sentence()) + " " +
          (retraction.large_deformations ? words.say(GLISSON_TEXT("Computed with large deformations (neo-Hookean)."))
                                         : words.say(GLISSON_TEXT("Computed with small deformations (linear).")));
  if (retraction.error_bound_mm) {
    told += " " + words.say(GLISSON_TEXT("The liver had not come to rest: landmarks are within {0} mm of it."),
                            {fmt::format("{:.1f}", *retraction.error_bound_mm)});
  }
  page.blocks.push_back(Paragraph{told});
  if (const auto assumed = casefile::assumed_stiffness(patient)) {
    page.blocks.push_back(Paragraph{words.sentence(*assumed)});
  }
  if (retraction.landmarks.empty()) {
    page.blocks.push_back(Paragraph{words.say(GLISSON_TEXT("No landmark was set."))});
    return;
  }
  const bool compared =
      std::any_of(retraction.landmarks.begin(), retraction.landmarks.end(),
                  [](const RehearsedLandmark& landmark) { return landmark.reference_off_mm.has_value(); });
  Table table{words.say(GLISSON_TEXT("5 mm or more matters to a surgeon and is marked !.")),
              {words.say(GLISSON_TEXT("Landmark")), words.say(GLISSON_TEXT("Moves (mm)"))},
              {}};
  if (compared) table.columns.push_back(words.say(GLISSON_TEXT("Atlas off (mm)")));
  for (const RehearsedLandmark& landmark : retraction.landmarks) {
    std::vector<Cell> row{{words.name(landmark.id)}, validity.usable() ? length_mm(landmark.moves_mm) : Cell{"-"}};
    const bool known = validity.usable() && landmark.reference_off_mm;
    if (compared) row.push_back(known ? length_mm(*landmark.reference_off_mm) : Cell{"-"});
    table.rows.push_back(std::move(row));
  }
  page.blocks.push_back(std::move(table));
}

void add_plan(Page& page, const std::optional<hardware::Plan>& plan, const Words& words) {
  if (!plan) return;
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("What can be worn"))});
  const auto& asked = plan->request;
  page.blocks.push_back(Paragraph{words.say(
      GLISSON_TEXT("For a liver of {0} cm3, {1} mm accuracy, {2} frames a second, {3} h at {4} deg C: {5}."),
      {fmt::format("{:.0f}", asked.liver_volume_cm3), fmt::format("{:.1f}", asked.accuracy_mm),
       fmt::format("{:.1f}", asked.frames_per_s), fmt::format("{:.1f}", asked.duration_h),
       fmt::format("{:.0f}", asked.ambient_C),
       plan->recommended ? words.say(GLISSON_TEXT("the least obtrusive that holds is {0}"), {*plan->recommended})
                         : words.say(GLISSON_TEXT("none of the known platforms holds"))})});
  Table table{
      "",
      {words.say(GLISSON_TEXT("Platform")), words.say(GLISSON_TEXT("Frames/s")), words.say(GLISSON_TEXT("Battery (h)")),
       words.say(GLISSON_TEXT("Surface (deg C)")), words.say(GLISSON_TEXT("Holds"))},
      {}};
  for (const hardware::DevicePlan& answer : plan->platforms) {
    table.rows.push_back({{answer.name},
                          {fmt::format("{:.1f}", answer.fps)},
                          {fmt::format("{:.1f}", answer.battery_h)},
                          {fmt::format("{:.0f}", answer.temperature_C)},
                          {words.say(answer.feasible ? GLISSON_TEXT("yes") : GLISSON_TEXT("no")),
                           answer.feasible ? Cell::Emphasis::good : Cell::Emphasis::none}});
  }
  page.blocks.push_back(std::move(table));
}

const char* freshness_word(Freshness freshness) {
  switch (freshness) {
    case Freshness::current: return GLISSON_TEXT("current");
    case Freshness::stale: return GLISSON_TEXT("stale: made from something that has changed");
    case Freshness::changed_outside: return GLISSON_TEXT("changed by another program");
    case Freshness::missing: return GLISSON_TEXT("missing");
  }
  GLISSON_ASSERT(false);
}

void add_files(Page& page, const Case& patient, const Words& words) {
  page.blocks.push_back(Heading{words.say(GLISSON_TEXT("Where it comes from"))});
  Table table{words.say(GLISSON_TEXT("Each file of the case, the beginning of its SHA-256, and what made it.")),
              {words.say(GLISSON_TEXT("File")), "SHA-256", words.say(GLISSON_TEXT("Made by")),
               words.say(GLISSON_TEXT("When (UTC)")), words.say(GLISSON_TEXT("State"))},
              {}};
  for (const Entry& entry : patient.entries()) {
    const Freshness freshness = patient.freshness(entry.id);
    table.rows.push_back({{words.entry(entry.id)},
                          {entry.sha256.substr(0, 12)},
                          {fmt::format("{} (Glisson {})", words.way(entry.made.by), entry.version)},
                          {entry.when_utc},
                          {words.say(freshness_word(freshness)),
                           freshness == Freshness::current ? Cell::Emphasis::none : Cell::Emphasis::flag}});
  }
  page.blocks.push_back(std::move(table));
}

}  // namespace
}  // namespace glisson::report
