// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/curve_commands.h"

#include <cassert>

#include "ui/commands/command_ids.h"

namespace flatland::ui {

namespace {

/// The curves with the chain of one of them replaced.
std::vector<SceneCurve> withChain(std::vector<SceneCurve> curves, std::size_t index,
                                  BezierChain chain) {
  assert(index < curves.size());
  curves[index].shape = std::move(chain);
  return curves;
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
    if (!indices.empty()) curves[c].shape = movePoints(curves[c].chain(), indices, delta, mode);
  }
  return curves;
}

std::vector<SceneCurve> placed(const Scene& scene, const PointRef& ref, const Vec2& target) {
  const BezierChain& before = scene.curves[ref.curve].chain();
  const Vec2 delta = target - before.points()[ref.point];
  if (delta.isZero(0.0)) return scene.curves;
  BezierChain chain = movePoints(before, {ref.point}, delta, JointMode::Keep);
  chain.setPoint(ref.point, target);  // p + (target - p) need not be target
  return withChain(scene.curves, ref.curve, std::move(chain));
}

std::vector<SceneCurve> flipped(std::vector<SceneCurve> curves, std::size_t index) {
  curves[index].flipNormal = !curves[index].flipNormal;
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
    : CurvesCommand(document, withChain(document.scene().curves, curve,
                                        splitAt(document.scene().curves[curve].chain(), t))) {
  setText(tr("insert point"));
}

RaiseDegree::RaiseDegree(Document& document, std::size_t curve)
    : CurvesCommand(document, withChain(document.scene().curves, curve,
                                        elevated(document.scene().curves[curve].chain()))) {
  setText(tr("raise degree"));
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
    if (indices.size() == curve.chain().points().size()) continue;
    removal.curves.push_back(curve);
    if (indices.empty()) continue;
    RemovalResult result = removePoints(curve.chain(), indices);
    if (!result.chain) {
      removal.reason = std::move(result.reason);
      return removal;
    }
    removal.curves.back().shape = std::move(*result.chain);
  }
  return removal;
}

RemovePoints::RemovePoints(Document& document, PointRemoval removal)
    : CurvesCommand(document, std::move(removal.curves)) {
  assert(removal.possible());
  setText(tr("remove points"));
}

AddCurve::AddCurve(Document& document, SceneCurve curve)
    : CurvesCommand(document, withCurve(document.scene().curves, std::move(curve))) {
  setText(tr("add curve"));
}

RemoveCurve::RemoveCurve(Document& document, std::size_t curve)
    : CurvesCommand(document, withoutCurve(document.scene().curves, curve)) {
  setText(tr("remove curve"));
}

}  // namespace flatland::ui
