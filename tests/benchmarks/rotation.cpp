// How many frames a second the window draws while a hand turns the patient in space, all of it at 1600 x 1000. And how
// much memory it takes: with that patient open, compared with its reference body under a tool, rehearsed with large
// deformations, and after closing.
//
//   xvfb-run -a -s "-screen 0 1600x1000x24" bench_rotation [CASE]
//
// CASE is a case with a model; without one the demo patient is made, which takes minutes. The mouse is moved by Qt's
// own events, each frame is drawn and put on the screen before the next move, and nothing is computed behind it.

#include <sys/resource.h>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <QApplication>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <string>
#include <thread>

#include "rehearsal/tool_presets.h"
#include "widgets/main_window.h"
#include "widgets/theme.h"
#include "widgets/words/language.h"
#include "widgets/work/give_back_memory.h"

namespace {

double cpu_s() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

// Until nothing is computed behind the window: bodies being factorised take the time that frames are measured by.
void wait_until_idle() {
  using Clock = std::chrono::steady_clock;
  constexpr double pause_s = 0.5, at_most_busy = 0.1, patience_s = 120;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto begun = Clock::now();
  for (double busy = 1; busy > at_most_busy;) {
    if (seconds_since(begun) > patience_s) {
      std::printf("still computing after %.0f s: what follows is measured beside it\n", patience_s);
      return;
    }
    const auto start = Clock::now();
    const double cpu_before = cpu_s();
    while (seconds_since(start) < pause_s) {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    busy = (cpu_s() - cpu_before) / seconds_since(start);
  }
}

void send_mouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButtons buttons) {
  const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &event);
}

// Until the view has drawn what it was asked for, and the window shows it.
void wait_for_frame(glisson::widgets::RenderWidget& view) {
  bool drawn = false;
  const auto heard = QObject::connect(&view, &glisson::widgets::RenderWidget::frame_drawn, [&] { drawn = true; });
  while (!drawn) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  QObject::disconnect(heard);
  view.repaint();
}

void measure(glisson::widgets::MainWindow& window, const char* what) {
  using Clock = std::chrono::steady_clock;
  glisson::widgets::SpaceView& space = window.views().space();
  const QPointF middle = QPointF(space.rect().center()) + QPointF(0.3 * space.width(), -0.3 * space.height());
  constexpr int frames = 90;
  const auto turn = [&](int count) {
    send_mouse(space, QEvent::MouseButtonPress, middle, Qt::LeftButton);
    for (int k = 1; k <= count; ++k) {
      send_mouse(space, QEvent::MouseMove, middle + QPointF(4.0 * (k % 60), k % 20), Qt::LeftButton);
      wait_for_frame(space);
    }
    send_mouse(space, QEvent::MouseButtonRelease, middle, Qt::NoButton);
  };
  wait_until_idle();
  turn(5);
  double drawing_ms = 0;
  const auto start = Clock::now();
  const double cpu_before = cpu_s();
  send_mouse(space, QEvent::MouseButtonPress, middle, Qt::LeftButton);
  for (int k = 1; k <= frames; ++k) {
    send_mouse(space, QEvent::MouseMove, middle + QPointF(4.0 * (k % 60), k % 20), Qt::LeftButton);
    wait_for_frame(space);
    drawing_ms += space.last_frame_ms();
  }
  send_mouse(space, QEvent::MouseButtonRelease, middle, Qt::NoButton);
  const double wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  std::printf("%-28s %4d x %-4d  %6.1f frames/s  %6.1f ms drawing  %6.1f ms CPU a frame\n", what, space.width(),
              space.height(), frames / wall_s, drawing_ms / frames, 1e3 * (cpu_s() - cpu_before) / frames);
  std::fflush(stdout);
}

// Of /proc/self/status: "VmRSS", "VmHWM".
double resident_mb(const std::string& which) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(which + ":")) return std::stod(line.substr(which.size() + 1)) / 1024;
  }
  return 0;
}

void print_memory(const char* when) {
  glisson::widgets::give_back_memory();
  std::printf("%-28s %6.0f MB resident, %6.0f MB at its highest\n", when, resident_mb("VmRSS"), resident_mb("VmHWM"));
  std::fflush(stdout);
}

// Presses on the liver's first point: the patient's answer, then that of the reference body, which is made for it.
void compare_under_a_tool(glisson::widgets::MainWindow& window) {
  using Clock = std::chrono::steady_clock;
  auto& rehearsal = window.rehearsal();
  if (rehearsal.body() == nullptr) return;
  const auto start = Clock::now();
  const auto since_s = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  double first_s = 0;
  rehearsal.hold({"palpation-probe", rehearsal.body()->surface().points_mm.front(), {0, 0, 1}, 15, {0, 0, -1}, 0.5});
  while (rehearsal.solving() == glisson::widgets::Solving::solving) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    if (first_s == 0 && rehearsal.state()) first_s = since_s();
  }
  std::printf("the first tool: the patient's answer after %.2f s, compared after %.2f s\n", first_s, since_s());
}

// A retractor holds segment VI with 0.5 N, and a probe of 0.3 N is drawn over the front, half a millimetre a picture:
// the next place is asked for when the last is on the screen.
void draw_a_probe_at_large_deformations(glisson::widgets::MainWindow& window) {
  using namespace glisson::widgets;
  using Clock = std::chrono::steady_clock;
  auto& rehearsal = window.rehearsal();
  if (rehearsal.body() == nullptr) return;
  const auto place = glisson::rehearsal::hoist_segment_vi(rehearsal.body()->patient().mesh());
  const glisson::geometry::Box box = glisson::geometry::bounding_box(rehearsal.body()->surface().points_mm);
  if (!place) return;
  const PlacedTool retractor{"nathanson-retractor",   place->center_mm, -place->direction,
                             place->preset.radius_mm, place->direction, 0.5};
  PlacedTool probe{
      "palpation-probe", {box.center_mm().x(), box.min_mm.y(), box.center_mm().z()}, {0, -1, 0}, 5, {0, 1, 0}, 0.3};
  constexpr double patience_s = 60;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto until = [&](const auto& done) {
    // Asleep between events, as the window is: a session's timer is one of them.
    for (const auto begun = Clock::now(); !done() && since(begun) < patience_s;) {
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  };
  const auto is_over = [&] {
    return rehearsal.solving() != Solving::solving && rehearsal.solving() != Solving::settling;
  };
  rehearsal.take_tool_away();
  rehearsal.set_touch(Touch::rigid);
  rehearsal.set_deformations(Deformations::large);
  const auto start = Clock::now();
  rehearsal.hold(retractor);
  until([&] { return rehearsal.contact() != nullptr || rehearsal.refusal(); });
  const double first_s = since(start), first_mm = rehearsal.error_bound_mm().value_or(0);
  until(is_over);
  std::printf("large deformations: the retractor seen after %.2f s within %.2f mm, %s after %.2f s within %.2f mm\n",
              first_s, first_mm, rehearsal.solving() == Solving::solved ? "at rest" : "not at rest", since(start),
              rehearsal.error_bound_mm().value_or(0));
  std::fflush(stdout);
  rehearsal.keep_tool();
  rehearsal.hold(probe);
  until([&] { return rehearsal.track().moments().size() >= 2 || rehearsal.refusal(); });
  constexpr int pictures = 40;
  int over = 0, refused = 0;
  double slowest_s = 0;
  const auto drawn = Clock::now();
  for (int k = 0; k < pictures; ++k) {
    const auto asked = Clock::now();
    probe.center_mm.x() += 0.5;
    const std::size_t before = rehearsal.track().moments().size();
    rehearsal.hold(probe);
    until([&] { return rehearsal.track().moments().size() > before || rehearsal.refusal(); });
    window.views().space().repaint();
    slowest_s = std::max(slowest_s, since(asked));
    over += rehearsal.error_bound_mm().value_or(0) > glisson::rehearsal::SessionEngine::shown_mm ? 1 : 0;
    refused += rehearsal.refusal() ? 1 : 0;
  }
  const double drawn_s = since(drawn);
  const auto resting = Clock::now();
  until(is_over);
  std::printf(
      "a probe drawn: %.1f pictures/s, slowest %.0f ms, %d of %d past 0.5 mm, %d refused; %s after %.1f s more\n",
      pictures / drawn_s, 1e3 * slowest_s, over, pictures, refused,
      rehearsal.solving() == Solving::solved ? "at rest" : "not at rest", since(resting));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace glisson::widgets;
  QApplication application(argc, argv);
  const QTemporaryDir own;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, own.path());
  choose_language("en");
  apply_theme(Theme::dark);
  print_memory("nothing open");
  const glisson::Progress progress;
  // A copy: the tools that are placed here would stand in the case when it is opened again.
  const std::filesystem::path copy = own.path().toStdString() + "/copy.glisson";
  if (argc > 1) std::filesystem::copy(argv[1], copy, std::filesystem::copy_options::recursive);
  auto patient = argc > 1 ? load_patient(copy, progress) : load_demo(own.path().toStdString(), progress);
  if (!patient) {
    std::fprintf(stderr, "%s\n", patient.error().message().c_str());
    return 1;
  }
  std::size_t triangles = 0;
  for (const PatientStructure& structure : patient->structures) triangles += structure.surface->triangles.size();
  std::printf("%zu triangles\n", triangles);
  MainWindow window;
  window.resize(1600, 1000);
  window.show();
  window.show_patient(*patient);
  QApplication::processEvents();
  measure(window, "four views");
  print_memory("the patient open");
  compare_under_a_tool(window);
  print_memory("compared under a tool");
  window.rehearsal().take_tool_away();
  window.views().set_layout(ViewLayout::space_large);
  QApplication::processEvents();
  measure(window, "3D large");
  for (QWidget* panel : window.findChildren<QWidget*>("panel")) panel->hide();
  window.views().space().setFocus();
  window.views().set_layout(ViewLayout::one);
  QApplication::processEvents();
  measure(window, "3D alone");
  draw_a_probe_at_large_deformations(window);
  print_memory("with large deformations");
  patient = glisson::widgets::Patient{};
  window.show_patient({});
  for (const auto closed = std::chrono::steady_clock::now();
       std::chrono::steady_clock::now() - closed < std::chrono::seconds(2);) {
    QApplication::processEvents();
  }
  print_memory("closed");
  return 0;
}
