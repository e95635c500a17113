#include "casefile/orders.h"

#include <algorithm>

#include "base/files.h"
#include "base/json_reading.h"
#include "base/write_file.h"
#include "casefile/label_map.h"
#include "casefile/model.h"
#include "casefile/model_upkeep.h"
#include "casefile/resection_folder.h"
#include "casefile/used_entries.h"
#include "mechanics/scenario/scenario_file.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using mechanics::MaterialLaw;

constexpr const char* orders_folder = "orders/";
constexpr const char* comparison_id = "results/orders";
constexpr const char* orders_format = "glisson-orders/1";
constexpr const char* name_option = "name";
constexpr const char* material_option = "material";
constexpr std::uint64_t largest_file = std::uint64_t{64} << 20;

// Linear where nothing is said that is known.
MaterialLaw law_of(const std::string& name) { return mechanics::law_named(name).value_or(MaterialLaw::linear); }

std::string option_of(const Entry& entry, const char* option) {
  const auto found = entry.made.options.find(option);
  return found == entry.made.options.end() ? std::string() : found->second;
}

bool is_order(const Entry& entry) { return entry.id.starts_with(orders_folder); }

// The entry of that name, or a new one that no other order has.
std::string order_id(const Case& patient, const std::string& name) {
  std::string simple = structure_name(name);
  if (simple.empty()) simple = "order";
  for (int n = 1;; ++n) {
    const std::string id = orders_folder + simple + (n == 1 ? "" : "-" + std::to_string(n));
    const Entry* there = patient.find(id);
    if (there == nullptr || option_of(*there, name_option) == name) return id;
  }
}

Json comparison_json(const ComparedOrders& compared) {
  Json json{{"format", orders_format}, {"material", mechanics::name_of(compared.law)}, {"orders", Json::array()}};
  for (const rehearsal::OrderOfSteps& order : compared.orders) json["orders"].push_back(rehearsal::json_of(order));
  return json;
}

ComparedOrders comparison_from(const Json& json) {
  const std::string where = "the document";
  if (text_in(required(json, "format", where), where + ", format") != orders_format)
    refuse_at("format", GLISSON_TEXT("{0} must be \"glisson-orders/1\"."));
  const std::string material = text_in(required(json, "material", where), where + ", material");
  return {list_of(json, "orders", "order", rehearsal::order_from), law_of(material), {}};
}

}  // namespace

Result<std::vector<KeptOrder>> kept_orders(const Case& patient) {
  std::vector<KeptOrder> orders;
  for (const Entry& entry : patient.entries()) {
    if (!is_order(entry)) continue;
    const fs::path file = patient.folder() / entry.file;
    auto recording = read_text_file(file, largest_file).and_then([&](const std::string& text) {
      return rehearsal::parse_recording(text, file);
    });
    if (!recording) return failure(std::move(recording.error()));
    const std::string name = option_of(entry, name_option);
    orders.push_back({name.empty() ? entry.id.substr(std::string(orders_folder).size()) : name, *std::move(recording),
                      law_of(option_of(entry, material_option))});
  }
  return orders;
}

Result<void> keep_order(Case& patient, const KeptOrder& order) {
  if (order.recording.empty()) {
    return failure(Error{"order-empty",
                         GLISSON_TEXT("There are no steps to keep as {0}."),
                         {order.name},
                         GLISSON_TEXT("Move a rigid tool or advance a cut first."),
                         {}});
  }
  const Provenance made{"session",
                        {{name_option, order.name}, {material_option, mechanics::name_of(order.law)}},
                        {"meshes/model"},
                        {},
                        {}};
  return patient.add(order_id(patient, order.name), ".json", made, [&](const fs::path& file) {
    return write_file(file, rehearsal::recording_text(order.recording));
  });
}

Result<void> drop_order(Case& patient, const std::string& name) {
  const std::string id = order_id(patient, name);
  if (patient.find(id) == nullptr)
    return failure("order-unknown", GLISSON_TEXT("The case has no order of steps {0}."), {name});
  return patient.together([&] {
    return patient.remove(id).and_then(
        [&] { return patient.find(comparison_id) == nullptr ? Result<void>() : patient.remove(comparison_id); });
  });
}

std::vector<Sentence> orders_remarks(const Case& patient) {
  std::vector<Sentence> remarks = model_remarks(patient);
  if (auto assumed = assumed_stiffness(patient)) remarks.push_back(*std::move(assumed));
  return remarks;
}

Result<OrdersQuestion> orders_question(const Case& patient) {
  auto model = read_model(patient);
  if (!model) return failure(std::move(model.error()));
  OrdersQuestion question{{}, {}, orders_remarks(patient)};
  std::vector<geometry::Surface> structures;
  for (const StructureSurface& structure : model->structures) {
    if (resection_kind(structure.name) == rehearsal::StructureKind::vessel)
      question.vessels.push_back(structures.size());
    structures.push_back(structure.surface);
  }
  question.setup = rehearsal_setup(std::move(*model));
  question.setup.structures = std::move(structures);
  return question;
}

Result<ComparedOrders> compare_orders(const Case& patient, const std::vector<KeptOrder>& orders,
                                      const Progress& progress) {
  if (orders.empty()) {
    return failure(Error{"orders-missing",
                         GLISSON_TEXT("There is no order of steps to compare."),
                         {},
                         GLISSON_TEXT("Keep the steps of a rehearsal first."),
                         {}});
  }
  progress.report(0.0, GLISSON_TEXT("Reading the model"));
  auto question = orders_question(patient);
  if (!question) return failure(std::move(question.error()));
  const auto large = std::find_if(orders.begin(), orders.end(),
                                  [](const KeptOrder& order) { return order.law != MaterialLaw::linear; });
  ComparedOrders compared{{}, large == orders.end() ? MaterialLaw::linear : large->law, std::move(question->remarks)};
  question->setup.law.law = compared.law;
  std::vector<rehearsal::NamedRecording> recordings;
  for (const KeptOrder& order : orders) recordings.push_back({order.name, order.recording});
  auto run = rehearsal::run_orders(std::move(question->setup), question->vessels, recordings, progress);
  if (!run) return failure(std::move(run.error()));
  compared.orders = *std::move(run);
  return compared;
}

Result<void> keep_comparison(Case& patient, const ComparedOrders& compared) {
  Provenance made{
      "session", {{material_option, mechanics::name_of(compared.law)}}, {"meshes/model"}, {}, compared.remarks};
  for (const Entry& entry : patient.entries()) {
    if (is_order(entry)) made.from.push_back(entry.id);
  }
  return patient.add(comparison_id, ".json", std::move(made),
                     [&](const fs::path& file) { return write_json_file(file, comparison_json(compared)); });
}

Result<std::optional<ComparedOrders>> kept_comparison(const Case& patient) {
  const Entry* entry = patient.find(comparison_id);
  if (entry == nullptr) return std::nullopt;
  const fs::path file = patient.folder() / entry->file;
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  auto compared = reading("orders-invalid", file, [&] { return comparison_from(*document); });
  if (!compared) return failure(std::move(compared.error()));
  compared->remarks = entry->made.notes;
  for (Sentence& remark : remarks_on(patient, {comparison_id})) compared->remarks.push_back(std::move(remark));
  return std::optional(*std::move(compared));
}

}  // namespace glisson::casefile
