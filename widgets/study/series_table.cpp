#include "study/series_table.h"

#include <algorithm>
#include <QFutureWatcher>
#include <QHeaderView>
#include <QtConcurrentRun>
#include <QVBoxLayout>

#include "imaging/read_series.h"
#include "session/patient.h"
#include "words/grid_words.h"
#include "words/told.h"
#include "words/worded.h"

namespace glisson::widgets {
namespace {

using imaging::Role;

constexpr int picture_side = 92;
constexpr std::array<Role, 8> choices{Role::anatomy,   Role::mre_stiffness, Role::mre_confidence, Role::mre_magnitude,
                                      Role::mre_phase, Role::mre_wave,      Role::segmentation,   Role::other};
enum Column { what_column, size_column, role_column, problems_column };

// The roles as the headers tell them; where several series have the same, the one of most voxels has it (phases, which
// come a direction a series, all keep theirs). One image of which nothing is known is the anatomy.
std::vector<Role> proposed(const imaging::Study& study) {
  std::vector<Role> roles;
  for (const imaging::Series& series : study.series) roles.push_back(series.role);
  for (const Role role : choices) {
    if (role == Role::mre_phase || role == Role::segmentation || role == Role::other) continue;
    std::size_t best = roles.size();
    for (std::size_t k = 0; k < roles.size(); ++k) {
      if (roles[k] != role) continue;
      const bool better = best == roles.size() || study.series[k].grid.voxels() > study.series[best].grid.voxels();
      const std::size_t worse = better ? best : k;
      if (better) best = k;
      if (worse != roles.size()) roles[worse] = Role::other;
    }
  }
  if (roles.size() == 1 && roles.front() == Role::other) roles.front() = Role::anatomy;
  return roles;
}

}  // namespace

QImage middle_slice(const imaging::Volume& volume, int side) {
  const imaging::Grid& grid = volume.grid;
  const GreyWindow window = usual_window(volume);
  const int k = grid.size[2] / 2;
  QImage slice(grid.size[0], grid.size[1], QImage::Format_Grayscale8);
  for (int j = 0; j < grid.size[1]; ++j) {
    uchar* line = slice.scanLine(j);
    for (int i = 0; i < grid.size[0]; ++i) {
      const double share = (static_cast<double>(volume.at(i, j, k)) - window.center) / window.width + 0.5;
      line[i] = static_cast<uchar>(255 * std::clamp(share, 0.0, 1.0));
    }
  }
  const double tall_mm = grid.size[1] * grid.spacing_mm[1], wide_mm = grid.size[0] * grid.spacing_mm[0];
  const double scale = side / std::max(tall_mm, wide_mm);
  return slice.scaled(std::max(1, static_cast<int>(wide_mm * scale)), std::max(1, static_cast<int>(tall_mm * scale)),
                      Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

SeriesTable::SeriesTable(QWidget* parent) : QTreeWidget(parent), stop_(std::make_shared<std::stop_source>()) {
  setObjectName("series");
  setRootIsDecorated(false);
  setColumnCount(4);
  setIconSize({picture_side, picture_side});
  setSelectionMode(QAbstractItemView::NoSelection);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setWordWrap(true);
  header()->setStretchLastSection(true);
  header()->setSectionResizeMode(what_column, QHeaderView::Stretch);
  header()->setSectionResizeMode(size_column, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(role_column, QHeaderView::Fixed);
  header()->resizeSection(role_column, 190);
  header()->setSectionResizeMode(problems_column, QHeaderView::Stretch);
  painters_.setMaxThreadCount(1);
  worded(this, [this] { word(); });
}

SeriesTable::~SeriesTable() {
  stop_->request_stop();
  painters_.waitForDone();
}

void SeriesTable::show_study(std::shared_ptr<const imaging::Study> study) {
  stop_->request_stop();
  stop_ = std::make_shared<std::stop_source>();
  clear();
  roles_.clear();
  study_ = std::move(study);
  const std::vector<Role> proposals = proposed(*study_);
  for (const Role proposal : proposals) {
    auto* row = new QTreeWidgetItem(this);
    QPixmap blank(picture_side, picture_side);
    blank.fill(Qt::black);
    row->setIcon(what_column, QIcon(blank));
    auto* choice = new QComboBox;
    choice->setObjectName(QString("role_%1").arg(roles_.size()));
    choice->addItems(QStringList(static_cast<int>(choices.size()), QString()));
    choice->setCurrentIndex(static_cast<int>(std::find(choices.begin(), choices.end(), proposal) - choices.begin()));
    choice->setFocusPolicy(Qt::StrongFocus);
    connect(choice, &QComboBox::currentIndexChanged, this, &SeriesTable::roles_changed);
    auto* holder = new QWidget;
    auto* middle = new QVBoxLayout(holder);
    middle->setContentsMargins(6, 0, 6, 0);
    middle->addWidget(choice, 0, Qt::AlignVCenter);
    setItemWidget(row, role_column, holder);
    roles_.push_back(choice);
  }
  word();
  make_pictures();
  Q_EMIT roles_changed();
}

std::vector<casefile::SeriesRole> SeriesTable::roles() const {
  std::vector<casefile::SeriesRole> all;
  for (std::size_t k = 0; k < roles_.size(); ++k) {
    all.push_back({study_->series[k].uid, choices.at(static_cast<std::size_t>(roles_[k]->currentIndex()))});
  }
  return all;
}

int SeriesTable::chosen() const {
  const auto all = roles();
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [](const casefile::SeriesRole& one) { return one.role != Role::other; }));
}

void SeriesTable::word() {
  setHeaderLabels({tr("Series"), tr("Size and spacing"), tr("Use as"), tr("Remarks")});
  const std::array<QString, 8> names{tr("Anatomy"),   tr("Stiffness (kPa)"), tr("Confidence"),   tr("MRE magnitude"),
                                     tr("MRE phase"), tr("MRE waves"),       tr("Segmentation"), tr("Leave out")};
  for (std::size_t k = 0; k < roles_.size(); ++k) {
    const imaging::Series& series = study_->series[k];
    QTreeWidgetItem* row = topLevelItem(static_cast<int>(k));
    const QString description =
        series.description.empty() ? tr("Without a description") : QString::fromStdString(series.description);
    row->setText(what_column, QString("%1\n%2").arg(description, QString::fromStdString(series.modality)));
    QString extent = size_words(series.grid) + "\n" + spacing_words(series.grid);
    if (series.volumes > 1) extent += "\n" + tr("%1 volumes").arg(series.volumes);
    row->setText(size_column, extent);
    QStringList remarks;
    for (const std::string& problem : series.problems) remarks << told(problem);
    row->setText(problems_column, remarks.join("\n"));
    row->setToolTip(problems_column, remarks.join("\n"));
    row->setToolTip(what_column, QString::fromStdString(series.role_evidence));
    for (int n = 0; n < roles_[k]->count(); ++n) roles_[k]->setItemText(n, names[static_cast<std::size_t>(n)]);
    roles_[k]->setAccessibleName(tr("Use %1 as").arg(description));
    roles_[k]->setToolTip(tr("What this series is for. The proposal is read from its header."));
  }
}

// One after the other, on a worker.
void SeriesTable::make_pictures() {
  for (int k = 0; k < static_cast<int>(study_->series.size()); ++k) {
    auto* watcher = new QFutureWatcher<QImage>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, k, study = study_] {
      watcher->deleteLater();
      const QImage picture = watcher->result();
      if (study != study_ || picture.isNull()) return;
      topLevelItem(k)->setIcon(what_column, QIcon(QPixmap::fromImage(picture)));
    });
    watcher->setFuture(QtConcurrent::run(&painters_, [study = study_, k, stop = stop_]() -> QImage {
      const imaging::Series& series = study->series[static_cast<std::size_t>(k)];
      if (stop->stop_requested() || series.role == Role::segmentation) return {};
      const auto volume = imaging::read_series(series, 0, Progress({}, stop->get_token()));
      return volume ? middle_slice(*volume, picture_side) : QImage();
    }));
  }
}

}  // namespace glisson::widgets
