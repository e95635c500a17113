// What PlanByAnatomy shows: segments, the answer to a cut, the plans that are kept, and all of it in space.

#include <algorithm>
#include <array>
#include <map>
#include <QCoreApplication>
#include <QLocale>

#include "scene/anatomy.h"
#include "vasculature/couinaud.h"
#include "widgets/panels/parts.h"
#include "widgets/panels/small_table.h"
#include "widgets/panels/swatch.h"
#include "widgets/resect/plan_by_anatomy.h"
#include "widgets/resect/resection_scene.h"
#include "widgets/theme.h"
#include "widgets/words/numbers.h"
#include "widgets/words/translated.h"

namespace glisson::widgets {
namespace {

// As territories/couinaud has them for 3D Slicer.
scene::Colour colour_of_segment(std::size_t number) {
  const auto& [red, green, blue] = vasculature::segment_colour(number);
  return {red, green, blue};
}

// Figures stand to the right.
QTableWidgetItem* put(QTableWidget& table, int row, int column, const QString& text) {
  QTableWidgetItem* cell = put_text(table, row, column, text);
  if (column > 0) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return cell;
}

}  // namespace

QString branch_label(const std::string& name) {
  static const std::map<QString, const char*> words = {
      {"portal", QT_TRANSLATE_NOOP("vessels", "Portal vein")},
      {"hepatic", QT_TRANSLATE_NOOP("vessels", "Hepatic vein")},
      {"hepatic-artery", QT_TRANSLATE_NOOP("vessels", "Hepatic artery")},
      {"bile-duct", QT_TRANSLATE_NOOP("vessels", "Bile duct")},
      {"outside", QT_TRANSLATE_NOOP("vessels", "outside the liver")},
      {"right", QT_TRANSLATE_NOOP("vessels", "right")},
      {"left", QT_TRANSLATE_NOOP("vessels", "left")},
      {"middle", QT_TRANSLATE_NOOP("vessels", "middle")},
      {"anterior", QT_TRANSLATE_NOOP("vessels", "anterior")},
      {"posterior", QT_TRANSLATE_NOOP("vessels", "posterior")},
      {"lateral", QT_TRANSLATE_NOOP("vessels", "lateral")},
      {"medial", QT_TRANSLATE_NOOP("vessels", "medial")},
      {"caudate", QT_TRANSLATE_NOOP("vessels", "caudate")},
      {"stem", QT_TRANSLATE_NOOP("vessels", "stem")}};
  QStringList parts;
  for (const QString& part : QString::fromStdString(name).split('/', Qt::SkipEmptyParts)) {
    const auto word = words.find(part);
    parts << (word == words.end() ? part : QCoreApplication::translate("vessels", word->second));
  }
  return parts.join(", ");
}

void PlanByAnatomy::show_anatomy() {
  const auto& anatomy = live_->anatomy();
  const bool segments = anatomy && anatomy->has_segments;
  QStringList told;
  if (live_->opening()) told << tr("Looking at the liver's anatomy...");
  if (segments && !anatomy->has_trees) {
    told << (anatomy->told.borders.empty()
                 ? tr("By the liver's shape alone: it has no vessel trees.")
                 : tr("By the liver's shape and borders set by hand: it has no vessel trees."));
  }
  if (anatomy) {
    for (const Sentence& remark : anatomy->remarks) told << translated(remark);
  }
  show_text(text_, told.join(" "));
  find_->setVisible(anatomy && (!segments || !anatomy->remarks.empty()));
  anatomy_->setVisible(segments);
  around_->setVisible(anatomy && !anatomy->planner.tumours().empty());
  along_->setVisible(anatomy && !anatomy->territories.empty());
  staging_->setVisible(anatomy && !anatomy->territories.empty());
  ablating_->setVisible(anatomy != nullptr);
  vessel_click_->offer(anatomy ? &anatomy->planner.trees() : nullptr);
  border_by_hand_->crosshair_moved(context_.views.crosshair_mm());
  border_by_hand_->offer(anatomy ? anatomy->borders : vasculature::DrawnBorders(),
                         anatomy ? anatomy->told.borders : vasculature::BorderPlaces());
  if (!anatomy) return;
  const QString before = tumour_->currentData().toString();
  tumour_->clear();
  for (const std::string& name : anatomy->planner.tumours()) {
    tumour_->addItem(structure_label(name), QString::fromStdString(name));
  }
  tumour_->setCurrentIndex(std::max(0, tumour_->findData(before)));
  const bool has_tumours = !anatomy->planner.tumours().empty();
  ablation_->allow_tumour(has_tumours);
  stages_->offer(anatomy->territories);
  live_->set_embolisation(stages_->embolisation());
  const QString territory_before = territory_->currentData().toString();
  territory_->clear();
  for (const NamedTerritory& territory : anatomy->territories) {
    territory_->addItem(tr("%1 (%2 ml)").arg(branch_label(territory.branch), number(territory.ml, 0)),
                        QString::fromStdString(territory.branch));
  }
  if (const int same = territory_->findData(territory_before); same >= 0)
    territory_->setCurrentIndex(same);
  else
    suggest_territory();
  if (!segments) return;
  const std::vector<int> before_ticked = ticked();
  const QSignalBlocker quiet(segments_);
  const auto tissue = anatomy->planner.segments();
  segments_->setRowCount(0);
  for (int s = 1; s <= 8; ++s) {
    const planning::Tissue& whole = tissue.at(static_cast<std::size_t>(s));
    if (whole.ml <= 0) continue;
    const int row = segments_->rowCount();
    segments_->insertRow(row);
    QTableWidgetItem* item = put(*segments_, row, segment_column,
                                 QChar::Space + QString(vasculature::segment_name(static_cast<std::size_t>(s))));
    item->setData(Qt::UserRole, s);
    item->setIcon(swatch(colour_of_segment(static_cast<std::size_t>(s))));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    const bool was = std::find(before_ticked.begin(), before_ticked.end(), s) != before_ticked.end();
    item->setCheckState(was ? Qt::Checked : Qt::Unchecked);
    put(*segments_, row, whole_column, number(whole.ml, 0));
    put(*segments_, row, stays_column, {});
    QTableWidgetItem* stiffness =
        put(*segments_, row, stiffness_column, whole.mean_kPa ? number(*whole.mean_kPa, 1) : QString("–"));
    if (whole.mean_kPa) {
      stiffness->setToolTip(tr("%1 % of the segment was measured.").arg(100 * whole.confident_share, 0, 'f', 0));
      if (whole.confident_share < 0.5) stiffness->setForeground(theme_colour("faint"));
    }
  }
  take_segments_->setEnabled(!ticked().empty());
  fit_height(*segments_);
  show_answer();
}

void PlanByAnatomy::show_answer() {
  const auto& result = live_->result();
  answer_->setVisible(result || (live_->problem() && !cuts().empty()));
  show_keeping();
  stages_->show(result.get());
  const planning::PlanAnswer* answer = result ? &result->answer : nullptr;
  for (int row = 0; row < segments_->rowCount(); ++row) {
    const int s = segments_->item(row, segment_column)->data(Qt::UserRole).toInt();
    QString left;
    for (const planning::SegmentAnswer& segment : answer ? answer->segments : std::vector<planning::SegmentAnswer>{}) {
      if (segment.number == s) left = number(segment.left.ml, 0);
    }
    const QSignalBlocker quiet(segments_);
    put(*segments_, row, stays_column, left);
  }
  branches_title_->setVisible(answer && !answer->branches.empty());
  branches_->setVisible(answer && !answer->branches.empty());
  if (answer == nullptr) {
    alive_->setText(live_->problem() ? translated(*live_->problem()) : QString());
    unrolled_->hide();
    Q_EMIT drawing_changed();
    return;
  }
  QStringList lines;
  const auto of_liver = [](double percent) { return QLocale().toString(percent, 'f', 1); };
  const bool told_elsewhere = taken_.empty();  // a plane or sheet is measured on the mesh, with its margins
  if (told_elsewhere) {
    lines << tr("%1 % of the liver without tumours stay.").arg(of_liver(answer->remnant_percent()));
  } else {
    lines << tr("<b>%1 ml</b> removed, <b>%2 ml</b> stay: %3 % of the liver without tumours.")
                 .arg(number(answer->removed_ml, 0), number(answer->remnant_ml, 0),
                      of_liver(answer->remnant_percent()));
  }
  if (answer->ablated_ml > 0) lines << tr("%1 ml of what goes are ablated.").arg(number(answer->ablated_ml, 0));
  if (answer->living_ml) {
    lines << tr("<b>%1 ml</b> of it stay alive, perfused and drained (%2 %); without inflow %3 ml, without outflow %4 "
                "ml.")
                 .arg(number(*answer->living_ml, 0), of_liver(answer->living_percent()),
                      number(*answer->ischaemic_ml, 0), number(*answer->congested_ml, 0));
  }
  if (answer->margin_mm && !told_elsewhere) {
    lines << (answer->margin_is_at_least ? tr("Smallest margin: at least %1 mm.") : tr("Smallest margin: %1 mm."))
                 .arg(number(*answer->margin_mm, 1));
  }
  for (const planning::MarginAnswer& tumour : answer->tumours) {
    if (told_elsewhere) break;
    if (tumour.side == planning::Side::left)
      lines << tr("▲ %1 stays in the patient.").arg(structure_label(tumour.tumour));
    if (tumour.side == planning::Side::cut_through)
      lines << tr("▲ %1 is cut through.").arg(structure_label(tumour.tumour));
  }
  if (answer->left.mean_kPa) {
    lines << tr("What stays has %1 kPa; %2 % of it was measured.")
                 .arg(number(*answer->left.mean_kPa, 1), number(100 * answer->left.confident_share, 0));
  }
  alive_->setText(lines.join("<br>"));
  show_unrolled();
  show_branches(*answer);
  Q_EMIT drawing_changed();
}

// Each system in the colour that it has in space; so many veins, and so many arteries and ducts.
void PlanByAnatomy::show_branches(const planning::PlanAnswer& answer) {
  constexpr int most_rows = 12;
  std::array<int, 2> rows{};
  branches_->setRowCount(0);
  for (const planning::CutBranch& cut : answer.branches) {
    const vasculature::TreeBranch& branch = live_->anatomy()->planner.trees().branches[cut.branch];
    const auto told = planning::beyond_cut(cut, branch.system);
    if (!told || rows.at(vasculature::is_vein(branch.system) ? 0 : 1)++ >= most_rows) continue;
    const int row = branches_->rowCount();
    branches_->insertRow(row);
    put(*branches_, row, branch_column, branch_label(branch.name))
        ->setIcon(swatch(scene::appearance_of(vasculature::system_name(branch.system)).colour));
    put(*branches_, row, width_column, number(2 * cut.radius_mm, 1));
    const auto with_unit = [&](double much) { return number(much, 0) + QChar::Nbsp + told->unit; };
    put(*branches_, row, beyond_column, with_unit(told->beyond));
    QTableWidgetItem* left = put(*branches_, row, left_column, with_unit(told->left));
    if (told->left >= 10) left->setForeground(theme_colour("warning"));
  }
  fit_height(*branches_);
}

void PlanByAnatomy::show_keeping() {
  const bool held_aside = surface_ && surface_->liver == casefile::PlannedCut::Liver::held_aside;
  plans_->allow_keeping(complete(),
                        folder_.empty()                      ? tr("This patient is not kept in a case folder")
                        : !divides_liver() && taken_.empty() ? tr("Needs a cut through the liver")
                        : !divides_liver() ? tr("Keeps it in the case under this name, beside the others")
                        : held_aside
                            ? tr("Keeps the cut on the liver held aside, for the report; the table is of plans at rest")
                            : tr("Keeps it in the case under this name, beside the others; Rehearse, Guide and the "
                                 "report then follow it"));
}

void PlanByAnatomy::show_unrolled() {
  const auto& result = live_->result();
  const auto is_surface = [](const planning::Cut& cut) {
    return std::holds_alternative<planning::PlaneCut>(cut) || std::holds_alternative<planning::SheetCut>(cut);
  };
  const bool has_surface = result && std::any_of(result->cuts.begin(), result->cuts.end(), is_surface);
  unrolled_->setVisible(has_surface);
  if (!has_surface || result->resectograms.empty()) return;
  const planning::Resectogram& map = result->resectograms.front();
  resectogram_->show_map(map);
  const auto nearest = nearest_mm(map);
  const bool has_tumours = !result->answer.tumours.empty();
  nearest_->setText(!has_tumours    ? tr("No tumour is outlined: the map shows the vessels alone.")
                    : !nearest      ? tr("No tumour within %1 mm of the cut.").arg(planning::largest_margin_mm)
                    : *nearest <= 0 ? tr("▲ The cut goes through a tumour.")
                                    : tr("At the nearest the cut is %1 mm from a tumour.").arg(number(*nearest, 1)));
}

bool PlanByAnatomy::draws_liver() const {
  return (live_->anatomy() && show_segments_->isChecked()) || (live_->result() && live_->result()->removed);
}

void PlanByAnatomy::add_to(WorkspaceScene& scene) const {
  const auto& anatomy = live_->anatomy();
  if (anatomy && show_segments_->isChecked()) {
    for (std::size_t s = 1; s <= 8; ++s) {
      if (!anatomy->segments[s]) continue;
      scene.surfaces.push_back({"liver", anatomy->segments[s], colour_of_segment(s), 0.75, scene::Finish::solid, {}});
      scene.key.push_back({colour_of_segment(s), vasculature::segment_name(s)});
    }
    return;
  }
  const auto& result = live_->result();
  if (!result || !result->removed) return;
  const scene::Appearance look = scene::appearance_of("liver");
  if (result->left) scene.surfaces.push_back({"liver", result->left, look.colour, look.opacity, look.finish, {}});
  scene.surfaces.push_back({"liver", result->removed, specimen_colour(), look.opacity, look.finish, {}});
  scene.key = {{specimen_colour(), tr("Removed").toStdString()}, {remnant_colour(), tr("Stays").toStdString()}};
}

}  // namespace glisson::widgets
