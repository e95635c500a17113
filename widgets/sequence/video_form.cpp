#include "widgets/sequence/video_form.h"

#include <array>
#include <initializer_list>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QStandardPaths>

#include "widgets/panels/parts.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

using vision::Board;
using vision::Shared;

QComboBox* choice_of(const char* name, int count) {
  auto* choice = new QComboBox;
  choice->setObjectName(name);
  for (int i = 0; i < count; ++i) choice->addItem({});
  return choice;
}

bool is_there(const PathRow& row) { return QFileInfo::exists(row.path()); }

}  // namespace

VideoForm::VideoForm(QWidget* parent) : QWidget(parent) {
  setObjectName("panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(14, 14, 14, 8);
  column->setSpacing(7);
  add_video(*column);
  column->addSpacing(8);
  add_calibration(*column);
  column->addSpacing(8);
  add_frames(*column);
  column->addStretch(1);
  connect_all();
  keep_translated(this, [this] { update_text(); });
  show_choices();
}

void VideoForm::add_video(QVBoxLayout& column) {
  QLabel* title = heading();
  eyes_ = choice_of("video_eyes", 4);
  left_ = new PathRow("left_video", PathRow::Asks::file_or_folder);
  right_ = new PathRow("right_video", PathRow::Asks::file_or_folder);
  for (QWidget* part : std::initializer_list<QWidget*>{title, eyes_, left_, right_}) column.addWidget(part);
  keep_translated(title, [title] { title->setText(tr("Video")); });
}

void VideoForm::add_calibration(QVBoxLayout& column) {
  QLabel* title = heading();
  calibrated_by_ = choice_of("calibrated_by", 2);
  calibration_ = new PathRow("calibration_file", PathRow::Asks::file_or_folder);
  board_ = new QWidget;
  auto* board = new QVBoxLayout(board_);
  board->setContentsMargins(0, 0, 0, 0);
  board->setSpacing(7);
  board_left_ = new PathRow("left_board", PathRow::Asks::file_or_folder);
  board_right_ = new PathRow("right_board", PathRow::Asks::file_or_folder);
  pattern_ = choice_of("board_pattern", 3);
  columns_ = whole_number("board_columns", 3, 100, 9);
  rows_ = whole_number("board_rows", 3, 100, 6);
  spacing_ = new NumberBox;
  spacing_->setObjectName("board_spacing");
  spacing_->setDecimals(2);
  spacing_->setRange(0.1, 200);
  spacing_->setSingleStep(0.5);
  spacing_->setValue(5);
  count_name_ = new QLabel;
  count_name_->setBuddy(columns_);
  spacing_name_ = new QLabel;
  spacing_name_->setBuddy(spacing_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->addWidget(count_name_, 0, 0);
  grid->addWidget(columns_, 0, 1);
  grid->addWidget(new QLabel(QString::fromUtf8("\u00d7")), 0, 2);
  grid->addWidget(rows_, 0, 3);
  grid->addWidget(spacing_name_, 1, 0);
  grid->addWidget(spacing_, 1, 1, 1, 3);
  grid->setColumnStretch(0, 1);
  for (QWidget* part : std::initializer_list<QWidget*>{board_left_, board_right_, pattern_}) board->addWidget(part);
  board->addLayout(grid);
  for (QWidget* part : std::initializer_list<QWidget*>{title, calibrated_by_, calibration_, board_}) {
    column.addWidget(part);
  }
  keep_translated(title, [title] { title->setText(tr("Calibration of the camera")); });
}

void VideoForm::add_frames(QVBoxLayout& column) {
  const registration_quality::VideoSequenceOptions usual;
  QLabel* title = heading();
  column.addWidget(title);
  first_ = whole_number("first_frame", 1, 10'000'000, 1);
  every_ = whole_number("every_frame", 1, 10'000, usual.every);
  most_ = whole_number("most_frames", 5, 100'000, usual.maximum_frames);
  std::array<QLabel*, 3> names{new QLabel, new QLabel, new QLabel};
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(3);
  for (int i = 0; i < 3; ++i) {
    NumberBox* box = std::array{first_, every_, most_}[static_cast<std::size_t>(i)];
    QLabel* name = names[static_cast<std::size_t>(i)];
    name->setBuddy(box);
    grid->addWidget(name, 0, i);
    grid->addWidget(box, 1, i);
    grid->setColumnStretch(i, 1);
  }
  column.addLayout(grid);
  folder_ = new PathRow("sequence_folder", PathRow::Asks::new_folder);
  column.addSpacing(8);
  column.addWidget(folder_);
  keep_translated(title, [=, this] {
    title->setText(tr("Frames"));
    names[0]->setText(tr("From frame"));
    names[1]->setText(tr("One frame in"));
    names[2]->setText(tr("At most"));
    first_->setToolTip(tr("The first frame that is taken, counted from 1"));
    every_->setToolTip(tr("1 takes every frame, 5 every fifth"));
    most_->setToolTip(tr("So many frames are taken at most; each takes up to a second"));
  });
}

void VideoForm::connect_all() {
  for (PathRow* row : {left_, right_, calibration_, board_left_, board_right_, folder_}) {
    connect(row, &PathRow::changed, this, &VideoForm::changed);
  }
  connect(left_, &PathRow::changed, this, [this] {
    propose_right();
    propose_folder();
  });
  for (QComboBox* choice : {eyes_, calibrated_by_, pattern_}) {
    connect(choice, &QComboBox::currentIndexChanged, this, [this] {
      show_choices();
      update_text();
      Q_EMIT changed();
    });
  }
}

// left.mp4 has its right.mp4 beside it, as a rule.
void VideoForm::propose_right() {
  if (in_one() || !right_->path().isEmpty()) return;
  const QFileInfo left(left_->path());
  QString name = left.fileName();
  name.replace("left", "right");
  const QFileInfo right(left.dir(), name);
  if (name != left.fileName() && right.exists()) right_->set_path(QDir::toNativeSeparators(right.filePath()));
}

void VideoForm::propose_folder() {
  if (!folder_->path().isEmpty() && folder_->path() != proposed_) return;
  const QFileInfo video(left_->path());
  if (left_->path().isEmpty() || !video.exists()) return;
  QDir parent = video.absoluteDir();
  if (!QFileInfo(parent.path()).isWritable()) {
    parent.setPath(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Glisson");
  }
  const QString name = (video.isDir() ? video.fileName() : video.completeBaseName()) + "-sequence";
  QString proposed = parent.filePath(name);
  for (int number = 2; QFileInfo::exists(proposed); ++number) {
    proposed = parent.filePath(QString("%1-%2").arg(name).arg(number));
  }
  proposed_ = QDir::toNativeSeparators(proposed);
  folder_->set_path(proposed_);
}

void VideoForm::show_choices() {
  right_->setVisible(!in_one());
  board_right_->setVisible(!in_one());
  calibration_->setVisible(!from_board());
  board_->setVisible(from_board());
}

QString VideoForm::missing() const {
  if (!is_there(*left_)) return in_one() ? tr("Choose the video.") : tr("Choose the left eye's video.");
  if (!in_one() && !is_there(*right_)) return tr("Choose the right eye's video.");
  if (!from_board() && !is_there(*calibration_)) return tr("Choose the camera's calibration.");
  if (from_board() && (!is_there(*board_left_) || (!in_one() && !is_there(*board_right_)))) {
    return tr("Choose the pictures of the board.");
  }
  return folder_->path().isEmpty() ? tr("Say where to keep the sequence.") : QString();
}

VideoOrder VideoForm::order() const {
  const auto path = [](const PathRow* row) { return path_of(row->path()); };
  VideoOrder order;
  order.video.left = path(left_);
  if (in_one()) {
    order.video.shared = std::array{Shared::left_then_right, Shared::right_then_left,
                                    Shared::left_above_right}[static_cast<std::size_t>(eyes_->currentIndex() - 1)];
  } else {
    order.video.right = path(right_);
  }
  if (from_board()) {
    order.board.left = {path(board_left_)};
    if (!in_one()) order.board.right = {path(board_right_)};
    order.board.shared = order.video.shared;
    Board& board = order.board.board;
    board.pattern = std::array{Board::Pattern::chessboard, Board::Pattern::circles,
                               Board::Pattern::dots}[static_cast<std::size_t>(pattern_->currentIndex())];
    board.columns = static_cast<int>(columns_->value());
    board.rows = static_cast<int>(rows_->value());
    board.spacing_mm = spacing_->value();
  } else {
    order.calibration = path(calibration_);
  }
  order.options.skip = static_cast<int>(first_->value()) - 1;
  order.options.every = static_cast<int>(every_->value());
  order.options.maximum_frames = static_cast<int>(most_->value());
  order.folder = path(folder_);
  return order;
}

void VideoForm::update_text() {
  const QString kinds = tr("A video file, or a folder of its pictures");
  eyes_->setItemText(0, tr("Two videos, one for each eye"));
  eyes_->setItemText(1, tr("One video, left eye on the left"));
  eyes_->setItemText(2, tr("One video, left eye on the right"));
  eyes_->setItemText(3, tr("One video, left eye above"));
  eyes_->setAccessibleName(tr("How the video shows both eyes"));
  eyes_->setToolTip(tr("How the video, and the pictures of a board, show both eyes"));
  left_->set_words(in_one() ? tr("Video") : tr("Left eye"), kinds);
  right_->set_words(tr("Right eye"), kinds);
  calibrated_by_->setItemText(0, tr("From a file"));
  calibrated_by_->setItemText(1, tr("From pictures of a board"));
  calibrated_by_->setAccessibleName(tr("Where the calibration comes from"));
  calibrated_by_->setToolTip(
      tr("Without a calibration, take pictures of a flat board with both eyes, from several sides"));
  calibration_->set_words(tr("Calibration"), tr("JSON, OpenCV's YAML or XML, or a folder of text files"));
  const QString pictures =
      tr("A folder of pictures or a video: the same board, from at least three sides; ten are better");
  board_left_->set_words(in_one() ? tr("Pictures") : tr("Left eye"), pictures);
  board_right_->set_words(tr("Right eye"), pictures);
  pattern_->setItemText(0, tr("Chessboard"));
  pattern_->setItemText(1, tr("Grid of circles"));
  pattern_->setItemText(2, tr("Grid of circles, four of them larger"));
  pattern_->setAccessibleName(tr("Kind of board"));
  pattern_->setToolTip(tr("What is printed on the board"));
  const bool is_chess = pattern_->currentIndex() == 0;
  count_name_->setText(is_chess ? tr("Inner corners, columns by rows") : tr("Circles, columns by rows"));
  spacing_name_->setText(is_chess ? tr("Side of a square") : tr("From circle to circle"));
  columns_->setToolTip(tr("Along a row: a board of 10 x 7 squares has 9 x 6 inner corners"));
  rows_->setToolTip(columns_->toolTip());
  rows_->setAccessibleName(tr("Rows"));
  spacing_->setSuffix(tr(" mm"));
  spacing_->setToolTip(tr("Measure it: all lengths of the sequence follow from it"));
  folder_->set_words(tr("Keep it in"), tr("A new folder for the clouds, tracks and pictures"));
}

}  // namespace glisson::widgets
