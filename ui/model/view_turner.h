// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/model/document.h"
#include "ui/model/probe.h"
#include "ui/model/stage.h"

namespace flatland::ui {

/// Turns the view for a gesture of a panel: a drag, a key held down, an animation. All turns from
/// begin() to end() are one step for undo, which vanishes if the view comes back to where it began.
class ViewTurner {
 public:
  ViewTurner(Document& document, Stage& stage) : document_(document), stage_(stage) {}
  ~ViewTurner() { end(); }
  ViewTurner(const ViewTurner&) = delete;
  ViewTurner& operator=(const ViewTurner&) = delete;

  bool isActive() const { return start_.has_value(); }

  /// Begins a gesture, if none is under way. The stage stands still until its end.
  void begin();

  /// The view at this angle, normalized; the distance stays. Within a gesture part of it, else a
  /// step of its own.
  void turnTo(double angleDeg);

  /// To the next whole multiple of |degrees| in the direction of its sign, so that a step there and
  /// one back is where it began. Precondition: not 0.
  void turnByStep(double degrees);

  /// The same, and the probe at a place: undo brings back both.
  void turnTo(double angleDeg, Probe& probe, const Probe::Place& place);

  void end();

  /// Ends the gesture with the view that was there when it began.
  void cancel();

 private:
  Document& document_;
  Stage& stage_;
  std::optional<View> start_;
  int gesture_ = 0;
};

}  // namespace flatland::ui
