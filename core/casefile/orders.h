#pragma once
// Orders of steps of a rehearsal, kept in the case, and what each asks of the liver.
//
//   orders/NAME       the commands as they were recorded, glisson-session/1 (rehearsal/session.h)
//   results/orders    the kept orders side by side, glisson-orders/1, as they were compared last
//
// Both are made from the model: where that changes they are stale.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/sentence.h"
#include "casefile/case.h"
#include "mechanics/scenario/scenario.h"
#include "rehearsal/orders.h"

namespace glisson::casefile {

struct KeptOrder {
  std::string name;
  rehearsal::Recording recording;
  mechanics::MaterialLaw law = mechanics::MaterialLaw::linear;  // that it was recorded with
};

// In the order in which they came. Fails where a file is gone or damaged.
Result<std::vector<KeptOrder>> kept_orders(const Case& patient);

// Replaces an order of that name. Fails with "order-empty": nothing was done in it.
Result<void> keep_order(Case& patient, const KeptOrder& order);

// With the comparison that it stood in. Fails with "order-unknown".
Result<void> drop_order(Case& patient, const std::string& name);

struct ComparedOrders {
  std::vector<rehearsal::OrderOfSteps> orders;
  mechanics::MaterialLaw law = mechanics::MaterialLaw::linear;  // of all of them
  std::vector<Sentence> remarks;                                // what to know before trusting it
};

// What to know of the case's model before trusting orders that run on it.
[[nodiscard]] std::vector<Sentence> orders_remarks(const Case& patient);

// A rehearsal of the case with its structures, and which of them are vessels: what orders are run on.
struct OrdersQuestion {
  rehearsal::RehearsalSetup setup;
  std::vector<std::size_t> vessels;
  std::vector<Sentence> remarks;
};
Result<OrdersQuestion> orders_question(const Case& patient);

// Each from the liver at rest, all with the first law of large deformations where one was recorded with one. Failures:
// "orders-missing" (none to compare), those of the model's reading, of a rehearsal and "cancelled".
Result<ComparedOrders> compare_orders(const Case& patient, const std::vector<KeptOrder>& orders,
                                      const Progress& progress = {});

Result<void> keep_comparison(Case& patient, const ComparedOrders& compared);
// Nothing where none was kept. With a remark where it is stale.
Result<std::optional<ComparedOrders>> kept_comparison(const Case& patient);

}  // namespace glisson::casefile
