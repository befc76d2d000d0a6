// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "flatland/curve/chain_editing.h"
#include "ui/flat/gesture.h"

namespace flatland::ui {

/// A press becomes a drag when the pointer has moved this many pixels; before, it is a click.
inline constexpr double kDragThresholdPx = 3.0;

/// Holds the stage while it lives, so that ring and screen stand still.
class StageHold {
 public:
  explicit StageHold(Stage& stage) : stage_(stage) { stage_.hold(); }
  ~StageHold() { stage_.release(); }
  StageHold(const StageHold&) = delete;
  StageHold& operator=(const StageHold&) = delete;

 private:
  Stage& stage_;
};

/// Drags control points: the pressed one with all that are selected, or a whole curve. A click
/// selects. Ctrl keeps to one axis, Alt leaves handles behind.
class MovePointsGesture : public Gesture {
 public:
  struct Plan {
    std::set<PointRef> moving;
    std::set<PointRef> selected;            ///< the selection from the press on
    std::set<PointRef> clicked;             ///< the selection that a mere click leaves
    std::optional<std::size_t> curve = {};  ///< one without points that moves as a whole
    Vec2 anchor;  ///< the place whose coordinates are shown, before the drag
    std::optional<Probe::Place> probe = {};  ///< where a mere click puts the probe
  };
  MovePointsGesture(const CanvasModels& models, Plan plan, const Pointer& pressed);

  void move(const Pointer& pointer) override;
  void finish(const Pointer& pointer) override;
  void cancel() override;
  QString status() const override;
  void paint(QPainter& painter) const override;

 private:
  enum class State { Pressed, Dragging };
  void moveTo(const Vec2& delta, JointMode mode);

  CanvasModels models_;
  StageHold hold_;
  State state_ = State::Pressed;
  Plan plan_;
  std::set<PointRef> before_;
  Scene start_;
  Vec2 delta_ = Vec2::Zero();
  QPointF pressed_;
  int gesture_;
};

/// Turns the view by its handle, and in perspective takes the viewer nearer or farther. Shift snaps
/// to 15 degrees, Ctrl keeps the distance.
class TurnViewGesture : public Gesture {
 public:
  TurnViewGesture(const CanvasModels& models, const Pointer& pressed, const QSizeF& canvas);

  void move(const Pointer& pointer) override;
  void finish(const Pointer& pointer) override;
  void cancel() override;
  QString status() const override;
  void paint(QPainter& painter) const override;
  bool survives(const Change& change) const override { return change.what != Change::What::Scene; }

 private:
  CanvasModels models_;
  StageHold hold_;
  QSizeF canvas_;
  View start_;
  QPointF pressed_;
  QPointF grip_;  ///< from the pointer to the middle of the handle, so that it does not jump
  bool atEdge_;   ///< a handle at the edge tells a direction, not a distance
  bool moved_ = false;
  int gesture_;
};

/// Draws a rectangle and selects the points inside; with Shift in addition to those selected. A
/// click on nothing clears the selection.
class RubberBandGesture : public Gesture {
 public:
  RubberBandGesture(const CanvasModels& models, const Pointer& pressed);

  void move(const Pointer& pointer) override;
  void finish(const Pointer& pointer) override;
  void cancel() override;
  QString status() const override;
  void paint(QPainter& painter) const override;

 private:
  enum class State { Pressed, Banding };

  CanvasModels models_;
  State state_ = State::Pressed;
  std::set<PointRef> before_;
  bool adding_;
  QPointF pressed_;
  QPointF now_;
};

/// Picks a mark. Nothing to drag: marks follow from the curve and the view.
class PickMarkGesture : public Gesture {
 public:
  PickMarkGesture(const CanvasModels& models, std::size_t mark);

  void move(const Pointer&) override {}
  void finish(const Pointer&) override {}
  void cancel() override;
  QString status() const override;
  void paint(QPainter&) const override {}

 private:
  CanvasModels models_;
  std::optional<MarkKey> before_;
};

/// Slides the probe along its curve.
class ProbeGesture : public Gesture {
 public:
  ProbeGesture(const CanvasModels& models, const Target& target, const Pointer& pressed);

  void move(const Pointer& pointer) override;
  void finish(const Pointer& pointer) override;
  void cancel() override;
  QString status() const override;
  void paint(QPainter& painter) const override;

 private:
  CanvasModels models_;
  std::optional<Probe::Place> before_;
  std::optional<std::size_t> mark_;  ///< below the probe
  QPointF pressed_;
  bool moved_ = false;
};

/// Moves the canvas.
class PanGesture : public Gesture {
 public:
  PanGesture(const CanvasModels& models, const Pointer& pressed);

  void move(const Pointer& pointer) override;
  void finish(const Pointer& pointer) override { move(pointer); }
  void cancel() override;
  QString status() const override;
  void paint(QPainter&) const override {}
  bool survives(const Change& change) const override { return change.what != Change::What::Scene; }

 private:
  CanvasModels models_;
  QPointF last_;
  QPointF total_;
};

/// A small opaque label with `text` beside `at`, kept inside the canvas.
void paintLabel(QPainter& painter, const QPointF& at, const QString& text);

/// Coordinates for reading while dragging: as many digits as a pixel is worth.
QString coordinates(const Viewport& viewport, const Vec2& point);

}  // namespace flatland::ui
