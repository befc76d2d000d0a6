// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/docks.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

#include "ui/app/dock_title.h"

namespace flatland::ui {

namespace {

constexpr int kSideWidth = 400;
constexpr double kLargestShare = 1.0 / 3.0;  ///< of the window, to the column at the right
constexpr int kEquationsWidth = 480;         ///< both sides of most equations in a line
constexpr double kEquationsShare = 0.4;
constexpr int kBottomHeight = 190;
constexpr int kSeparatorHeight = 6;  ///< below a dock
constexpr int kTabsHeight = 30;
constexpr int kBarsHeight = 44;  ///< menu and status line

Qt::DockWidgetArea areaOf(Docks::Group group) {
  return group == Docks::Group::Bottom ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea;
}

/// Where a panel scrolls the wheel does that, and does not turn the fields that come below it: only
/// one that has the focus.
class WheelScrolls : public QObject {
 public:
  explicit WheelScrolls(QScrollArea& area) : QObject(&area), area_(area) {
    for (QWidget* field : area.widget()->findChildren<QWidget*>()) {
      const bool turns =
          qobject_cast<QAbstractSpinBox*>(field) || qobject_cast<QComboBox*>(field) ||
          (qobject_cast<QAbstractSlider*>(field) && !qobject_cast<QScrollBar*>(field));
      if (!turns) continue;
      if (field->focusPolicy() == Qt::WheelFocus) field->setFocusPolicy(Qt::StrongFocus);
      field->installEventFilter(this);
    }
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    if (static_cast<QWidget*>(watched)->hasFocus()) return false;
    if (area_.verticalScrollBar()->maximum() == 0) return false;
    event->ignore();  // goes on to the area
    return true;
  }

 private:
  QScrollArea& area_;
};

/// A panel that needs more room than its dock has scrolls; so no panel makes the window large.
QScrollArea* scrolled(QWidget* panel) {
  auto* area = new QScrollArea;
  area->setObjectName(panel->objectName() + ".scroll");
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(panel);
  area->setFocusPolicy(Qt::NoFocus);
  area->setFocusProxy(panel);
  area->setMinimumSize(120, 60);
  new WheelScrolls(*area);
  return area;
}

int wantedHeight(const QDockWidget& dock) {
  return static_cast<const QScrollArea*>(dock.widget())->widget()->sizeHint().height() +
         dock.titleBarWidget()->sizeHint().height() + kSeparatorHeight;
}

}  // namespace

Docks::~Docks() { qDeleteAll(all_); }

void Docks::add(const char* id, const QString& title, QWidget* panel, Group group) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(id);
  dock->setAccessibleName(title);
  dock->setTitleBarWidget(new DockTitle(*dock));
  dock->setWidget(scrolled(panel));
  window_.addDockWidget(areaOf(group), dock);
  all_ << dock;
  groups_ << group;
}

QList<QDockWidget*> Docks::inGroup(Group group) const {
  QList<QDockWidget*> found;
  for (qsizetype i = 0; i < all_.size(); ++i) {
    if (groups_[i] == group) found << all_[i];
  }
  return found;
}

QStringList Docks::ids() const {
  QStringList ids;
  for (const QDockWidget* dock : all_) ids << dock->objectName();
  return ids;
}

void Docks::arrangeBut(const QStringList& closed) {
  QStringList open = ids();
  for (const QString& id : closed) open.removeAll(id);
  arrangeOnly(open);
}

void Docks::arrangeOnly(const QStringList& ids) {
  for (QDockWidget* dock : all_) {
    dock->setFloating(false);
    window_.removeDockWidget(dock);
  }
  QList<QDockWidget*> column;  // one of each row at the right
  QList<int> heights;
  int rest = window_.height() - kBarsHeight;
  for (const Group group : {Group::Top, Group::Side, Group::Plots, Group::Bottom}) {
    QDockWidget* front = nullptr;
    QDockWidget* first = nullptr;
    for (QDockWidget* dock : inGroup(group)) {
      // Closed ones have their place too: a saved arrangement knows only docks that have one.
      if (first && group != Group::Top) {
        window_.tabifyDockWidget(first, dock);
      } else {
        window_.addDockWidget(areaOf(group), dock);
        first = dock;
      }
      const bool open = ids.contains(dock->objectName());
      dock->setVisible(open);
      if (!open) continue;
      if (!front || group == Group::Top) {
        front = dock;
        if (group == Group::Bottom) continue;
        column << dock;
        heights << (group == Group::Plots ? qMax(rest, 0) : wantedHeight(*dock));
        rest -= heights.back();
      }
    }
    if (!front) continue;
    front->raise();
    if (group == Group::Side) {
      heights.back() += kTabsHeight;
      rest -= kTabsHeight;
    }
    if (group == Group::Bottom) window_.resizeDocks({front}, {kBottomHeight}, Qt::Vertical);
  }
  if (column.isEmpty()) return;
  window_.resizeDocks(column, heights, Qt::Vertical);
  const int least = equations_ ? kEquationsWidth : kSideWidth;
  const double share = equations_ ? kEquationsShare : kLargestShare;
  const int wide = qMin(qRound(least * scale_), qRound(window_.width() * share));
  window_.resizeDocks({column.front()}, {qMax(kSideWidth, wide)}, Qt::Horizontal);
}

void Docks::show(const char* id) {
  for (QDockWidget* dock : all_) {
    if (dock->objectName() != QLatin1String(id)) continue;
    const bool opens = !dock->isVisible();
    dock->show();
    dock->raise();
    if (opens && !dock->isFloating() && inGroup(Group::Plots).contains(dock)) makeRoom(*dock);
  }
}

void Docks::makeRoom(QDockWidget& dock) {
  const int most = (window_.height() - kBarsHeight) / 2;
  window_.resizeDocks({&dock}, {qMin(wantedHeight(dock) + kTabsHeight, most)}, Qt::Vertical);
}

void Docks::setHeight(const char* id, int height) {
  for (QDockWidget* dock : all_) {
    if (dock->objectName() != QLatin1String(id) || dock->isFloating()) continue;
    const int title = dock->titleBarWidget()->sizeHint().height();
    const int row =
        height + title + (window_.tabifiedDockWidgets(dock).isEmpty() ? 0 : kTabsHeight);
    window_.resizeDocks({dock}, {qMin(row, window_.height() * 9 / 20)}, Qt::Vertical);
  }
}

void Docks::setHeading(const char* id, const QString& heading) {
  for (QDockWidget* dock : all_) {
    if (dock->objectName() != QLatin1String(id)) continue;
    static_cast<DockTitle*>(dock->titleBarWidget())
        ->setText(heading.isEmpty() ? dock->windowTitle() : heading);
  }
}

void Docks::hide(const char* id) {
  for (QDockWidget* dock : all_) {
    if (dock->objectName() == QLatin1String(id)) dock->hide();
  }
}

}  // namespace flatland::ui
