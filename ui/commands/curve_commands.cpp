// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/curve_commands.h"

#include <cassert>

#include "ui/commands/command_ids.h"

namespace flatland::ui {

namespace {

/// The curves with the shape of one of them replaced.
std::vector<SceneCurve> withShape(std::vector<SceneCurve> curves, std::size_t index, Curve shape) {
  assert(index < curves.size());
  curves[index].shape = std::move(shape);
  return curves;
}

/// The curves with one edited; as they are if that cannot be.
std::vector<SceneCurve> withEdited(std::vector<SceneCurve> curves, std::size_t index,
                                   EditResult edited) {
  if (!edited.curve) return curves;
  return withShape(std::move(curves), index, std::move(*edited.curve));
}

std::vector<SceneCurve> moved(const Scene& from, const std::set<PointRef>& points,
                              const Vec2& delta, JointMode mode) {
  std::vector<SceneCurve> curves = from.curves;
  // Turning a handle by nothing may round: no movement must mean the very same numbers.
  if (delta.isZero(0.0)) return curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    std::set<std::size_t> indices;
    for (const PointRef& ref : points) {
      if (ref.curve == c) indices.insert(ref.point);
    }
    if (!indices.empty()) curves[c].shape = movePoints(curves[c].shape, indices, delta, mode);
  }
  return curves;
}

std::vector<SceneCurve> placed(const Scene& scene, const PointRef& ref, const Vec2& target) {
  const Curve& before = scene.curves[ref.curve].shape;
  const Vec2 delta = target - controlPoints(before)[ref.point];
  if (delta.isZero(0.0)) return scene.curves;
  const Curve after = movePoints(before, {ref.point}, delta, JointMode::Keep);
  // p + (target - p) need not be target
  return withShape(scene.curves, ref.curve, withPoint(after, ref.point, target));
}

std::vector<SceneCurve> flipped(std::vector<SceneCurve> curves, std::size_t index) {
  curves[index].flipNormal = !curves[index].flipNormal;
  return curves;
}

std::vector<SceneCurve> withCurves(std::vector<SceneCurve> curves,
                                   const std::vector<SceneCurve>& more) {
  curves.insert(curves.end(), more.begin(), more.end());
  return curves;
}

std::vector<SceneCurve> withCurve(std::vector<SceneCurve> curves, SceneCurve curve) {
  curves.push_back(std::move(curve));
  return curves;
}

std::vector<SceneCurve> withoutCurve(std::vector<SceneCurve> curves, std::size_t index) {
  assert(index < curves.size());
  curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(index));
  return curves;
}

}  // namespace

CurvesCommand::CurvesCommand(Document& document, std::vector<SceneCurve> after, int gesture)
    : document_(document), curves_(std::move(after)), gesture_(gesture) {
  setObsolete(curves_ == document_.scene().curves);
}

CurvesCommand::CurvesCommand(Document& document, std::vector<SceneCurve> after,
                             std::vector<std::size_t> removed)
    : CurvesCommand(document, std::move(after)) {
  shift_.curves = std::move(removed);
}

void CurvesCommand::swap(const CurveShift& shift) {
  if (shift.curves.empty()) return document_.swapCurves(curves_);
  document_.swapCurves(curves_, shift, swept_);
}

int CurvesCommand::id() const { return gesture_ == kNoGesture ? -1 : kCurvesCommandId; }

bool CurvesCommand::mergeWith(const QUndoCommand* other) {
  if (static_cast<const CurvesCommand*>(other)->gesture_ != gesture_) return false;
  // The other is done already: curves_ holds the beginning, the document what came of it.
  setObsolete(curves_ == document_.scene().curves);
  return true;
}

MovePoints::MovePoints(Document& document, const Scene& from, const std::set<PointRef>& points,
                       const Vec2& delta, JointMode mode, int gesture)
    : CurvesCommand(document, moved(from, points, delta, mode), gesture) {
  setText(points.size() == 1 ? tr("move point") : tr("move points"));
}

PlacePoint::PlacePoint(Document& document, const PointRef& point, const Vec2& target)
    : CurvesCommand(document, placed(document.scene(), point, target)) {
  setText(tr("type coordinates"));
}

InsertPoint::InsertPoint(Document& document, std::size_t curve, double t)
    : CurvesCommand(document, withEdited(document.scene().curves, curve,
                                         withPointAt(document.scene().curves[curve].shape, t))) {
  setText(tr("insert point"));
}

RaiseDegree::RaiseDegree(Document& document, std::size_t curve)
    : CurvesCommand(document, withEdited(document.scene().curves, curve,
                                         withRaisedDegree(document.scene().curves[curve].shape))) {
  setText(tr("raise degree"));
}

ReplaceCurve::ReplaceCurve(Document& document, std::size_t index, Curve shape, const QString& text,
                           int gesture)
    : CurvesCommand(document, withShape(document.scene().curves, index, std::move(shape)),
                    gesture) {
  setText(text);
}

MoveCurve::MoveCurve(Document& document, const Scene& from, std::size_t curve, const Vec2& delta,
                     int gesture)
    : CurvesCommand(document,
                    delta.isZero(0.0) ? from.curves
                                      : withShape(from.curves, curve,
                                                  translated(from.curves[curve].shape, delta)),
                    gesture) {
  setText(tr("move curve"));
}

FlipNormal::FlipNormal(Document& document, std::size_t curve)
    : CurvesCommand(document, flipped(document.scene().curves, curve)) {
  setText(tr("flip normal"));
}

PointRemoval withoutPoints(const Scene& scene, const std::set<PointRef>& points) {
  PointRemoval removal;
  for (std::size_t c = 0; c < scene.curves.size(); ++c) {
    const SceneCurve& curve = scene.curves[c];
    std::set<std::size_t> indices;
    for (const PointRef& ref : points) {
      if (ref.curve == c) indices.insert(ref.point);
    }
    if (!indices.empty() && indices.size() == controlPoints(curve.shape).size()) {
      removal.removed.push_back(c);
      continue;
    }
    removal.curves.push_back(curve);
    if (indices.empty()) continue;
    EditResult result = withoutPoints(curve.shape, indices);
    if (!result.curve) {
      removal.reason = std::move(result.reason);
      return removal;
    }
    removal.curves.back().shape = std::move(*result.curve);
  }
  return removal;
}

RemovePoints::RemovePoints(Document& document, PointRemoval removal)
    : CurvesCommand(document, std::move(removal.curves), std::move(removal.removed)) {
  assert(removal.possible());
  setText(tr("remove points"));
}

AddCurve::AddCurve(Document& document, SceneCurve curve)
    : CurvesCommand(document, withCurve(document.scene().curves, std::move(curve))) {
  setText(tr("add curve"));
}

AddCurves::AddCurves(Document& document, const std::vector<SceneCurve>& curves, const QString& text)
    : CurvesCommand(document, withCurves(document.scene().curves, curves)) {
  setText(text);
}

RemoveCurve::RemoveCurve(Document& document, std::size_t curve)
    : CurvesCommand(document, withoutCurve(document.scene().curves, curve),
                    std::vector<std::size_t>{curve}) {
  setText(tr("remove curve"));
}

}  // namespace flatland::ui
