// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/wrap_row.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace flatland::ui {

namespace {

constexpr int kGapPx = 3;

QSize sizeOf(const QWidget& widget) {
  return widget.sizeHint().expandedTo(widget.minimumSizeHint()).expandedTo(widget.minimumSize());
}

bool grows(const QWidget& widget) {
  return widget.sizePolicy().expandingDirections().testFlag(Qt::Horizontal);
}

}  // namespace

WrapRow::WrapRow(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void WrapRow::add(QWidget* widget) {
  widget->setParent(this);
  items_ << widget;
  arrange();
}

void WrapRow::add(const QString& name, QWidget* field) {
  auto* pair = new QWidget;
  auto* label = new QLabel(name);
  label->setBuddy(field);
  auto* layout = new QHBoxLayout(pair);
  layout->setContentsMargins({});
  layout->setSpacing(4);
  layout->addWidget(label);
  layout->addWidget(field, 1);
  pair->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  add(pair);
}

QSize WrapRow::sizeHint() const {
  int width = 0;
  for (const QWidget* item : items_) {
    if (!item->isHidden()) width += (width > 0 ? kGapPx : 0) + sizeOf(*item).width();
  }
  return {width, minimumHeight()};
}

QSize WrapRow::minimumSizeHint() const {
  int width = 0;
  for (const QWidget* item : items_) {
    if (!item->isHidden()) width = qMax(width, sizeOf(*item).width());
  }
  return {width, minimumHeight()};
}

bool WrapRow::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::FontChange:
      // The fields get it after the row.
      QCoreApplication::postEvent(this, new QEvent(QEvent::LayoutRequest));
      break;
    case QEvent::Show:
    case QEvent::LayoutRequest:
      // A field has got another size, has come or gone.
      arrange();
      updateGeometry();
      break;
    default:
      break;
  }
  return QWidget::event(event);
}

void WrapRow::resizeEvent(QResizeEvent*) { arrange(); }

void WrapRow::arrange() {
  QList<QList<QWidget*>> rows;
  int used = 0;
  for (QWidget* item : items_) {
    if (item->isHidden()) continue;
    const int wanted = sizeOf(*item).width();
    if (rows.isEmpty() || used + kGapPx + wanted > width()) {
      rows << QList<QWidget*>{};
      used = 0;
    }
    used += (rows.back().isEmpty() ? 0 : kGapPx) + wanted;
    rows.back() << item;
  }
  int y = 0;
  for (const QList<QWidget*>& row : rows) {
    int height = 0, left = width() - kGapPx * (static_cast<int>(row.size()) - 1), growing = 0;
    for (const QWidget* item : row) {
      height = qMax(height, sizeOf(*item).height());
      left -= sizeOf(*item).width();
      if (grows(*item)) ++growing;
    }
    int x = 0;
    for (QWidget* item : row) {
      const QSize size = sizeOf(*item);
      int wide = qMin(size.width(), width());
      if (grows(*item) && left > 0) {
        const int share = left / growing--;
        wide += share;
        left -= share;
      }
      item->setGeometry(x, y + (height - size.height()) / 2, wide, size.height());
      x += wide + kGapPx;
    }
    y += height + kGapPx;
  }
  const int height = qMax(0, y - kGapPx);
  if (height != minimumHeight()) setFixedHeight(height);
}

}  // namespace flatland::ui
