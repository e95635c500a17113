#pragma once
// A person's way through the window by mouse and keys. Every click lands where the control is drawn, through the window
// system, and a control that cannot be seen, reached or used fails the step. After each step the window rests, nothing
// red stands in it, its picture is kept (build/PRESET/pictures/walk-NAME-...), and time and memory are printed. Where a
// person would look twice, the window is held against baselines (walk_baselines.h).

#include <fstream>
#include <functional>
#include <QDialog>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStatusBar>
#include <QTimer>
#include <QtTest>
#include <sstream>

#include "kept_pictures.h"
#include "shown.h"
#include "walk_baselines.h"

namespace glisson::widgets {

class Walk {
 public:
  explicit Walk(const QString& name)
      : window_(shown_window(WalkBaselines::size_of_walk())), name_(name), baselines_(*window_, name) {}

  [[nodiscard]] MainWindow& window() { return *window_; }

  // Does it, then waits until it is seen and nothing is computed any more. Once a step failed none is taken.
  void step(const QString& what, const std::function<void()>& act, const std::function<bool()>& seen) {
    if (QTest::currentTestFailed()) return;
    QElapsedTimer clock;
    clock.start();
    act();
    if (QTest::currentTestFailed()) return;
    std::vector<std::pair<double, double>> told_s;  // when, and how long it was said to take from then on
    const bool arrived = QTest::qWaitFor(
        [&] {
          if (const auto left_s = time_left_told_s()) told_s.emplace_back(1e-3 * double(clock.elapsed()), *left_s);
          return seen() && rests();
        },
        patience_ms);
    const qint64 took_ms = clock.elapsed();
    print_how_right(told_s, 1e-3 * double(took_ms));
    QTest::qWait(250);  // views draw behind
    keep_picture(what);
    qInfo("%-34s %6.1f s   %5.0f MB, %5.0f MB at most", qPrintable(what), 1e-3 * static_cast<double>(took_ms),
          memory_mb("VmRSS"), memory_mb("VmHWM"));
    if (!arrived) return fail(QString("%1: not seen. %2").arg(what, on_screen()));
    const auto* notice = child_of<QWidget>(*window_, "notice");
    if (notice->isVisible() && notice->property("kind") == "trouble") {
      fail(QString("%1: trouble is told. %2").arg(what, on_screen()));
    }
  }

  // The window as it is now, at each size in each language, for same_as_before().
  void look(const QString& at) {
    if (!QTest::currentTestFailed()) baselines_.take(at, [this] { return rests(); });
  }
  // At the end: all that was looked at is as it was when somebody last said that it is right.
  void same_as_before() {
    if (QTest::currentTestFailed()) return;
    const QStringList differences = baselines_.differences();
    if (!differences.isEmpty()) fail(differences.join('\n'));
  }

  // What a person sees of that name; null for nothing.
  template <typename Widget>
  [[nodiscard]] Widget* seen(const QString& name) const {
    for (auto* each : window_->findChildren<Widget*>(name)) {
      if (each->isVisible()) return each;
    }
    return nullptr;
  }
  [[nodiscard]] QString text(const QString& label) const {
    const auto* found = seen<QLabel>(label);
    return found != nullptr ? found->text() : QString();
  }
  [[nodiscard]] bool can_press(const QString& name) const {
    const auto* found = seen<QAbstractButton>(name);
    return found != nullptr && found->isEnabled();
  }

  void click(const QString& name) { click_on(seen<QWidget>(name), name); }
  // Of the button of that name in that part of the window.
  void click(const QString& part, const QString& name) {
    const auto* parent = seen<QWidget>(part);
    click_on(parent != nullptr ? parent->findChild<QWidget*>(name) : nullptr, part + ", " + name);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers) { press_key(*window_, key, modifiers); }
  void type(const QString& field, const QString& text) {
    click(field);
    if (QTest::currentTestFailed()) return;
    QApplication::setActiveWindow(window_.get());
    auto* into = QApplication::focusWidget();
    if (into == nullptr) into = seen<QWidget>(field);
    QTest::keyClick(into, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(into, text);
    QTest::keyClick(into, Qt::Key_Return);
  }
  void drop(const std::filesystem::path& path) {
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
    const QPoint place = window_->rect().center();
    QDragEnterEvent enters(place, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &enters);
    if (!enters.isAccepted()) return fail("the window takes no drop");
    QDropEvent drops(place, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &drops);
  }
  // Two clicks: the coronal slice says how high, the transverse one where.
  void point_at(const Eigen::Vector3d& place_mm) {
    for (const SliceDirection direction :
         {SliceDirection::coronal, SliceDirection::transverse, SliceDirection::coronal}) {
      SliceView& view = window_->views().slice(direction);
      click_at(view, position_of(view, place_mm));
      QTest::qWait(30);
    }
  }
  // Answers the file dialog that comes with a name.
  void name_the_file(const std::filesystem::path& file) {
    QTimer::singleShot(100, window_.get(), [this, file] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return name_the_file(file);
      auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
      line->selectAll();
      QTest::keyClicks(line, QString::fromStdString(file.string()));
      QTest::keyClick(line, Qt::Key_Return);
      if (QApplication::activeModalWidget() == dialog) name_the_file(file);  // a list of proposals took the key
    });
  }

 private:
  static constexpr int patience_ms = 90'000;

  static void fail(const QString& why) { QTest::qFail(qPrintable(why), __FILE__, __LINE__); }

  [[nodiscard]] bool rests() {
    return !window_->work().busy() && !window_->undo().busy() && window_->rehearsal().solving() != Solving::solving &&
           QApplication::activeModalWidget() == nullptr;
  }

  void click_on(QWidget* target, const QString& name) {
    if (target == nullptr || !target->isVisible()) return fail(name + " is not to be seen. " + on_screen());
    for (QWidget* up = target->parentWidget(); up != nullptr; up = up->parentWidget()) {  // as the wheel would
      if (auto* area = qobject_cast<QScrollArea*>(up)) area->ensureWidgetVisible(target);
    }
    if (!target->isEnabled()) {
      return fail(QString("%1 cannot be used: \"%2\". %3").arg(name, target->toolTip(), on_screen()));
    }
    const bool box = qobject_cast<QCheckBox*>(target) != nullptr;
    click_at(*target, box ? QPoint(8, target->height() / 2) : target->rect().center());
  }

  void click_at(QWidget& target, const QPoint& place) {
    QWidget* top = target.window();
    const QPoint here = target.mapTo(top, place);
    QWidget* under = top->childAt(here);
    if (under != &target && !(under != nullptr && target.isAncestorOf(under))) {
      return fail(QString("%1 lies under %2, or beyond the window")
                      .arg(target.objectName(), under != nullptr ? under->objectName() : QString("nothing")));
    }
    QTest::mouseClick(top->windowHandle(), Qt::LeftButton, Qt::NoModifier, here);
  }

  static QPoint position_of(const SliceView& view, const Eigen::Vector3d& place_mm) {
    const Eigen::Vector3d origin = view.place_at({0, 0});
    const Eigen::Vector3d x = view.place_at({100, 0}) - origin, y = view.place_at({0, 100}) - origin;
    const Eigen::Vector3d way = place_mm - origin;
    return QPointF(100 * way.dot(x) / x.squaredNorm(), 100 * way.dot(y) / y.squaredNorm()).toPoint();
  }

  [[nodiscard]] QString on_screen() const {
    QStringList words{"On screen: workspace " + window_->workspace()};
    if (!text("notice_text").isEmpty()) words << "notice \"" + text("notice_text") + "\"";
    if (!text("solving_trouble").isEmpty()) words << "trouble \"" + text("solving_trouble") + "\"";
    if (window_->work().busy()) words << "work under way";
    if (const auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      words << "question \"" + question->text() + "\"";
    } else if (const auto* dialog = QApplication::activeModalWidget()) {
      words << "dialog \"" + dialog->windowTitle() + "\"";
    }
    return words.join(", ");
  }

  void keep_picture(const QString& what) {
    LinkedViews& views = window_->views();
    if (views.space().isVisible()) (void)views.space().picture();
    for (SliceView* slice : views.slices()) {
      if (slice->isVisible()) (void)slice->picture();
    }
    const QString number = QString("%1").arg(++steps_, 2, 10, QChar('0'));
    const QString file =
        glisson::test::kept_pictures() + QString("/walk-%1-%2-%3").arg(name_, number, what).replace(' ', '-');
    window_->grab().save(file + ".png");
    for (auto* other : window_->findChildren<QWidget*>()) {
      if (other->isWindow() && other->isVisible()) other->grab().save(file + "-beside.png");
    }
  }

  // Of "about 7 s left" in the status line.
  [[nodiscard]] std::optional<double> time_left_told_s() const {
    static const QRegularExpression told("about (\\d+) s left");
    for (const auto* label : window_->statusBar()->findChildren<QLabel*>()) {
      const auto found = told.match(label->text());
      if (found.hasMatch()) return found.captured(1).toDouble();
    }
    return {};
  }
  static void print_how_right(const std::vector<std::pair<double, double>>& told_s, double took_s) {
    if (told_s.empty()) return;
    double off_s = 0;
    for (const auto& [when_s, left_s] : told_s) off_s = std::max(off_s, std::abs(left_s - (took_s - when_s)));
    qInfo("  the time left was told from %.1f s on, and was off by %.1f s at most", told_s.front().first, off_s);
  }

  static double memory_mb(const std::string& which) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with(which + ":")) return std::stod(line.substr(which.size() + 1)) / 1024;
    }
    return 0;
  }

  std::unique_ptr<MainWindow> window_;
  QString name_;
  WalkBaselines baselines_;
  int steps_ = 0;
};

}  // namespace glisson::widgets
