// The commands in the order in which --help lists them: the way the work goes.

#include "recording_commands.h"

namespace glisson::cli {

void add_commands(CLI::App& app, Action& chosen) {
  add_demo(app, chosen);
  add_scan(app, chosen);
  add_import(app, chosen);
  add_segment(app, chosen);
  add_vessels(app, chosen);
  add_territories(app, chosen);
  add_plan(app, chosen);
  add_growth(app, chosen);
  add_invert(app, chosen);
  add_mesh(app, chosen);
  add_stiffness(app, chosen);
  add_guide(app, chosen);
  add_simulate(app, chosen);
  add_resect(app, chosen);
  add_session(app, chosen);
  add_compare(app, chosen);
  add_render(app, chosen);
  add_report(app, chosen);
  add_export(app, chosen);
  add_calibrate(app, chosen);
  add_stereo(app, chosen);
  add_sequence(app, chosen);
  add_match(app, chosen);
  add_register(app, chosen);
  add_sirgn(app, chosen);
  add_review(app, chosen);
  add_gate(app, chosen);
  add_gate_cases(app, chosen);
  add_study(app, chosen);
  add_shapes(app, chosen);
  add_platform(app, chosen);
  add_explain(app, chosen);
  add_predict(app, chosen);
  add_accept(app, chosen);
  add_macro(app, chosen);
  add_redo(app, chosen);
  add_deidentify(app, chosen);
}

}  // namespace glisson::cli
