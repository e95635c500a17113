// What a gate leaves: a page, the same as JSON, JUnit's XML, and the worst pictures beside each other.

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "base/json.h"
#include "base/markup.h"
#include "base/write_file.h"
#include "report/html.h"
#include "studies/gate/gate.h"
#include "studies/gate/internal/compared_pictures.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t pictures_shown = 6;  // of each kind

struct Shown {
  std::string caption;
  vision::Frame beside;  // base, new, difference
};

// Names and captions of what is shown.
using Pictures = std::vector<std::pair<std::string, std::string>>;
Pictures most_unlike(const Gate& gate);
Pictures of_worst_cases(const Gate& gate, const Pictures& shown_already);
std::vector<Shown> side_by_side(const Pictures& pictures, const Results& base, const Results& now,
                                const GateOptions& options);
report::Page page_of(const Gate& gate, const Results& base, const Results& now, const GateOptions& options);
std::string junit_of(const Gate& gate);

}  // namespace

Result<void> write_gate(const Gate& gate, const Results& base, const Results& now, const GateOptions& options,
                        const fs::path& folder) {
  auto drawn = TemporaryFolder::make();
  if (!drawn) return failure(drawn.error());
  report::Page page = page_of(gate, base, now, options);
  const Pictures unlike = most_unlike(gate), of_cases = of_worst_cases(gate, unlike);
  std::vector<Shown> pictures;
  for (const auto& [heading, names] :
       {std::pair("Pictures that differ the most: base, new, difference", &unlike),
        std::pair("Pictures of the cases that got worse the most: base, new, difference", &of_cases)}) {
    if (!names->empty()) page.blocks.emplace_back(report::Heading{heading});
    for (Shown& one : side_by_side(*names, base, now, options)) {
      const fs::path file = drawn->path() / fmt::format("{}.png", pictures.size());
      if (auto written = vision::write_frame(one.beside, file); !written) return written;
      page.blocks.emplace_back(report::FigureRow{{{file, one.caption}}});
      pictures.push_back(std::move(one));
    }
  }
  return write_together([&]() -> Result<void> {
    for (std::size_t k = 0; k < pictures.size(); ++k) {
      const fs::path file = folder / "pictures" / fmt::format("worst-{}.png", k + 1);
      if (auto written = vision::write_frame(pictures[k].beside, file); !written) return written;
    }
    return write_json_file(folder / "gate.json", json_of(gate))
        .and_then([&] { return write_text_file(folder / "junit.xml", junit_of(gate)); })
        .and_then([&] { return report::write_html(folder / "gate.html", page); });
  });
}

Json json_of(const Gate& gate) {
  Json document{{"verdict", name_of(gate.verdict)},
                {"metrics", Json::array()},
                {"pictures", Json::array()},
                {"worst", Json::array()},
                {"only_base", gate.only_base},
                {"only_new", gate.only_now},
                {"notes", gate.notes}};
  for (const MetricChange& change : gate.metrics) {
    document["metrics"].push_back({{"name", change.name},
                                   {"cases", change.cases},
                                   {"base", change.base},
                                   {"new", change.now},
                                   {"difference", change.difference},
                                   {"interval", change.interval},
                                   {"p", change.p},
                                   {"each_case", change.each_case},
                                   {"lost", change.lost},
                                   {"gained", change.gained},
                                   {"without", change.without},
                                   {"verdict", name_of(change.verdict)}});
  }
  for (const PictureChange& change : gate.pictures) {
    document["pictures"].push_back(
        {{"name", change.name}, {"similarity", change.similarity}, {"verdict", name_of(change.verdict)}});
    if (!change.problem.empty()) document["pictures"].back()["problem"] = change.problem;
  }
  for (const WorstCase& one : gate.worst)
    document["worst"].push_back({{"case", one.id}, {"metric", one.metric}, {"base", one.base}, {"new", one.now}});
  return document;
}

std::string sentence_of(const MetricChange& change) {
  std::string text =
      fmt::format("{}: {:.4g} to {:.4g} (medians of {} cases), {:+.3g} [{:+.3g}, {:+.3g}]", change.name, change.base,
                  change.now, change.cases, change.difference, change.interval[0], change.interval[1]);
  if (!change.each_case) text += fmt::format(", p = {:.2g}", change.p);
  if (!change.lost.empty()) text += fmt::format(", {} without a number now", change.lost.size());
  if (!change.gained.empty()) text += fmt::format(", {} with a number that had none", change.gained.size());
  if (change.without > 0) text += fmt::format(", {} without a number in both", change.without);
  return text + fmt::format(": {}", name_of(change.verdict));
}

namespace {

// The most unlike first; those that cannot be compared are in the table alone.
Pictures most_unlike(const Gate& gate) {
  std::vector<const PictureChange*> order;
  for (const PictureChange& change : gate.pictures) {
    if (change.problem.empty() && change.verdict == GateVerdict::worse) order.push_back(&change);
  }
  std::sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->similarity < b->similarity; });
  Pictures pictures;
  for (const PictureChange* change : order) {
    if (pictures.size() < pictures_shown) pictures.emplace_back(change->name, change->name);
  }
  return pictures;
}

// Alike as they may be: what a metric sees may hardly show.
Pictures of_worst_cases(const Gate& gate, const Pictures& shown_already) {
  Pictures pictures;
  for (const WorstCase& worst : gate.worst) {
    for (const PictureChange& change : gate.pictures) {
      const auto is_this = [&](const auto& picture) { return picture.first == change.name; };
      const bool shown = std::any_of(shown_already.begin(), shown_already.end(), is_this) ||
                         std::any_of(pictures.begin(), pictures.end(), is_this);
      if (shown || !change.problem.empty() || !change.name.starts_with(worst.id + "/")) continue;
      if (pictures.size() < pictures_shown) {
        pictures.emplace_back(
            change.name, fmt::format("{}: {} {:.4g}, {:.4g} before", change.name, worst.metric, worst.now, worst.base));
      }
    }
  }
  return pictures;
}

std::vector<Shown> side_by_side(const Pictures& pictures, const Results& base, const Results& now,
                                const GateOptions& options) {
  std::vector<Shown> shown;
  for (const auto& [name, caption] : pictures) {
    const auto compared = compared_pictures(name, base, now, options);
    if (!compared) continue;
    vision::Frame beside{3 * compared->base.width, compared->base.height, {}};
    for (int y = 0; y < compared->base.height; ++y) {
      for (const vision::Frame* frame : {&compared->base, &compared->now, &compared->similarity.difference})
        beside.rgb.insert(beside.rgb.end(), frame->at(0, y), frame->at(0, y) + std::ptrdiff_t{3} * frame->width);
    }
    shown.push_back({caption, std::move(beside)});
  }
  return shown;
}

report::Cell verdict_cell(GateVerdict verdict) {
  using Emphasis = report::Cell::Emphasis;
  return {name_of(verdict), verdict == GateVerdict::worse    ? Emphasis::flag
                            : verdict == GateVerdict::better ? Emphasis::good
                                                             : Emphasis::none};
}

report::Table metrics_table(const Gate& gate) {
  report::Table table;
  table.caption =
      "Medians over the cases that have a number in both; the change is that of pairs, with its 95 % interval.";
  table.columns = {"Metric", "Cases",           "Base",   "New", "Change", "Interval", "p of so much worse", "Lost",
                   "Gained", "Without in both", "Verdict"};
  for (const MetricChange& change : gate.metrics) {
    table.rows.push_back({{change.name},
                          {std::to_string(change.cases)},
                          {fmt::format("{:.4g}", change.base)},
                          {fmt::format("{:.4g}", change.now)},
                          {fmt::format("{:+.3g}", change.difference)},
                          {fmt::format("{:+.3g} to {:+.3g}", change.interval[0], change.interval[1])},
                          {change.each_case ? "each case" : fmt::format("{:.2g}", change.p)},
                          {std::to_string(change.lost.size())},
                          {std::to_string(change.gained.size())},
                          {std::to_string(change.without)},
                          verdict_cell(change.verdict)});
  }
  return table;
}

std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t shown = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(shown, names.size()); ++k) text += (k == 0 ? "" : ", ") + names[k];
  return names.size() > shown ? text + fmt::format(" and {} more", names.size() - shown) : text;
}

std::string called(const Results& results) {
  const std::string name = results.program + (results.version.empty() ? "" : " " + results.version);
  return name.empty() ? results.folder.string() : name + " (" + results.folder.string() + ")";
}

report::Page page_of(const Gate& gate, const Results& base, const Results& now, const GateOptions& options) {
  report::Page page;
  page.title = gate.verdict == GateVerdict::worse       ? "Something got worse"
               : gate.verdict == GateVerdict::undecided ? "Not everything could be judged"
                                                        : "Nothing got worse";
  page.subtitle = called(base) + " against " + called(now);
  for (const std::string& note : gate.notes) page.blocks.emplace_back(report::Paragraph{note});
  page.blocks.emplace_back(metrics_table(gate));
  page.blocks.emplace_back(report::Paragraph{fmt::format(
      "Pairs are judged by Wilcoxon's signed ranks, corrected for all metrics (Holm): chance alone says \"worse\" in "
      "at "
      "most {:g} % of all runs. Where there are too few cases for that, each case is held to the tolerance by itself.",
      100 * options.false_alarms)});
  if (!gate.only_base.empty())
    page.blocks.emplace_back(report::Paragraph{"Cases that are missing now: " + list_of(gate.only_base) + "."});
  if (!gate.only_now.empty())
    page.blocks.emplace_back(report::Paragraph{"New cases, not compared: " + list_of(gate.only_now) + "."});
  for (const MetricChange& change : gate.metrics) {
    if (change.lost.empty()) continue;
    page.blocks.emplace_back(
        report::Paragraph{fmt::format("{} has no number any more in: {}.", change.name, list_of(change.lost))});
  }
  if (!gate.worst.empty()) {
    report::Table table{
        "The case that got worse the most, of each metric that did", {"Case", "Metric", "Base", "New"}, {}};
    for (const WorstCase& one : gate.worst)
      table.rows.push_back(
          {{one.id}, {one.metric}, {fmt::format("{:.4g}", one.base)}, {fmt::format("{:.4g}", one.now)}});
    page.blocks.emplace_back(std::move(table));
  }
  if (!gate.pictures.empty()) {
    report::Table table{fmt::format("Pictures: structural similarity of the most unlike sixteenth; below {:g} is worse",
                                    options.similarity),
                        {"Picture", "Similarity", "Verdict"},
                        {}};
    for (const PictureChange& change : gate.pictures) {
      table.rows.push_back({{change.name},
                            {change.problem.empty() ? fmt::format("{:.3f}", change.similarity) : change.problem},
                            verdict_cell(change.verdict)});
    }
    page.blocks.emplace_back(std::move(table));
  }
  page.footer = "Made by glisson-cli gate " + version() + ".";
  return page;
}

// Test cases by kind, a failure where something got worse, a skip where it could not be judged.
std::string junit_of(const Gate& gate) {
  std::string cases;
  int count = 0, failures = 0, skipped = 0;
  const auto add = [&](const std::string& name, const std::string& kind, GateVerdict verdict, const std::string& text) {
    ++count;
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", kind, escaped_markup(name));
    if (verdict == GateVerdict::worse) {
      ++failures;
      cases += fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n", escaped_markup(text));
    } else if (verdict == GateVerdict::undecided) {
      ++skipped;
      cases += fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n", escaped_markup(text));
    } else {
      cases += "/>\n";
    }
  };
  for (const MetricChange& change : gate.metrics) add(change.name, "metric", change.verdict, sentence_of(change));
  for (const PictureChange& change : gate.pictures) {
    add(change.name, "picture", change.verdict,
        change.problem.empty() ? fmt::format("similarity {:.3f}", change.similarity) : change.problem);
  }
  for (const std::string& id : gate.only_base) add(id, "case", GateVerdict::worse, "the case is missing");
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"glisson gate\" tests=\"{}\" "
      "failures=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n</testsuites>\n",
      count, failures, skipped, cases);
}

}  // namespace
}  // namespace glisson::studies
