#include "report/explanation_folder.h"

#include "base/json.h"
#include "base/write_file.h"
#include "closedloop/explanation_file.h"
#include "closedloop/next_trials_file.h"
#include "closedloop/posterior_history.h"
#include "closedloop/where_it_holds.h"
#include "report/html.h"
#include "report/internal/explanation_page.h"

namespace glisson::report {

Result<void> write_explanation(const std::filesystem::path& folder, const closedloop::Explained& explained,
                               const Words& words) {
  const closedloop::Observations& observations = explained.model->observations();
  const auto history = closedloop::history_after(folder / "report.json", explained.explanation, observations);
  const Json report = closedloop::report_json(explained.explanation, observations, history);
  return write_together([&] {
    return write_file(folder / "report.json", report.dump(2) + "\n")
        .and_then([&] {
          return write_file(folder / "model.json",
                            closedloop::model_text(explained.explanation, *explained.model, explained.experiment));
        })
        .and_then([&] {
          return write_file(
              folder / "next_trials.json",
              closedloop::next_trials_json(explained.explanation.next, explained.experiment).dump(2) + "\n");
        })
        .and_then([&] {
          return write_html(folder / "report.html", explanation_page(explained.explanation, observations,
                                                                     explained.experiment.title, words, history));
        })
        .and_then([&]() -> Result<void> {
          if (!closedloop::has_where_it_holds(explained.experiment)) return {};
          return closedloop::write_where_it_holds(folder, explained);
        });
  });
}

}  // namespace glisson::report
