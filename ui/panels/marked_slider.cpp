// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/marked_slider.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>

namespace flatland::ui {

namespace {

constexpr int kMarkPx = 7;

}  // namespace

MarkedSlider::MarkedSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

void MarkedSlider::setMark(std::optional<int> value) {
  if (value == mark_) return;
  mark_ = value;
  update();
}

QSize MarkedSlider::sizeHint() const { return QSlider::sizeHint() + QSize(0, kMarkPx); }

void MarkedSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  if (!mark_ || *mark_ < minimum() || *mark_ > maximum()) return;
  QStyleOptionSlider option;
  initStyleOption(&option);
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
  const int x =
      handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), *mark_, width() - handle);
  const QPolygon triangle({{x, height() - kMarkPx}, {x - 5, height()}, {x + 5, height()}});
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(isEnabled() ? QPalette::WindowText : QPalette::Mid));
  painter.drawPolygon(triangle);
}

}  // namespace flatland::ui
