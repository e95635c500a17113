#include "widgets/resect/kept_cuts.h"

#include "base/json.h"
#include "planning/plan_file.h"

namespace glisson::widgets {

using planning::Cut;

QJsonValue value_of(const std::vector<Cut>& cuts) {
  if (cuts.empty()) return QJsonValue::Null;
  return QString::fromStdString(planning::plan_json({"taken", cuts}).dump());
}

std::vector<Cut> cuts_of(const QJsonValue& value) {
  const Json document = Json::parse(value.toString().toStdString(), nullptr, false);
  if (document.is_discarded()) return {};
  const auto plan = planning::plan_from(document);
  return plan ? plan->cuts : std::vector<Cut>();
}

}  // namespace glisson::widgets
