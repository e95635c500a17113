#include "widgets/words/keep_translated.h"

#include <QEvent>
#include <utility>

namespace glisson::widgets {
namespace {

class Rewording : public QObject {
 public:
  Rewording(QWidget* owner, std::function<void()> set_texts) : QObject(owner), set_texts_(std::move(set_texts)) {
    owner->installEventFilter(this);
    set_texts_();
  }

  bool eventFilter(QObject* owner, QEvent* event) override {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::ThemeChange) set_texts_();
    return QObject::eventFilter(owner, event);
  }

 private:
  std::function<void()> set_texts_;
};

}  // namespace

void keep_translated(QWidget* owner, std::function<void()> set_texts) { new Rewording(owner, std::move(set_texts)); }

}  // namespace glisson::widgets
