// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "ui/model/document.h"

namespace flatland::ui {

/// The circles around the curves on which the window puts the screen and the view handle, in scene
/// lengths. They go by the curves, not by control points far from them, so that the curves are
/// large on the canvas and the screen stays near them from every side. Recomputed when the scene
/// has outgrown or shrunk well inside them, but never while held, so that nothing jumps under the
/// hand during a gesture.
class Stage : public QObject {
  Q_OBJECT

 public:
  explicit Stage(const Document& document, QObject* parent = nullptr);

  const Vec2& centre() const { return centre_; }
  double radius() const { return radius_; }              ///< around all curves
  double ringRadius() const { return kRing * radius_; }  ///< of the orthographic handle

  /// Where the view handle stands: on the ring, or at the viewer in perspective.
  Vec2 handle() const;
  /// The point the handle turns around: the centre of the ring, or the origin in perspective.
  Vec2 pivot() const;

  /// How far from the origin towards the viewer the screen stands: beyond the scene, in
  /// perspective always nearer than the viewer.
  double screenOffset() const;

  /// The view that puts the handle at `world`, as near as can be: the angle to 0.1 degree, or to
  /// 15 if `snap`; in perspective also the distance, to three digits of the scene's size, unless
  /// `keepDistance`. At the pivot itself the angle stays.
  View viewWithHandleAt(const Vec2& world, bool snap, bool keepDistance) const;

  /// A distance that shows the scene in clear perspective, to two digits.
  double suggestedDistance() const;

  /// Decimals with which a distance in this scene is told to four or five digits.
  int distanceDecimals() const;

  /// The box to fit into the window: curves, control points, ring, and the viewer unless too far
  /// off.
  Bounds fitBox() const;

  /// A curve to begin with, of this size, around `centre`; its numbers are short.
  SceneCurve newCurve(const Vec2& centre) const;

  /// How far to move a curve that is to be added so that it lies beside those there are, as the
  /// viewer sees them; zero where it lies clear of them already. Short numbers.
  Vec2 besideTheOthers(const Curve& curve) const;

  /// Takes the size of the scene now, if not held.
  void renew();

  /// Between the two nothing changes; release() catches up. Calls may nest.
  void hold() { ++holds_; }
  void release();

 signals:
  void changed();

 private:
  void follow(const Change& change);
  void set(const Vec2& centre, double radius);

  static constexpr double kScreen =
      1.2;  ///< the screen clears the curves by a fifth of their radius
  static constexpr double kRing = 1.52;  ///< leaves room for the letters beside the screen

  const Document& document_;
  Vec2 centre_ = Vec2::Zero();
  double radius_ = 1.0;
  int holds_ = 0;
};

}  // namespace flatland::ui
