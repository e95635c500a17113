#include "report/orders_page.h"

#include <fmt/format.h>
#include <cmath>

#include "base/json.h"
#include "rehearsal/comparison.h"
#include "report/words.h"

namespace glisson::report {
namespace {

using rehearsal::OrderOfSteps;

std::string at_step(const rehearsal::Worst& worst, int decimals, double factor = 1) {
  return worst.step == 0 ? "" : fmt::format("{:.{}f} (step {})", factor * worst.value, decimals, worst.step);
}

std::string list_of(const std::vector<std::size_t>& steps) { return fmt::format("{}", fmt::join(steps, ", ")); }

// A row a quantity, a column an order.
Table figures(const std::vector<OrderOfSteps>& orders);
Plot step_by_step(const std::vector<OrderOfSteps>& orders, std::vector<double> OrderOfSteps::*values,
                  std::string caption, std::string y_title);

}  // namespace

Page orders_page(const std::vector<OrderOfSteps>& orders, const std::string& origin,
                 const std::vector<std::string>& remarks) {
  Page page;
  page.title = "Orders of steps compared";
  page.warning = origin;
  for (const std::string& remark : remarks) page.blocks.push_back(Paragraph{remark});
  page.blocks.push_back(figures(orders));
  Plot moves = step_by_step(orders, &OrderOfSteps::largest_move_mm, "How far the landmark moves that moves most",
                            "displacement (mm)");
  moves.rules.push_back({Rule::Along::y, rehearsal::significant_mm, "5 mm"});
  page.blocks.push_back(std::move(moves));
  page.blocks.push_back(step_by_step(orders, &OrderOfSteps::force_N, "The largest force of any one tool", "force (N)"));
  return page;
}

Json json_of(const OrderOfSteps& order) {
  const auto put = [](Json& json, const std::string& name, const rehearsal::Worst& worst) {
    json[name] = worst.step == 0 ? Json() : Json(worst.value);
    json[name + "_at_step"] = worst.step == 0 ? Json() : Json(worst.step);
  };
  Json json{{"name", order.name},         {"steps", order.force_N.size()},
            {"open_mm2", order.open_mm2}, {"bridge_mm2", order.bridge_mm2},
            {"refused", order.refused},   {"unusable", order.unusable},
            {"landmarks", Json::array()}};
  put(json, "largest_force_N", order.largest_force_N);
  put(json, "largest_strain", order.largest_strain);
  put(json, "vessel_strain", order.vessel_strain.value_or(rehearsal::Worst{}));
  for (const rehearsal::LandmarkMove& landmark : order.landmarks) {
    Json& entry = json["landmarks"].emplace_back(Json{{"id", landmark.id}, {"end_mm", landmark.end_mm}});
    put(entry, "largest_mm", landmark.largest_mm);
  }
  return json;
}

namespace {

Table figures(const std::vector<OrderOfSteps>& orders) {
  Table table{"What each order asks of the liver at its worst", {""}, {}};
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
      "steps", [](const OrderOfSteps& order) { return std::to_string(order.force_N.size()); }, plain);
  const std::size_t landmarks = orders.empty() ? 0 : orders.front().landmarks.size();
  for (std::size_t l = 0; l < landmarks; ++l) {
    const std::string name = plain_name(orders.front().landmarks[l].id);
    row(
        name + ", largest displacement (mm)",
        [l](const OrderOfSteps& order) { return at_step(order.landmarks[l].largest_mm, 1); },
        [l](const OrderOfSteps& order) {
          return order.landmarks[l].largest_mm.value >= rehearsal::significant_mm ? Cell::Emphasis::flag
                                                                                  : Cell::Emphasis::none;
        });
    row(
        name + ", at the end (mm)",
        [l](const OrderOfSteps& order) { return fmt::format("{:.1f}", order.landmarks[l].end_mm); }, plain);
  }
  row(
      "largest force of one tool (N)", [](const OrderOfSteps& order) { return at_step(order.largest_force_N, 2); },
      plain);
  row(
      "largest strain (%)", [](const OrderOfSteps& order) { return at_step(order.largest_strain, 0, 100); }, plain);
  row(
      "strain of vessel walls, 95 of 100 below (%)",
      [](const OrderOfSteps& order) {
        return order.vessel_strain ? at_step(*order.vessel_strain, 1, 100) : std::string();
      },
      plain);
  row(
      "cut open at the end (cm2)",
      [](const OrderOfSteps& order) {
        return order.open_mm2 > 0 ? fmt::format("{:.1f}", 1e-2 * order.open_mm2) : std::string();
      },
      plain);
  row(
      "steps that could not be carried out", [](const OrderOfSteps& order) { return list_of(order.refused); }, flagged);
  row(
      "steps not to be used", [](const OrderOfSteps& order) { return list_of(order.unusable); }, flagged);
  return table;
}

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
