#include "report/plan_comparison.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/json.h"
#include "base/markup.h"
#include "planning/plan_file.h"
#include "vasculature/couinaud.h"

namespace glisson::report {
namespace {

bool holds(const Json& plan) { return !plan.contains("failed"); }

std::string name_of(const Json& plan) { return plan.at("name").get<std::string>(); }

std::string figure(const Json& json, const char* key, int decimals) {
  return json.contains(key) ? fmt::format("{:.{}f}", json.at(key).get<double>(), decimals) : "";
}

// A row a quantity, a column a plan.
Table figures(const std::vector<Json>& plans, const Words& words);
// What a wider margin costs: a point a plan.
Plot margin_against_tissue(const std::vector<Json>& plans, const Words& words);
Table segments_left(const std::vector<Json>& plans, const Words& words);
Table branches_cut(const Json& plan, const Words& words);
std::string svg_of(const planning::Resectogram& map);

}  // namespace

Page plan_comparison(const std::vector<Json>& plans, const std::string& origin, const std::vector<Sentence>& remarks,
                     const Words& words) {
  Page page;
  page.title = words.say(GLISSON_TEXT("Plans compared"));
  page.warning = origin;
  page.language = words.language;
  for (const Sentence& remark : remarks) page.blocks.push_back(Paragraph{words.sentence(remark)});
  add_plans(page, plans, words);
  return page;
}

void add_plans(Page& page, const std::vector<Json>& plans, const Words& words) {
  for (const Json& plan : plans) {
    if (!holds(plan)) {
      page.blocks.push_back(Paragraph{
          words.say(GLISSON_TEXT("{0} no longer holds: {1}"), {name_of(plan), plan.at("failed").get<std::string>()})});
    } else if (!plan.value("current", true)) {
      page.blocks.push_back(
          Paragraph{words.say(GLISSON_TEXT("What {0} was made from has changed since it was kept."), {name_of(plan)})});
    }
  }
  page.blocks.push_back(figures(plans, words));
  if (Plot traded = margin_against_tissue(plans, words); traded.curves.size() > 1) {
    page.blocks.push_back(std::move(traded));
  }
  if (Table segments = segments_left(plans, words); !segments.rows.empty()) page.blocks.push_back(std::move(segments));
  for (const Json& plan : plans) {
    if (Table branches = branches_cut(plan, words); !branches.rows.empty()) page.blocks.push_back(std::move(branches));
  }
}

void add_resectograms(Page& page, const std::string& plan, const std::vector<planning::Resectogram>& maps,
                      const Words& words) {
  DrawingRow row;
  for (const planning::Resectogram& map : maps) {
    row.drawings.push_back(
        {svg_of(map),
         words.say(GLISSON_TEXT("{0}: the cut unrolled flat. Purple: tumour; red: less than 5 mm from one; amber: less "
                                "than 10 mm. Rings: vessels that are cut."),
                   {plan})});
  }
  if (!row.drawings.empty()) page.blocks.push_back(std::move(row));
}

std::string plan_table(const std::vector<Json>& plans) {
  static constexpr std::array<const char*, 16> columns = {
      "removed_ml", "remnant_ml", "functional_remnant_ml", "remnant_percent", "perfused_ml",
      "drained_ml", "living_ml",  "living_percent",        "ischaemic_ml",    "congested_ml",
      "margin_mm",  "mean_kPa",   "confident_share",       "liver_ml",        "tumours_ml",
      "current"};
  std::string text = "name";
  for (const char* column : columns) text += fmt::format(",{}", column);
  for (std::size_t s = 1; s <= 8; ++s) text += fmt::format(",left_{}_ml", vasculature::segment_name(s));
  text += ",branches_cut\n";
  for (const Json& plan : plans) {
    std::string quoted;
    for (const char letter : name_of(plan)) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    text += "\"" + quoted + "\"";
    for (const char* column : columns) {
      text += ",";
      if (!plan.contains(column)) continue;
      text += plan.at(column).is_boolean() ? (plan.at(column).get<bool>() ? "1" : "0") : figure(plan, column, 3);
    }
    std::array<std::string, 9> left;
    for (const Json& segment : plan.value("segments", Json::array())) {
      left.at(segment.at("number").get<std::size_t>()) = figure(segment, "left_ml", 3);
    }
    for (std::size_t s = 1; s <= 8; ++s) text += "," + left.at(s);
    std::string names;
    for (const Json& branch : plan.value("branches", Json::array())) {
      names += (names.empty() ? "" : "; ") + branch.at("name").get<std::string>();
    }
    text += ",\"" + names + "\"\n";
  }
  return text;
}

namespace {

Table figures(const std::vector<Json>& plans, const Words& words) {
  Table table{
      words.say(GLISSON_TEXT("Per cent are of the liver without its tumours. Thresholds are the surgeon's to set.")),
      {""},
      {}};
  for (const Json& plan : plans) table.columns.push_back(name_of(plan));
  const auto row = [&](const char* text, const auto& cell) {
    std::vector<Cell> cells{{words.say(text)}};
    bool known = false;
    for (const Json& plan : plans) {
      cells.push_back(holds(plan) ? Cell(cell(plan)) : Cell{});
      known = known || !cells.back().text.empty();
    }
    if (known) table.rows.push_back(std::move(cells));
  };
  const auto plain = [](const char* key, int decimals) {
    return [key, decimals](const Json& plan) { return Cell{figure(plan, key, decimals)}; };
  };
  row(GLISSON_TEXT("Removed (ml)"), plain("removed_ml", 0));
  row(GLISSON_TEXT("Left (ml)"), plain("remnant_ml", 0));
  row(GLISSON_TEXT("Left (%)"), plain("remnant_percent", 1));
  row(GLISSON_TEXT("Left and alive: perfused and drained (ml)"), plain("living_ml", 0));
  row(GLISSON_TEXT("Left and alive (%)"), plain("living_percent", 1));
  row(GLISSON_TEXT("Left, of the body's weight (%)"), plain("remnant_percent_of_body_weight", 2));
  row(GLISSON_TEXT("Left and alive, of the body's weight (%)"), plain("living_percent_of_body_weight", 2));
  row(GLISSON_TEXT("Left without inflow: ischaemic (ml)"), plain("ischaemic_ml", 0));
  row(GLISSON_TEXT("Left without outflow: congested (ml)"), plain("congested_ml", 0));
  row(GLISSON_TEXT("Smallest margin (mm)"), [&](const Json& plan) {
    const std::string margin = figure(plan, "margin_mm", 1);
    const bool narrow = !margin.empty() && plan.at("margin_mm").get<double>() < 5;
    return Cell{(plan.value("margin_is_at_least", false) ? "≥ " : "") + margin,
                narrow ? Cell::Emphasis::flag : Cell::Emphasis::none};
  });
  row(GLISSON_TEXT("Tumours cut through or left"), [&](const Json& plan) {
    std::string names;
    for (const Json& tumour : plan.value("tumours", Json::array())) {
      if (tumour.at("side") == "removed") continue;
      names += (names.empty() ? "" : ", ") + words.name(tumour.at("name").get<std::string>());
    }
    return Cell{names.empty() ? "–" : names, names.empty() ? Cell::Emphasis::none : Cell::Emphasis::flag};
  });
  row(GLISSON_TEXT("No worse in margin, tissue and tumours, and better in one"), [](const Json& plan) {
    std::string names;
    for (const Json& better : plan.value("beaten_by", Json::array())) {
      names += (names.empty() ? "" : ", ") + better.get<std::string>();
    }
    return Cell{names};
  });
  row(GLISSON_TEXT("Stiffness of what is left (kPa)"), plain("mean_kPa", 1));
  row(GLISSON_TEXT("Measured share of it (%)"), [](const Json& plan) {
    return Cell{plan.contains("confident_share") ? fmt::format("{:.0f}", 100 * plan.at("confident_share").get<double>())
                                                 : ""};
  });
  return table;
}

Plot margin_against_tissue(const std::vector<Json>& plans, const Words& words) {
  Plot plot{words.say(GLISSON_TEXT("What a wider margin costs.")), words.say(GLISSON_TEXT("smallest margin (mm)")),
            words.say(GLISSON_TEXT("left and alive (ml)"))};
  for (const Json& plan : plans) {
    const char* tissue = plan.contains("living_ml") ? "living_ml" : "functional_remnant_ml";
    if (!holds(plan) || !plan.contains("margin_mm") || !plan.contains(tissue)) continue;
    plot.curves.push_back(
        {name_of(plan), {{plan.at("margin_mm").get<double>(), plan.at(tissue).get<double>()}}, PlotCurve::Style::dots});
  }
  plot.rules.push_back({Rule::Along::x, 5, "5 mm"});
  return plot;
}

// A rectangle a stretch of one colour; rows from the top.
std::string svg_of(const planning::Resectogram& map) {
  const auto colour = [&](int column, int row) -> const char* {
    const double mm = map.at(column, row);
    if (std::isnan(mm)) return nullptr;
    return mm <= 0 ? "#5b2a86" : mm < 5 ? "#c0392b" : mm < 10 ? "#e2a83a" : "#a9c3b0";
  };
  std::string svg = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-4 -4 {0} {1}" width="{2}" height="{3}" shape-rendering="crispEdges" stroke="none">)",
      map.columns + 8, map.rows + 8, 3 * (map.columns + 8), 3 * (map.rows + 8));
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns;) {
      const char* const fill = colour(column, row);
      const int first = column;
      while (column < map.columns && colour(column, row) == fill) ++column;
      if (fill == nullptr) continue;
      svg += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="1" fill="{}"/>)", first, map.rows - 1 - row,
                         column - first, fill);
    }
  }
  static constexpr std::array<const char*, vasculature::all_systems.size()> stroke = {"#1b4f9c", "#1b4f9c", "#b3262a",
                                                                                      "#2d6b3f"};
  for (const planning::Resectogram::Vessel& vessel : map.vessels) {
    svg += fmt::format(
        R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="none" stroke="{}" stroke-width="0.8"><title>{}</title></circle>)",
        vessel.column + 0.5, map.rows - 0.5 - vessel.row, std::max(1.5, vessel.radius_mm / map.step_mm),
        stroke.at(static_cast<std::size_t>(vessel.system)), escaped_markup(vessel.name));
  }
  svg += fmt::format(R"(<path d="M0 {0}h{1}" stroke="#333" stroke-width="1"/>)", map.rows + 2, 20 / map.step_mm);
  return svg + fmt::format(R"(<text x="{}" y="{}" font-size="4" fill="#333">20 mm</text></svg>)", 20 / map.step_mm + 2,
                           map.rows + 3.5);
}

Table segments_left(const std::vector<Json>& plans, const Words& words) {
  Table table{words.say(GLISSON_TEXT("What stays of each segment, in ml.")), {words.say(GLISSON_TEXT("Segment"))}, {}};
  for (const Json& plan : plans) table.columns.push_back(name_of(plan));
  for (std::size_t s = 1; s <= 8; ++s) {
    std::vector<Cell> cells{{vasculature::segment_name(s)}};
    bool known = false;
    for (const Json& plan : plans) {
      cells.emplace_back();
      for (const Json& segment : plan.value("segments", Json::array())) {
        if (segment.at("number") == s) cells.back().text = figure(segment, "left_ml", 0);
      }
      known = known || !cells.back().text.empty();
    }
    if (known) table.rows.push_back(std::move(cells));
  }
  return table;
}

Table branches_cut(const Json& plan, const Words& words) {
  Table table{words.say(GLISSON_TEXT("{0}: branches that are cut, with the tissue beyond the cut; of arteries and bile "
                                     "ducts their own length."),
                        {name_of(plan)}),
              {words.say(GLISSON_TEXT("Branch")), words.say(GLISSON_TEXT("Diameter (mm)")),
               words.say(GLISSON_TEXT("Beyond it")), words.say(GLISSON_TEXT("Of that left"))},
              {}};
  for (const Json& branch : plan.value("branches", Json::array())) {
    const auto told = planning::beyond_cut(branch);
    if (!told) continue;
    table.rows.push_back({{branch.at("name").get<std::string>()},
                          {fmt::format("{:.1f}", 2 * branch.at("radius_mm").get<double>())},
                          {fmt::format("{:.0f} {}", told->beyond, told->unit)},
                          {fmt::format("{:.0f} {}", told->left, told->unit)}});
  }
  return table;
}

}  // namespace
}  // namespace glisson::report
