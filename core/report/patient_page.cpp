#include "report/patient_page.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "casefile/model_upkeep.h"
#include "casefile/structures.h"
#include "rehearsal/tool_presets.h"
#include "report/internal/patient_sections.h"
#include "report/plain_names.h"

namespace glisson::report {
namespace {

using casefile::Case;
using casefile::Entry;
using casefile::Freshness;

void add_figures(Page& page, const std::vector<Figure>& figures);
void add_images(Page& page, const Case& patient);
Result<void> add_structures(Page& page, const Case& patient);
void add_retraction(Page& page, const Case& patient, const std::optional<RehearsedRetraction>& retraction);
void add_plan(Page& page, const std::optional<hardware::Plan>& plan);
void add_files(Page& page, const Case& patient);

}  // namespace

Result<Page> patient_page(const Case& patient, const PatientPageContent& content, const Progress& progress) {
  progress.report(0, GLISSON_TEXT("Reading the case"));
  Page page;
  page.title = content.name ? *content.name : "Patient: name withheld";
  page.subtitle = "What was planned and rehearsed" + (content.when.empty() ? "" : ", " + content.when);
  page.warning = (patient.origin().empty() ? "" : patient.origin() + ". ") + "Not a medical device.";
  page.footer = fmt::format("Glisson {}. Not a medical device: not for diagnosis or treatment.", version());
  add_figures(page, content.figures);
  add_resection(page, patient);
  add_retraction(page, patient, content.retraction);
  if (auto added = add_structures(page, patient); !added) return failure(std::move(added.error()));
  add_plan(page, content.plan);
  progress.report(0.3, GLISSON_TEXT("Reading the model"));
  add_images(page, patient);
  if (auto added = add_model(page, patient); !added) return failure(std::move(added.error()));
  if (auto added = add_evidence(page, patient); !added) return failure(std::move(added.error()));
  progress.report(0.7, GLISSON_TEXT("Comparing the files with what they were made from"));
  add_files(page, patient);
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

void add_images(Page& page, const Case& patient) {
  page.blocks.push_back(Heading{"Images"});
  Table table{"", {"Volume", "From", "Made by"}, {}};
  for (const Entry& entry : patient.entries()) {
    if (!entry.id.starts_with("volumes/")) continue;
    std::vector<Cell> row{
        {plain_name(entry.id.substr(std::string("volumes/").size()))},
        {entry.made.sources.empty() ? "the case" : fmt::format("{} files", entry.made.sources.size())},
        {plain_way(entry.made.by)}};
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) {
    page.blocks.push_back(Paragraph{"The case holds no images."});
  } else {
    page.blocks.push_back(std::move(table));
  }
}

Result<void> add_structures(Page& page, const Case& patient) {
  page.blocks.push_back(Heading{"Structures"});
  const auto structures = casefile::read_structures(patient);
  if (!structures) return failure(structures.error());
  if (structures->empty()) {
    page.blocks.push_back(Paragraph{"Nothing is outlined yet."});
    return {};
  }
  Table table{"", {"Structure", "ml", "Outlined by"}, {}};
  for (const auto& structure : *structures) {
    const Entry* entry = patient.find("labels/" + structure.name);
    table.rows.push_back({{plain_name(structure.name)},
                          {fmt::format("{:.1f}", segmentation::volume_ml(structure.mask))},
                          {entry != nullptr ? plain_way(entry->made.by) : ""}});
  }
  page.blocks.push_back(std::move(table));
  return {};
}

void add_retraction(Page& page, const Case& patient, const std::optional<RehearsedRetraction>& retraction) {
  page.blocks.push_back(Heading{"Rehearsed retraction"});
  if (!retraction) {
    page.blocks.push_back(Paragraph{"No tool is on the liver: nothing is being rehearsed."});
    return;
  }
  std::string sentence;
  for (const RehearsedTool& tool : retraction->tools) {
    const auto preset = rehearsal::tool_preset(tool.name);
    sentence += fmt::format("{} {} with {:.1f} N over {:.0f} mm radius", sentence.empty() ? "Tools:" : ",",
                            preset ? preset->name : tool.name, tool.force_N, tool.radius_mm);
  }
  const mechanics::Validity& validity = retraction->validity;
  const std::string moves =
      validity.usable() ? fmt::format("The liver moves by up to {:.1f} mm. ", retraction->max_displacement_mm) : "";
  page.blocks.push_back(Paragraph{fmt::format("{}. {}{}", sentence, moves, validity.sentence().message())});
  if (const auto assumed = casefile::assumed_stiffness(patient)) page.blocks.push_back(Paragraph{assumed->message()});
  const bool compared =
      std::any_of(retraction->landmarks.begin(), retraction->landmarks.end(),
                  [](const RehearsedLandmark& landmark) { return landmark.atlas_off_mm.has_value(); });
  Table table{"5 mm or more matters to a surgeon and is marked !.", {"Landmark", "Moves (mm)"}, {}};
  if (compared) table.columns.emplace_back("Atlas off (mm)");
  for (const RehearsedLandmark& landmark : retraction->landmarks) {
    std::vector<Cell> row{{plain_name(landmark.id)}, validity.usable() ? length_mm(landmark.moves_mm) : Cell{"-"}};
    const bool known = validity.usable() && landmark.atlas_off_mm;
    if (compared) row.push_back(known ? length_mm(*landmark.atlas_off_mm) : Cell{"-"});
    table.rows.push_back(std::move(row));
  }
  page.blocks.push_back(std::move(table));
}

void add_plan(Page& page, const std::optional<hardware::Plan>& plan) {
  if (!plan) return;
  page.blocks.push_back(Heading{"What can be worn"});
  page.blocks.push_back(Paragraph{fmt::format(
      "For a liver of {:.0f} cm3, {:.1f} mm accuracy, {:.1f} frames a second, {:.1f} h at {:.0f} deg C: {}.",
      plan->request.liver_volume_cm3, plan->request.accuracy_mm, plan->request.frames_per_s, plan->request.duration_h,
      plan->request.ambient_C,
      plan->recommended ? "the least obtrusive that holds is " + *plan->recommended
                        : "none of the known platforms holds")});
  Table table{"", {"Platform", "Frames/s", "Battery (h)", "Surface (deg C)", "Holds"}, {}};
  for (const hardware::PlatformAnswer& answer : plan->platforms) {
    table.rows.push_back(
        {{answer.name},
         {fmt::format("{:.1f}", answer.fps)},
         {fmt::format("{:.1f}", answer.battery_h)},
         {fmt::format("{:.0f}", answer.temperature_C)},
         {answer.feasible ? "yes" : "no", answer.feasible ? Cell::Emphasis::good : Cell::Emphasis::none}});
  }
  page.blocks.push_back(std::move(table));
}

std::string freshness_word(Freshness freshness) {
  switch (freshness) {
    case Freshness::current: return "current";
    case Freshness::stale: return "stale: made from something that has changed";
    case Freshness::changed_outside: return "changed by another program";
    case Freshness::missing: return "missing";
  }
  GLISSON_ASSERT(false);
}

void add_files(Page& page, const Case& patient) {
  page.blocks.push_back(Heading{"Where it comes from"});
  Table table{"Each file of the case, the beginning of its SHA-256, and what made it.",
              {"File", "SHA-256", "Made by", "When (UTC)", "State"},
              {}};
  for (const Entry& entry : patient.entries()) {
    const Freshness freshness = patient.freshness(entry.id);
    table.rows.push_back(
        {{plain_entry(entry.id)},
         {entry.sha256.substr(0, 12)},
         {fmt::format("{} (Glisson {})", plain_way(entry.made.by), entry.version)},
         {entry.when_utc},
         {freshness_word(freshness), freshness == Freshness::current ? Cell::Emphasis::none : Cell::Emphasis::flag}});
  }
  page.blocks.push_back(std::move(table));
}

}  // namespace
}  // namespace glisson::report
