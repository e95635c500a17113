#include "report/orders_page.h"

#include <fmt/format.h>
#include <cmath>

#include "rehearsal/comparison.h"

namespace glisson::report {
namespace {

using rehearsal::OrderOfSteps;

std::string at_step(const rehearsal::Worst& worst, const Words& words, int decimals, double factor = 1) {
  if (worst.step == 0) return "";
  return words.say(GLISSON_TEXT("{0} (step {1})"),
                   {fmt::format("{:.{}f}", factor * worst.value, decimals), std::to_string(worst.step)});
}

std::string list_of(const std::vector<std::size_t>& steps) { return fmt::format("{}", fmt::join(steps, ", ")); }

Plot step_by_step(const std::vector<OrderOfSteps>& orders, std::vector<double> OrderOfSteps::*values,
                  std::string caption, std::string y_title);

}  // namespace

Page orders_page(const std::vector<OrderOfSteps>& orders, const std::string& origin,
                 const std::vector<std::string>& remarks) {
  Page page;
  page.title = "Orders of steps compared";
  page.warning = origin;
  for (const std::string& remark : remarks) page.blocks.push_back(Paragraph{remark});
  page.blocks.push_back(orders_table(orders, {}));
  Plot moves = step_by_step(orders, &OrderOfSteps::largest_move_mm, "How far the landmark moves that moves most",
                            "displacement (mm)");
  moves.rules.push_back({Rule::Along::y, rehearsal::significant_mm, "5 mm"});
  page.blocks.push_back(std::move(moves));
  page.blocks.push_back(step_by_step(orders, &OrderOfSteps::force_N, "The largest force of any one tool", "force (N)"));
  return page;
}

Table orders_table(const std::vector<OrderOfSteps>& orders, const Words& words) {
  Table table{words.say(GLISSON_TEXT("What each order asks of the liver at its worst")), {""}, {}};
  for (const OrderOfSteps& order : orders) table.columns.push_back(order.name);
  const auto row = [&](const std::string& name, const auto& text, const auto& emphasis) {
    std::vector<Cell> cells{{name}};
    bool any = false;
    for (const OrderOfSteps& order : orders) {
      cells.push_back({text(order), emphasis(order)});
      any = any || !cells.back().text.empty();
    }
    if (any) table.rows.push_back(std::move(cells));
  };
  const auto plain = [](const OrderOfSteps&) { return Cell::Emphasis::none; };
  const auto flagged = [](const OrderOfSteps&) { return Cell::Emphasis::flag; };
  row(
      words.say(GLISSON_TEXT("steps")), [](const OrderOfSteps& order) { return std::to_string(order.force_N.size()); },
      plain);
  const std::size_t landmarks = orders.empty() ? 0 : orders.front().landmarks.size();
  for (std::size_t l = 0; l < landmarks; ++l) {
    const std::string name = words.name(orders.front().landmarks[l].id);
    const auto known = [l](const OrderOfSteps& order) { return l < order.landmarks.size(); };
    row(
        words.say(GLISSON_TEXT("{0}, largest displacement (mm)"), {name}),
        [&](const OrderOfSteps& order) {
          return known(order) ? at_step(order.landmarks[l].largest_mm, words, 1) : std::string();
        },
        [&](const OrderOfSteps& order) {
          return known(order) && order.landmarks[l].largest_mm.value >= rehearsal::significant_mm
                     ? Cell::Emphasis::flag
                     : Cell::Emphasis::none;
        });
    row(
        words.say(GLISSON_TEXT("{0}, at the end (mm)"), {name}),
        [&](const OrderOfSteps& order) {
          return known(order) ? fmt::format("{:.1f}", order.landmarks[l].end_mm) : std::string();
        },
        plain);
  }
  row(
      words.say(GLISSON_TEXT("largest force of one tool (N)")),
      [&](const OrderOfSteps& order) { return at_step(order.largest_force_N, words, 2); }, plain);
  row(
      words.say(GLISSON_TEXT("largest strain (%)")),
      [&](const OrderOfSteps& order) { return at_step(order.largest_strain, words, 0, 100); }, plain);
  row(
      words.say(GLISSON_TEXT("strain of vessel walls, 95 of 100 below (%)")),
      [&](const OrderOfSteps& order) {
        return order.vessel_strain ? at_step(*order.vessel_strain, words, 1, 100) : std::string();
      },
      plain);
  row(
      words.say(GLISSON_TEXT("cut open at the end (cm2)")),
      [](const OrderOfSteps& order) {
        return order.open_mm2 > 0 ? fmt::format("{:.1f}", 1e-2 * order.open_mm2) : std::string();
      },
      plain);
  row(
      words.say(GLISSON_TEXT("steps that could not be carried out")),
      [](const OrderOfSteps& order) { return list_of(order.refused); }, flagged);
  row(
      words.say(GLISSON_TEXT("steps not to be used")),
      [](const OrderOfSteps& order) { return list_of(order.unusable); }, flagged);
  return table;
}

namespace {

Plot step_by_step(const std::vector<OrderOfSteps>& orders, std::vector<double> OrderOfSteps::*values,
                  std::string caption, std::string y_title) {
  Plot plot{std::move(caption), "step", std::move(y_title)};
  for (const OrderOfSteps& order : orders) {
    PlotCurve curve{order.name, {}};
    for (std::size_t i = 0; i < (order.*values).size(); ++i) {
      if (std::isfinite((order.*values)[i])) curve.points.emplace_back(double(i + 1), (order.*values)[i]);
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace
}  // namespace glisson::report
