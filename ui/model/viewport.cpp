// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/viewport.h"

#include <algorithm>
#include <cassert>

namespace flatland::ui {

Viewport::Viewport(QObject* parent) : QObject(parent) {}

QPointF Viewport::toWidget(const Vec2& world) const {
  return {size_.width() / 2 + (world.x() - centre_.x()) * scale_,
          size_.height() / 2 - (world.y() - centre_.y()) * scale_};
}

Vec2 Viewport::toWorld(const QPointF& widget) const {
  return {centre_.x() + (widget.x() - size_.width() / 2) / scale_,
          centre_.y() - (widget.y() - size_.height() / 2) / scale_};
}

QTransform Viewport::worldToWidget() const {
  const QPointF origin = toWidget(Vec2::Zero());
  return {scale_, 0.0, 0.0, -scale_, origin.x(), origin.y()};
}

void Viewport::setSize(const QSizeF& size, double margin) {
  if ((size == size_ && margin == margin_) || size.isEmpty()) return;
  size_ = size;
  margin_ = margin;
  if (fitted_) {
    fit(fitBox_);
  } else {
    emit changed();
  }
}

void Viewport::fit(const Bounds& box) {
  fitBox_ = box;
  fitted_ = true;
  const Vec2 extent = box.high - box.low;
  const double width = std::max(size_.width() - 2 * margin_, 1.0);
  const double height = std::max(size_.height() - 2 * margin_, 1.0);
  const double across = extent.x() > 0.0 ? width / extent.x() : 0.0;
  const double up = extent.y() > 0.0 ? height / extent.y() : 0.0;
  if (across > 0.0 && up > 0.0) {
    fitScale_ = std::min(across, up);
  } else {
    fitScale_ = std::max(across, up) > 0.0 ? std::max(across, up) : std::min(width, height);
  }
  set(box.centre(), fitScale_);
}

bool Viewport::holds(const Bounds& box) const {
  const QRectF window(QPointF(0.0, 0.0), size_);
  return window.contains(toWidget(box.low)) && window.contains(toWidget(box.high));
}

void Viewport::panBy(const QPointF& pixels) {
  if (pixels.isNull()) return;
  fitted_ = false;
  set(centre_ + Vec2(-pixels.x(), pixels.y()) / scale_, scale_);
}

void Viewport::centreOn(const Vec2& world) {
  if (world == centre_) return;
  fitted_ = false;
  set(world, scale_);
}

void Viewport::zoomAt(const QPointF& widget, double factor) {
  assert(factor > 0.0);
  const double scale = std::clamp(scale_ * factor, fitScale_ / kMaxZoomOut, fitScale_ * kMaxZoomIn);
  if (scale == scale_) return;
  fitted_ = false;
  const Vec2 fixed = toWorld(widget);
  set(fixed + (centre_ - fixed) * (scale_ / scale), scale);
}

void Viewport::zoomAtCentre(double factor) {
  zoomAt({size_.width() / 2, size_.height() / 2}, factor);
}

void Viewport::set(const Vec2& centre, double scale) {
  if (centre == centre_ && scale == scale_) return;
  centre_ = centre;
  scale_ = scale;
  emit changed();
}

}  // namespace flatland::ui
