#include "widgets/help/tour_stops.h"

#include <QCoreApplication>

namespace glisson::widgets {
namespace {

struct StopWords {
  const char* workspace;
  const char* title;
  const char* words;
};

constexpr const char* tour_context = "tour";

constexpr StopWords all[] = {
    {"study", QT_TRANSLATE_NOOP("tour", "Study: the images"),
     QT_TRANSLATE_NOOP("tour",
                       "Every case begins with its images. Drop a DICOM folder on the window: Glisson proposes what "
                       "each series is for, and you correct it. Here you also see what a case still lacks.")},
    {"segment", QT_TRANSLATE_NOOP("tour", "Segment: what is where"),
     QT_TRANSLATE_NOOP("tour",
                       "The liver, its vessels and tumours as coloured outlines in the slices. Paint, erase, grow "
                       "and smooth; every step can be undone, even after the case was closed.")},
    {"model", QT_TRANSLATE_NOOP("tour", "Model: how stiff each part is"),
     QT_TRANSLATE_NOOP("tour",
                       "The liver becomes tetrahedra, and each gets the patient's own stiffness from MR "
                       "elastography. What holds the liver in place is shown too.")},
    {"rehearse", QT_TRANSLATE_NOOP("tour", "Rehearse: pull, and see"),
     QT_TRANSLATE_NOOP("tour",
                       "A retractor hoists segment VI. Change the force, or place the tool elsewhere by a "
                       "click: the table follows each tumour and vessel, and marks what is 5 mm or more off.")},
    {"resect", QT_TRANSLATE_NOOP("tour", "Resect: what is left"),
     QT_TRANSLATE_NOOP("tour",
                       "A cutting surface divides the liver: volumes of specimen and remnant, the smallest margin "
                       "to each tumour, and the vessels that are crossed.")},
    {"report", QT_TRANSLATE_NOOP("tour", "Report: one page"),
     QT_TRANSLATE_NOOP("tour",
                       "All that was done for this patient, to read, save or print. The name is masked unless you "
                       "ask for it in the settings.")},
    {"guide", QT_TRANSLATE_NOOP("tour", "Guide: where the tumour is now"),
     QT_TRANSLATE_NOOP(
         "tour",
         "The liver is found on the frames of a laparoscope's video and follows them. Tumours and vessels "
         "are drawn where they lie, dashed where they are not to be trusted.")},
    {"register", QT_TRANSLATE_NOOP("tour", "Register: can the overlay be trusted"),
     QT_TRANSLATE_NOOP("tour",
                       "Laparoscopic video is registered to the model, and SIRGn shows on each triangle how well, "
                       "for one algorithm or two side by side.")},
    {"platform", QT_TRANSLATE_NOOP("tour", "Platform: what to wear"),
     QT_TRANSLATE_NOOP("tour",
                       "Which wearable computer carries this case for as long as the operation takes: frames a "
                       "second, battery and heat, and why the others do not.")},
    {"evidence", QT_TRANSLATE_NOOP("tour", "Evidence: where the model is wrong"),
     QT_TRANSLATE_NOOP("tour",
                       "Measurements are held against the model. What it cannot explain is traced to a cause; you "
                       "accept that cause for this patient, and can take it back.")},
};

}  // namespace

std::vector<TourStop> tour_stops(const std::set<QString>& workspaces,
                                 const std::map<QString, std::function<void()>>& acts) {
  std::vector<TourStop> stops;
  for (const StopWords& each : all) {
    if (workspaces.count(each.workspace) == 0) continue;
    TourStop stop{.workspace = each.workspace,
                  .title = [&each] { return QCoreApplication::translate(tour_context, each.title); },
                  .words = [&each] { return QCoreApplication::translate(tour_context, each.words); }};
    if (const auto act = acts.find(each.workspace); act != acts.end()) stop.act = act->second;
    stops.push_back(std::move(stop));
  }
  return stops;
}

}  // namespace glisson::widgets
