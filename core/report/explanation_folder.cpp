#include "report/explanation_folder.h"

#include "base/files.h"
#include "closedloop/explanation_file.h"
#include "report/explanation_page.h"
#include "report/html.h"

namespace glisson::report {

Result<void> write_explanation(const std::filesystem::path& folder, const closedloop::Explained& explained) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure("file-not-writable", GLISSON_TEXT("The folder {0} cannot be made: {1}."),
                   {folder.string(), problem.message()});
  }
  const closedloop::Observations& observations = explained.model->observations();
  return write_text_file(folder / "report.json", closedloop::report_text(explained.explanation, observations))
      .and_then([&] {
        return write_text_file(folder / "model.json",
                               closedloop::model_text(explained.explanation, *explained.model, explained.experiment));
      })
      .and_then([&] {
        return write_html(folder / "report.html",
                          explanation_page(explained.explanation, observations, explained.experiment.title));
      });
}

}  // namespace glisson::report
