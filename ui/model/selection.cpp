// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/selection.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace flatland::ui {

MarkKey keyOf(const FeatureSet& features, std::size_t index) {
  assert(index < features.marks.size());
  const Mark& mark = features.marks[index];
  const auto before = features.marks.begin() + static_cast<std::ptrdiff_t>(index);
  const auto ordinal = std::count_if(features.marks.begin(), before, [&mark](const Mark& m) {
    return m.kind == mark.kind && m.curve == mark.curve;
  });
  return {mark.kind, mark.curve, static_cast<int>(ordinal)};
}

std::optional<std::size_t> indexOf(const FeatureSet& features, const MarkKey& key) {
  int ordinal = 0;
  for (std::size_t i = 0; i < features.marks.size(); ++i) {
    const Mark& mark = features.marks[i];
    if (mark.kind != key.kind || mark.curve != key.curve) continue;
    if (ordinal++ == key.ordinal) return i;
  }
  return std::nullopt;
}

Selection::Selection(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document, &Document::changed, this, &Selection::documentChanged);
}

std::set<std::size_t> Selection::pointsOf(std::size_t curve) const {
  std::set<std::size_t> indices;
  for (const PointRef& ref : points_) {
    if (ref.curve == curve) indices.insert(ref.point);
  }
  return indices;
}

std::optional<std::size_t> Selection::currentCurve() const {
  const std::size_t count = document_.scene().curves.size();
  if (count == 0) return std::nullopt;
  return std::min(currentCurve_, count - 1);
}

void Selection::setPoints(std::set<PointRef> points) {
  std::erase_if(points, [this](const PointRef& ref) { return !exists(ref); });
  if (points == points_) return;
  points_ = std::move(points);
  if (!points_.empty()) currentCurve_ = points_.begin()->curve;
  emit changed();
}

void Selection::toggle(const PointRef& point) {
  std::set<PointRef> points = points_;
  if (points.erase(point) == 0) points.insert(point);
  setPoints(std::move(points));
}

void Selection::setMark(std::optional<MarkKey> mark) {
  if (mark == mark_) return;
  mark_ = mark;
  if (mark_) currentCurve_ = static_cast<std::size_t>(mark_->curve);
  emit changed();
}

void Selection::setCurrentCurve(std::size_t curve) {
  if (curve == currentCurve_) return;
  currentCurve_ = curve;
  emit changed();
}

void Selection::selectAll() { setPoints(allPoints()); }

void Selection::clear() {
  if (points_.empty() && !mark_) return;
  points_.clear();
  mark_.reset();
  emit changed();
}

void Selection::step(int step) {
  const std::set<PointRef> all = allPoints();
  if (all.empty()) return;
  const bool forwards = step > 0;
  if (points_.empty()) {
    setPoints({forwards ? *all.begin() : *all.rbegin()});
    return;
  }
  auto at = all.find(forwards ? *points_.rbegin() : *points_.begin());
  assert(at != all.end());
  if (forwards) {
    ++at;
    setPoints({at == all.end() ? *all.begin() : *at});
  } else {
    setPoints({at == all.begin() ? *all.rbegin() : *std::prev(at)});
  }
}

void Selection::documentChanged(const Change& change) {
  if (change.what == Change::What::Scene) {
    currentCurve_ = 0;
    clear();
  } else if (change.what == Change::What::Topology) {
    goAlong(change.shift);
  }
}

void Selection::goAlong(const CurveShift& shift) {
  // The one beside it where the curve itself has left.
  const std::size_t current = shift.after(currentCurve_).value_or(currentCurve_);
  std::set<PointRef> points;
  for (const PointRef& ref : points_) {
    const std::optional<std::size_t> curve = shift.after(ref.curve);
    if (curve && exists({*curve, ref.point})) points.insert({*curve, ref.point});
  }
  std::optional<MarkKey> mark = mark_;
  if (mark) {
    const auto curve = shift.after(static_cast<std::size_t>(mark->curve));
    if (curve) {
      mark->curve = static_cast<int>(*curve);
    } else {
      mark.reset();
    }
  }
  if (current == currentCurve_ && points == points_ && mark == mark_) return;
  currentCurve_ = current;
  points_ = std::move(points);
  mark_ = mark;
  emit changed();
}

std::set<PointRef> Selection::allPoints() const {
  std::set<PointRef> all;
  const auto& curves = document_.scene().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < controlPoints(curves[c].shape).size(); ++i) all.insert({c, i});
  }
  return all;
}

bool Selection::exists(const PointRef& point) const {
  const auto& curves = document_.scene().curves;
  return point.curve < curves.size() &&
         point.point < controlPoints(curves[point.curve].shape).size();
}

}  // namespace flatland::ui
