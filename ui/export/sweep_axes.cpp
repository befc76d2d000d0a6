// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/sweep_axes.h"

#include <algorithm>

namespace flatland::ui {

SweepAxes::SweepAxes(const std::vector<double>& lengths, const Box& box,
                     const std::optional<SweepWindow>& window)
    : lengths_(lengths), box_(box) {
  for (const double length : lengths) {
    starts_.push_back(total_);
    total_ += length;
  }
  if (!(total_ > 0.0)) total_ = 1.0;
  window_ = window.value_or(SweepWindow{.uLow = 0.0, .uHigh = total_});
}

double SweepAxes::x(double angleDeg) const {
  return box_.left + (angleDeg - window_.angleLow) / (window_.angleHigh - window_.angleLow) *
                         (box_.right - box_.left);
}

double SweepAxes::yOf(double stackedU) const {
  return box_.bottom -
         (stackedU - window_.uLow) / (window_.uHigh - window_.uLow) * (box_.bottom - box_.top);
}

double SweepAxes::angleAt(double x) const {
  const double share = std::clamp((x - box_.left) / (box_.right - box_.left), 0.0, 1.0);
  return window_.angleLow + share * (window_.angleHigh - window_.angleLow);
}

double SweepAxes::stackedUAt(double y) const {
  const double share = std::clamp((box_.bottom - y) / (box_.bottom - box_.top), 0.0, 1.0);
  return window_.uLow + share * (window_.uHigh - window_.uLow);
}

std::optional<SweepAxes::Place> SweepAxes::placeAt(const Vec2& px) const {
  if (starts_.empty()) return std::nullopt;
  const double stacked = std::clamp(stackedUAt(px.y()), 0.0, total_);
  int curve = 0;
  while (curve + 1 < curveCount() && stacked >= start(curve + 1)) ++curve;
  return Place{angleAt(px.x()), curve, std::min(stacked - start(curve), length(curve))};
}

std::optional<SweepAxes::Clip> SweepAxes::clipped(const Vec2& a, const Vec2& b) const {
  const Vec2 low(window_.angleLow, window_.uLow), high(window_.angleHigh, window_.uHigh);
  Clip clip{0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    if (step == 0.0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return std::nullopt;
      continue;
    }
    double enter = (low[axis] - a[axis]) / step, leave = (high[axis] - a[axis]) / step;
    if (enter > leave) std::swap(enter, leave);
    clip.from = std::max(clip.from, enter);
    clip.to = std::min(clip.to, leave);
  }
  if (clip.from > clip.to) return std::nullopt;
  return clip;
}

}  // namespace flatland::ui
