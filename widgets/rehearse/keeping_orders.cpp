#include "widgets/rehearse/keeping_orders.h"

#include <algorithm>

namespace glisson::widgets {
namespace {

using casefile::Case;

Result<casefile::ComparedOrders> compared_in(const std::filesystem::path& folder, const Progress& progress) {
  const auto patient = Case::open(folder);
  if (!patient) return failure(patient.error());
  const auto kept = casefile::kept_orders(*patient);
  if (!kept) return failure(kept.error());
  return casefile::compare_orders(*patient, *kept, progress);
}

// Opens the case and changes it.
std::function<Result<void>()> on_case(const std::filesystem::path& folder, std::function<Result<void>(Case&)> change) {
  return [folder, change = std::move(change)]() -> Result<void> {
    auto patient = Case::open(folder);
    if (!patient) return failure(std::move(patient.error()));
    return change(*patient);
  };
}

}  // namespace

void connect_orders(KeptOrders& orders, const WorkspaceContext& context) {
  const auto shown_after = [&orders, context](const Result<void>& changed) {
    if (!changed) context.tell_error(changed.error());
    show_kept_orders(orders, context);
  };
  QObject::connect(&orders, &KeptOrders::keep_wanted, &orders, [context, shown_after](const QString& name) {
    if (!context.may_change()) return;
    const bool large = context.rehearsal.deformations() == Deformations::large;
    const casefile::KeptOrder order{name.toStdString(), context.rehearsal.recording(),
                                    large ? mechanics::MaterialLaw::neo_hookean : mechanics::MaterialLaw::linear};
    context.undo.change(
        {GLISSON_TEXT("Keep the steps {0}"), {order.name}}, {},
        on_case(context.patient().folder, [order](Case& patient) { return casefile::keep_order(patient, order); }),
        shown_after);
  });
  QObject::connect(&orders, &KeptOrders::drop_wanted, &orders, [context, shown_after](const QString& name) {
    if (!context.may_change()) return;
    context.undo.change(
        {GLISSON_TEXT("Drop the steps {0}"), {name.toStdString()}}, {},
        on_case(context.patient().folder,
                [name = name.toStdString()](Case& patient) { return casefile::drop_order(patient, name); }),
        shown_after);
  });
  QObject::connect(&orders, &KeptOrders::compare_wanted, &orders, [context, shown_after] {
    if (!context.may_change()) return;
    const std::filesystem::path folder = context.patient().folder;
    context.work.start(
        KeptOrders::tr("Comparing orders of steps"),
        [folder, shown_after, &undo = context.undo](const Progress& progress) -> BackgroundWork::Then {
          auto compared = compared_in(folder, progress);
          Result<void> kept =
              compared
                  ? undo.recorded(
                        {GLISSON_TEXT("Compare orders of steps"), {}},
                        on_case(folder, [&](Case& patient) { return casefile::keep_comparison(patient, *compared); }))
                  : Result<void>(failure(compared.error()));
          return [kept = std::move(kept), shown_after] { shown_after(kept); };
        });
  });
  QObject::connect(&context.undo, &Undo::entries_moved, &orders, [&orders, context](const QStringList& ids) {
    const bool any = std::any_of(ids.begin(), ids.end(),
                                 [](const QString& id) { return id.startsWith("orders/") || id == "results/orders"; });
    if (any) show_kept_orders(orders, context);
  });
}

void show_kept_orders(KeptOrders& orders, const WorkspaceContext& context) {
  const std::filesystem::path& folder = context.patient().folder;
  if (folder.empty()) return orders.show_orders({}, {});
  const auto patient = Case::open(folder);
  if (!patient) return orders.show_orders({}, {});  // whoever opened it has told why
  auto kept = casefile::kept_orders(*patient);
  auto compared = casefile::kept_comparison(*patient);
  if (!kept) context.tell_error(kept.error());
  if (!compared) context.tell_error(compared.error());
  orders.show_orders(kept ? *std::move(kept) : std::vector<casefile::KeptOrder>(),
                     compared ? *std::move(compared) : std::optional<casefile::ComparedOrders>());
}

}  // namespace glisson::widgets
