// Rehearse as a workspace: what its panel hears of the views, of the patient and of the live rehearsal.

#include "widgets/rehearse/freehand_knife.h"
#include "widgets/rehearse/keeping_orders.h"
#include "widgets/rehearse/planned_course.h"
#include "widgets/rehearse/rehearse_panel.h"

namespace glisson::widgets {
namespace {

void connect_views(RehearsePanel& panel, const WorkspaceContext& context);
void connect_knife(RehearsePanel& panel, const WorkspaceContext& context);
void connect_status(RehearsePanel& panel, const WorkspaceContext& context);
void show_patient(RehearsePanel& panel, const Patient& patient);

}  // namespace

Workspace RehearsePanel::workspace(const WorkspaceContext& context, KeepLandmarks keep_landmarks) {
  auto* panel = new RehearsePanel(context.rehearsal);
  connect_views(*panel, context);
  connect_knife(*panel, context);
  connect_status(*panel, context);
  connect_orders(panel->orders(), context);
  connect(panel, &RehearsePanel::landmark_wanted, panel, [panel, views = &context.views](const std::string& name) {
    std::vector<mechanics::Landmark> landmarks = panel->placed_landmarks_;
    landmarks.push_back({name, views->crosshair_mm()});
    Q_EMIT panel->landmarks_wanted(tr("Set landmark"), landmarks);
  });
  connect(panel, &RehearsePanel::landmarks_wanted, panel, std::move(keep_landmarks));
  return {.id = "rehearse",
          .name = [] { return tr("Rehearse"); },
          .about = [] { return tr("Pull with a tool, and see what moves and how far."); },
          .widget = panel,
          .show_patient =
              [panel, context](const Patient& patient) {
                show_kept_orders(panel->orders(), context);
                widgets::show_patient(*panel, patient);
              },
          .missing = model_missing};
}

namespace {

std::vector<std::string> names_of(const Patient& patient) {
  std::vector<std::string> names;
  for (const PatientStructure& structure : patient.structures) names.push_back(structure.name);
  return names;
}

void show_patient(RehearsePanel& panel, const Patient& patient) {
  panel.set_ready(patient.rehearsal != nullptr);
  panel.show_image(patient.anatomy);
  panel.show_evidence(patient.evidence);
  panel.show_assumed_stiffness(patient.assumed_stiffness);
  panel.cutting().set_structure_names(names_of(patient));
}

void connect_views(RehearsePanel& panel, const WorkspaceContext& context) {
  LinkedViews& views = context.views;
  PatientViews& patient_views = context.patient_views;
  QObject::connect(&panel, &RehearsePanel::bodies_chosen, &patient_views, &PatientViews::set_bodies);
  QObject::connect(&panel, &RehearsePanel::liver_colour_chosen, &patient_views, &PatientViews::set_liver_colour);
  QObject::connect(&panel, &RehearsePanel::landmark_chosen, &patient_views, &PatientViews::set_marked_landmark);
  QObject::connect(&panel, &RehearsePanel::at_work, &patient_views, &PatientViews::set_tool_movable);
  panel.track().set_camera([&views] { return views.space().picture(); });

  const auto place_tool = [&panel](const std::optional<PatientViews::PlaceOnLiver>& place) {
    if (place) panel.place_at(place->at_rest_mm, place->outward);
  };
  for (SpaceView* space : {&views.space(), &views.second_space()}) {
    QObject::connect(space, &SpaceView::clicked, &panel, [&, place_tool](const scene::View::Pick& pick) {
      if (panel.placing()) {
        place_tool(patient_views.place_on_liver(pick));
      } else {
        views.set_crosshair(pick.position_mm);
      }
    });
    QObject::connect(space, &SpaceView::touch_dragged, &panel, [&, place_tool](const scene::View::Pick& over) {
      place_tool(patient_views.place_on_liver(over));
    });
    QObject::connect(space, &SpaceView::free_end_dragged, &panel, &RehearsePanel::drag_arrow);
    QObject::connect(space, &SpaceView::grip_released, &panel, &RehearsePanel::let_arrow_go);
  }
  QObject::connect(&panel, &RehearsePanel::place_at_crosshair, &panel,
                   [&, place_tool] { place_tool(patient_views.nearest_on_liver(views.crosshair_mm())); });
  QObject::connect(&context.rehearsal, &LiveRehearsal::state_changed, &panel,
                   [&panel, &views, &patient_views, &rehearsal = context.rehearsal] {
                     const auto& state = rehearsal.state();
                     patient_views.show_state(state ? &*state : nullptr, panel.tools_in_view());
                     panel.show_drawing_ms(views.space().last_frame_ms());
                   });
}

void connect_knife(RehearsePanel& panel, const WorkspaceContext& context) {
  auto* knife = new FreehandKnife(context.views, context.patient_views, context.rehearsal, &panel);
  const auto follow = [&panel, knife] {
    if (panel.cutting().knife_in_hand()) panel.stop_placing();
    knife->set_depth_mm(panel.cutting().depth_mm());
    knife->take_in_hand(panel.cutting().knife_in_hand());
  };
  QObject::connect(&panel.cutting(), &AdvanceControls::knife_changed, knife, follow);
  QObject::connect(&panel, &RehearsePanel::placing_changed, knife, [&panel](bool placing) {
    if (placing) panel.cutting().put_knife_away();
  });
  QObject::connect(&panel, &RehearsePanel::at_work, knife, [&panel](bool here) {
    if (!here) panel.cutting().put_knife_away();
  });
  QObject::connect(knife, &FreehandKnife::said, &panel, context.tell_status);
}

void connect_status(RehearsePanel& panel, const WorkspaceContext& context) {
  QObject::connect(&panel, &RehearsePanel::placing_changed, &panel,
                   [&views = context.views, tell = context.tell_status](bool placing) {
                     views.space().setCursor(placing ? Qt::CrossCursor : Qt::ArrowCursor);
                     tell(placing ? RehearsePanel::tr("Click on the liver where the tool is to touch it.") : QString());
                   });
  const auto show_plan = [&panel, patient = context.patient] {
    const PlannedCourse plan = planned_course(patient());
    panel.show_plan(plan.course, plan.why_not, names_of(patient()));
  };
  QObject::connect(&panel, &RehearsePanel::at_work, &panel, [show_plan](bool here) {
    if (here) show_plan();
  });
  QObject::connect(&context.undo, &Undo::entries_moved, &panel, [&panel, show_plan](const QStringList& ids) {
    const bool followed =
        std::any_of(ids.begin(), ids.end(), [](const QString& id) { return id.startsWith("results/"); });
    if (followed && panel.isVisible()) show_plan();
  });
  QObject::connect(&panel, &RehearsePanel::failed, &panel, context.tell_error);
  QObject::connect(&panel, &RehearsePanel::said, &panel, context.tell_status);
  QObject::connect(&context.rehearsal, &LiveRehearsal::placed, &panel, [tell = context.tell_status](double solve_ms) {
    tell(RehearsePanel::tr("Tool placed in %1 ms.").arg(solve_ms, 0, 'f', 0));
  });
}

}  // namespace
}  // namespace glisson::widgets
