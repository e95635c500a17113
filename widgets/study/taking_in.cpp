#include "widgets/study/taking_in.h"

#include <algorithm>
#include <QMessageBox>
#include <QPushButton>

#include "casefile/label_map.h"
#include "widgets/session/load_patient.h"
#include "widgets/study/label_names_dialog.h"
#include "widgets/words/paths.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;
using casefile::SeriesRole;

const imaging::Series* series_of(const imaging::Study& study, const SeriesRole& role) {
  const auto found =
      std::find_if(study.series.begin(), study.series.end(), [&](const auto& one) { return one.uid == role.uid; });
  return found == study.series.end() ? nullptr : &*found;
}

// A map of which nothing says what it holds.
struct Unnamed {
  std::size_t role;
  std::vector<casefile::LabelledPart> parts;
};

}  // namespace

struct TakingIn::Asked {
  imaging::Study study;
  std::vector<SeriesRole> roles;
  fs::path folder;
  std::vector<Unnamed> unnamed;
  std::vector<Sentence> doubts;
  bool replaces = false;
};

TakingIn::TakingIn(const WorkspaceContext& context, QWidget* parent)
    : QObject(parent), context_(context), window_(parent) {}

void TakingIn::take(const imaging::Study& study, std::vector<SeriesRole> roles, const fs::path& folder) {
  Asked asked{study, std::move(roles), folder, {}, {}, false};
  context_.work.start(tr("Looking at the labels"),
                      [this, asked = std::move(asked)](const Progress& progress) mutable -> BackgroundWork::Then {
                        std::size_t named = 0;
                        for (std::size_t k = 0; k < asked.roles.size() && !progress.cancelled(); ++k) {
                          const imaging::Series* series = series_of(asked.study, asked.roles[k]);
                          if (asked.roles[k].role != imaging::Role::segmentation || series == nullptr) continue;
                          if (!casefile::is_label_map(*series)) continue;
                          const auto map = casefile::read_label_map(series->files.front());
                          if (!map) continue;  // the import says why
                          const bool any = std::any_of(map->parts.begin(), map->parts.end(),
                                                       [](const auto& part) { return !part.structure.empty(); });
                          named += any ? 1 : 0;
                          if (!any) asked.unnamed.push_back({k, map->parts});
                        }
                        // Of a folder of masks those that are named are wanted; one that nobody named is then left out.
                        constexpr std::size_t maximum_questions = 4;
                        if (named > 0 && asked.unnamed.size() > maximum_questions) asked.unnamed.clear();
                        if (const auto patient = casefile::Case::open(asked.folder)) {
                          asked.doubts = casefile::doubts_of_belonging(*patient, asked.study, asked.roles);
                          asked.replaces = casefile::would_replace_anatomy(*patient, asked.roles);
                        }
                        return [this, asked = std::move(asked)] { ask(asked); };
                      });
}

void TakingIn::ask(Asked asked) {
  for (const Unnamed& map : asked.unnamed) {
    SeriesRole& role = asked.roles[map.role];
    const imaging::Series* series = series_of(asked.study, role);
    LabelNamesDialog dialog(text_of(series->files.front().filename()), map.parts, window_);
    if (dialog.exec() != QDialog::Accepted) return;
    role.label_names = dialog.names();
  }
  const bool doubtful = !asked.doubts.empty();
  if (doubtful || asked.replaces) {
    QStringList words;
    if (asked.replaces) {
      words
          << tr("The case %1 has an anatomy already. These images would replace it; what was outlined and modelled on "
                "it then no longer fits.")
                 .arg(text_of(asked.folder.stem()));
    }
    for (const Sentence& doubt : asked.doubts) words << translated(doubt);
    QMessageBox question(QMessageBox::Warning, asked.replaces ? tr("Replace the anatomy?") : tr("Is it this patient?"),
                         words.join("\n\n"), QMessageBox::Cancel, window_);
    question.setObjectName("belonging_question");
    QPushButton* go =
        question.addButton(asked.replaces ? tr("Replace") : tr("Add all the same"), QMessageBox::DestructiveRole);
    go->setObjectName("belonging_go");
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    if (question.clickedButton() != go) return;
  }
  const fs::path folder = asked.folder;
  Q_EMIT begun(folder);
  const auto import = [asked = std::move(asked)](const Progress& progress) {
    return import_patient(asked.study, asked.roles, asked.folder, progress, casefile::Replacing::wanted);
  };
  if (folder == context_.patient().folder) {
    context_.change(tr("Importing"), import);
  } else {
    context_.open(tr("Importing"), import);
  }
}

}  // namespace glisson::widgets
