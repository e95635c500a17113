#include "widgets/help/manual_pages.h"

#include <map>

namespace glisson::widgets {

QString manual_page_of(const QString& workspace_id) {
  static const std::map<QString, QString> pages{
      {"study", "02-images"},  {"segment", "03-structures"}, {"model", "04-model"},       {"rehearse", "05-rehearse"},
      {"resect", "06-resect"}, {"register", "07-register"},  {"platform", "08-platform"}, {"evidence", "09-evidence"},
      {"report", "13-report"}, {"guide", "14-guide"},        {"studies", "15-studies"}};
  const auto found = pages.find(workspace_id);
  return found != pages.end() ? found->second : QString("01-start");
}

}  // namespace glisson::widgets
