#include "widgets/study/series_table.h"

#include <algorithm>
#include <QHeaderView>
#include <QPainter>
#include <QVBoxLayout>

#include "imaging/dicom_seg.h"
#include "imaging/read_series.h"
#include "segmentation/structures.h"
#include "widgets/views/grey_window.h"
#include "widgets/words/grid_words.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/translated.h"
#include "widgets/work/run_in_background.h"

namespace glisson::widgets {
namespace {

using imaging::Role;

constexpr int picture_side = 92;
constexpr std::array<Role, 8> choices{Role::anatomy,   Role::mre_stiffness, Role::mre_confidence, Role::mre_magnitude,
                                      Role::mre_phase, Role::mre_wave,      Role::segmentation,   Role::other};
enum Column { what_column, size_column, role_column, problems_column };

// Of several patients' label maps those of the chosen anatomy.
void leave_out_others_labels(const imaging::Study& study, std::vector<Role>& roles) {
  const auto anatomy = std::find(roles.begin(), roles.end(), Role::anatomy);
  if (anatomy == roles.end()) return;
  const auto fitting = casefile::label_maps_on(study, study.series[static_cast<std::size_t>(anatomy - roles.begin())]);
  for (std::size_t k = 0; k < roles.size(); ++k) {
    const bool fits = std::find(fitting.begin(), fitting.end(), k) != fitting.end();
    if (roles[k] == Role::segmentation && casefile::is_label_map(study.series[k]) && !fits) roles[k] = Role::other;
  }
}

// In the middle of a square, so that no row of the table changes its height when its picture comes.
QPixmap on_square(const QImage& picture) {
  QPixmap square(picture_side, picture_side);
  square.fill(Qt::black);
  if (picture.isNull()) return square;
  QPainter painter(&square);
  painter.drawImage((picture_side - picture.width()) / 2, (picture_side - picture.height()) / 2, picture);
  return square;
}

// As wide and tall as it is in the body.
QImage in_proportion(const QImage& slice, const imaging::Grid& grid, int side, Qt::TransformationMode mode) {
  const double tall_mm = grid.size[1] * grid.spacing_mm[1], wide_mm = grid.size[0] * grid.spacing_mm[0];
  const double scale = side / std::max(tall_mm, wide_mm);
  // The front above and the right side left, however a transverse slice lies in its file.
  return slice.mirrored(grid.direction(0, 0) < 0, grid.direction(1, 1) < 0)
      .scaled(std::max(1, static_cast<int>(wide_mm * scale)), std::max(1, static_cast<int>(tall_mm * scale)),
              Qt::IgnoreAspectRatio, mode);
}

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
  leave_out_others_labels(study, roles);
  return roles;
}

// Of a DICOM SEG, whose segments are masks on one grid: the slice that most of them fill.
QImage segment_slice(const std::filesystem::path& file, int side) {
  const auto segments = imaging::read_dicom_seg(file);
  if (!segments || segments->empty()) return {};
  const imaging::Grid& grid = segments->front().mask.grid;
  casefile::ReadLabelMap map;
  map.labels.grid = grid;
  map.labels.values.assign(grid.voxels(), 0);
  for (std::size_t k = 0; k < segments->size(); ++k) {
    const imaging::SegmentedMask& segment = (*segments)[k];
    const auto value = static_cast<std::uint16_t>(k + 1);
    for (std::size_t voxel = 0; voxel < segment.mask.values.size(); ++voxel) {
      if (segment.mask.values[voxel] != 0) map.labels.values[voxel] = value;
    }
    map.parts.push_back({value, segment.info.name, casefile::usual_structure_name(segment.info.name), 0});
  }
  return label_slice(map, side);
}

}  // namespace

QImage middle_slice(const imaging::Volume& volume, int side) {
  const imaging::Grid& grid = volume.grid;
  const GreyWindow window = first_window(volume);
  const int k = grid.size[2] / 2;
  QImage slice(grid.size[0], grid.size[1], QImage::Format_Grayscale8);
  for (int j = 0; j < grid.size[1]; ++j) {
    uchar* line = slice.scanLine(j);
    for (int i = 0; i < grid.size[0]; ++i) {
      const double share = (static_cast<double>(volume.at(i, j, k)) - window.center) / window.width + 0.5;
      line[i] = static_cast<uchar>(255 * std::clamp(share, 0.0, 1.0));
    }
  }
  return in_proportion(slice, grid, side, Qt::SmoothTransformation);
}

QImage label_slice(const casefile::ReadLabelMap& map, int side) {
  const imaging::Grid& grid = map.labels.grid;
  const auto per_slice = static_cast<std::ptrdiff_t>(grid.size[0]) * grid.size[1];
  int fullest = 0;
  std::ptrdiff_t maximum = -1;
  for (int k = 0; k < grid.size[2]; ++k) {
    const auto begin = map.labels.values.begin() + k * per_slice;
    const auto labelled = std::count_if(begin, begin + per_slice, [](std::uint16_t value) { return value != 0; });
    if (labelled > maximum) fullest = k;
    maximum = std::max(maximum, labelled);
  }
  std::map<int, QRgb> colours;
  for (const casefile::LabelledPart& part : map.parts) {
    const auto rgb = segmentation::known_structure(part.structure).color_rgb;
    const bool known = segmentation::known_structure(part.structure).place != segmentation::Place::unknown;
    // Steps of the golden angle keep the colours of neighbours apart.
    colours[part.value] = known ? QColor::fromRgbF(float(rgb[0]), float(rgb[1]), float(rgb[2])).rgb()
                                : QColor::fromHsv(part.value * 137 % 360, 130, 200).rgb();
  }
  QImage slice(grid.size[0], grid.size[1], QImage::Format_RGB32);
  for (int j = 0; j < grid.size[1]; ++j) {
    for (int i = 0; i < grid.size[0]; ++i) {
      const int value = map.labels.at(i, j, fullest);
      slice.setPixel(i, j, value == 0 ? qRgb(0, 0, 0) : colours[value]);
    }
  }
  return in_proportion(slice, grid, side, Qt::FastTransformation);
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
  keep_translated(this, [this] { update_text(); });
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
    row->setIcon(what_column, QIcon(on_square({})));
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
  update_text();
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

int SeriesTable::chosen_images() const {
  const auto all = roles();
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const casefile::SeriesRole& one) {
    return one.role != Role::other && one.role != Role::segmentation;
  }));
}

void SeriesTable::update_text() {
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
    for (const std::string& problem : series.problems) remarks << translated(problem);
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
    const auto show = [this, k, study = study_](const QImage& picture) {
      if (study != study_ || picture.isNull()) return;
      topLevelItem(k)->setIcon(what_column, QIcon(on_square(picture)));
    };
    const auto paint = [study = study_, k, stop = stop_]() -> QImage {
      const imaging::Series& series = study->series[static_cast<std::size_t>(k)];
      if (stop->stop_requested()) return {};
      if (series.role == Role::segmentation && casefile::is_label_map(series)) {
        const auto map = casefile::read_label_map(series.files.front());
        return map ? label_slice(*map, picture_side) : QImage();
      }
      if (series.role == Role::segmentation) return segment_slice(series.files.front(), picture_side);
      const auto volume = imaging::read_series(series, 0, Progress({}, stop->get_token()));
      return volume ? middle_slice(*volume, picture_side) : QImage();
    };
    run_in_background(this, &painters_, paint, show);
  }
}

}  // namespace glisson::widgets
