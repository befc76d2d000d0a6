// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QUndoCommand>
#include <set>
#include <string>
#include <vector>

#include "flatland/curve/curve_editing.h"
#include "ui/model/document.h"
#include "ui/model/selection.h"

namespace flatland::ui {

/// A command that belongs to no gesture is a step of its own.
inline constexpr int kNoGesture = 0;

/// Base of every edit of curves: holds the other list of curves and exchanges it with the
/// document's, so undo and redo are the same swap. Obsolete from the start if nothing would change.
/// Commands of one gesture (Document::newGesture) become one step, which vanishes if the gesture
/// ends where it began.
class CurvesCommand : public QUndoCommand {
 public:
  void undo() override { swap(shift_.back()); }
  void redo() override { swap(shift_); }
  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;

 protected:
  CurvesCommand(Document& document, std::vector<SceneCurve> after, int gesture = kNoGesture);
  /// For curves that go as a whole: a surface that is swept from one of them goes with it.
  CurvesCommand(Document& document, std::vector<SceneCurve> after,
                std::vector<std::size_t> removed);

 private:
  void swap(const CurveShift& shift);

  Document& document_;
  std::vector<SceneCurve> curves_;
  CurveShift shift_;                     ///< of redo
  std::optional<SurfaceSetting> swept_;  ///< that went with its curve
  int gesture_;
};

/// Moves points by `delta`, counted from `from` (the scene when the gesture began): a drag, a
/// nudge. A zero delta restores `from` to the last bit. Precondition: points exist in `from`.
class MovePoints : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(MovePoints)
 public:
  MovePoints(Document& document, const Scene& from, const std::set<PointRef>& points,
             const Vec2& delta, JointMode mode, int gesture = kNoGesture);
};

/// Puts one point at typed coordinates; its handles follow as in a drag (JointMode::Keep).
class PlacePoint : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(PlacePoint)
 public:
  PlacePoint(Document& document, const PointRef& point, const Vec2& target);
};

/// Adds a point at parameter t: the shape stays (withPointAt). Nothing to do for a curve that
/// cannot have one.
class InsertPoint : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(InsertPoint)
 public:
  InsertPoint(Document& document, std::size_t curve, double t);
};

/// Writes every piece of the curve with one more control point: the shape stays. Nothing to do for
/// a curve that has no degree to raise.
class RaiseDegree : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(RaiseDegree)
 public:
  RaiseDegree(Document& document, std::size_t curve);
};

/// Puts another shape in the place of one. `text` names the edit for the Undo menu.
class ReplaceCurve : public CurvesCommand {
 public:
  ReplaceCurve(Document& document, std::size_t index, Curve shape, const QString& text,
               int gesture = kNoGesture);
};

/// Moves a curve as a whole by `delta`, counted from `from`: also one without points.
class MoveCurve : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(MoveCurve)
 public:
  MoveCurve(Document& document, const Scene& from, std::size_t curve, const Vec2& delta,
            int gesture = kNoGesture);
};

/// Turns the normal of the curve round.
class FlipNormal : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(FlipNormal)
 public:
  FlipNormal(Document& document, std::size_t curve);
};

/// What is left without the points, or why they cannot go, in words for a person. A curve all
/// of whose points are named goes as a whole.
struct PointRemoval {
  std::vector<SceneCurve> curves;
  std::vector<std::size_t> removed;  ///< those that go as a whole, rising
  std::string reason;                ///< empty if the points can go

  bool possible() const { return reason.empty(); }
};
PointRemoval withoutPoints(const Scene& scene, const std::set<PointRef>& points);

/// Removes points. Precondition: removal.possible().
class RemovePoints : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(RemovePoints)
 public:
  RemovePoints(Document& document, PointRemoval removal);
};

/// Adds a curve at the end.
class AddCurve : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(AddCurve)
 public:
  AddCurve(Document& document, SceneCurve curve);
};

/// Adds several curves at the end, as one step. `text` names it.
class AddCurves : public CurvesCommand {
 public:
  AddCurves(Document& document, const std::vector<SceneCurve>& curves, const QString& text);
};

/// Removes the curve with all its points.
class RemoveCurve : public CurvesCommand {
  Q_DECLARE_TR_FUNCTIONS(RemoveCurve)
 public:
  RemoveCurve(Document& document, std::size_t curve);
};

}  // namespace flatland::ui
