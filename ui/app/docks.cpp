// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/docks.h"

#include <QDockWidget>

namespace flatland::ui {

namespace {

constexpr int kSideWidth = 400;
constexpr int kBottomHeight = 190;

Qt::DockWidgetArea areaOf(Docks::Group group) {
  return group == Docks::Group::Bottom ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea;
}

}  // namespace

Docks::~Docks() { qDeleteAll(all_); }

void Docks::add(const char* id, const QString& title, QWidget* panel, Group group) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(id);
  dock->setWidget(panel);
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

void Docks::arrange() {
  for (QDockWidget* dock : all_) {
    dock->setFloating(false);
    window_.removeDockWidget(dock);
  }
  QList<QDockWidget*> column;  // one of each row at the right
  QList<int> heights;
  int rest = window_.height();
  for (const Group group : {Group::Top, Group::Side, Group::Plots, Group::Bottom}) {
    const QList<QDockWidget*> docks = inGroup(group);
    for (qsizetype i = 0; i < docks.size(); ++i) {
      if (i == 0 || group == Group::Top) {
        window_.addDockWidget(areaOf(group), docks[i]);
      } else {
        window_.tabifyDockWidget(docks[i - 1], docks[i]);
      }
      docks[i]->show();
      if (group == Group::Top) {
        column << docks[i];
        heights << docks[i]->sizeHint().height();
        rest -= heights.back();
      }
    }
    if (docks.isEmpty() || group == Group::Top) continue;
    docks.front()->raise();
    if (group == Group::Side) {
      column << docks.front();
      heights << docks.front()->sizeHint().height();
      rest -= heights.back();
    } else if (group == Group::Plots) {
      column << docks.front();
      heights << qMax(rest, 0);
    } else {
      window_.resizeDocks({docks.front()}, {kBottomHeight}, Qt::Vertical);
    }
  }
  window_.resizeDocks(column, heights, Qt::Vertical);
  if (!column.isEmpty()) window_.resizeDocks({column.front()}, {kSideWidth}, Qt::Horizontal);
}

void Docks::show(const char* id) {
  for (QDockWidget* dock : all_) {
    if (dock->objectName() != QLatin1String(id)) continue;
    dock->show();
    dock->raise();
  }
}

}  // namespace flatland::ui
