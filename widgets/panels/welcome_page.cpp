#include "widgets/panels/welcome_page.h"

#include <algorithm>
#include <QIcon>

#include "widgets/settings/settings.h"
#include "widgets/words/keep_translated.h"
#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maximum_listed = 5;

QLabel* centred(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);  // one long sentence made the window wider than a small screen
  return label;
}

QHBoxLayout* in_the_middle(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  row->addStretch();
  for (QWidget* widget : widgets) row->addWidget(widget);
  row->addStretch();
  return row;
}

}  // namespace

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
  auto* page = new QVBoxLayout(this);
  page->addStretch(2);
  auto* mark = new QLabel;
  mark->setPixmap(QIcon(":/icons/glisson.svg").pixmap(112, 112));
  mark->setAlignment(Qt::AlignCenter);
  page->addWidget(mark);
  QLabel* title = centred("welcome_title");
  page->addWidget(title);
  QLabel* words = centred("faint");
  page->addWidget(words);
  page->addSpacing(12);
  lost_ = new QPushButton;
  lost_->setObjectName("open_lost");
  lost_->hide();
  page->addLayout(in_the_middle({lost_}));
  auto* demo = new QPushButton;
  demo->setObjectName("primary");
  auto* open_case = new QPushButton;
  auto* open_images = new QPushButton;
  page->addLayout(in_the_middle({demo, open_case, open_images}));
  page->addSpacing(18);
  recent_ = new QWidget;
  recent_->setObjectName("recent");
  recent_column_ = new QVBoxLayout(recent_);
  recent_column_->setSpacing(2);
  recent_title_ = centred("heading");
  recent_column_->addWidget(recent_title_);
  page->addLayout(in_the_middle({recent_}));
  page->addSpacing(12);
  stage_ = centred("stage");
  page->addWidget(stage_);
  page->addStretch(3);
  list_recent();

  connect(demo, &QPushButton::clicked, this, &WelcomePage::demo_wanted);
  connect(open_case, &QPushButton::clicked, this, &WelcomePage::case_wanted);
  connect(open_images, &QPushButton::clicked, this, &WelcomePage::images_wanted);
  connect(lost_, &QPushButton::clicked, this, &WelcomePage::lost_wanted);
  keep_translated(this, [=, this] {
    title->setText(tr("Plan a liver operation"));
    words->setText(tr("Drop a case or a folder of DICOM images here, or begin with the demo patient."));
    demo->setText(tr("Open the demo patient"));
    open_case->setText(tr("Open a case..."));
    open_images->setText(tr("Open images..."));
    recent_title_->setText(tr("Opened before"));
    lost_->setText(tr("Glisson ended unexpectedly. Open %1 as it was").arg(text_of(lost_case_.stem())));
  });
}

void WelcomePage::offer_lost(const fs::path& case_folder) {
  lost_case_ = case_folder;
  lost_->setText(tr("Glisson ended unexpectedly. Open %1 as it was").arg(text_of(lost_case_.stem())));
  lost_->show();
}

void WelcomePage::list_recent() {
  const std::vector<fs::path> cases = recent_cases();
  recent_->setVisible(!cases.empty());
  // Cases of one name are told apart by the folder that they lie in.
  const auto is_one_of_several = [&](const fs::path& path) {
    return std::count_if(cases.begin(), cases.end(), [&](const auto& each) { return each.stem() == path.stem(); }) > 1;
  };
  for (std::size_t k = 0; k < std::min(cases.size(), maximum_listed); ++k) {
    const QString name = text_of(cases[k].stem());
    auto* button = new QPushButton(
        is_one_of_several(cases[k]) ? QString("%1  (%2)").arg(name, text_of(cases[k].parent_path())) : name);
    button->setObjectName("recent_case");
    button->setFlat(true);
    button->setToolTip(text_of(cases[k]));
    connect(button, &QPushButton::clicked, this, [this, folder = cases[k]] { Q_EMIT recent_wanted(folder); });
    recent_column_->addWidget(button);
  }
}

}  // namespace glisson::widgets
