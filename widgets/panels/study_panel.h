#pragma once
// The left panel: who this is, what the slices show, and the structures with their colours and volumes.

#include <QComboBox>
#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

#include "widgets/session/patient.h"
#include "widgets/views/patient_views.h"

namespace glisson::widgets {

class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void show_patient(const Patient& patient);
  // These with their volumes, in the place of the patient's; what was unticked stays so.
  void list(const std::vector<PatientStructure>& structures);

 Q_SIGNALS:
  void slice_image_chosen(glisson::widgets::SliceImage image);
  void structure_shown(const std::string& name, bool shown);

 private:
  void update_patient_text();

  Patient patient_;
  QLabel* name_;
  QLabel* facts_;
  QComboBox* slice_image_;
  QTreeWidget* structures_;
};

}  // namespace glisson::widgets
