// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <QTransform>

#include "flatland/scene/scene.h"

namespace flatland::ui {

/// Which part of the plane a canvas shows: a uniform scale and the world point in the middle.
/// World: scene lengths, y up. Widget: logical pixels from the top left corner, y down.
class Viewport : public QObject {
  Q_OBJECT

 public:
  explicit Viewport(QObject* parent = nullptr);

  double scale() const { return scale_; }  ///< pixels per scene length, > 0
  const Vec2& centre() const { return centre_; }
  QPointF toWidget(const Vec2& world) const;
  Vec2 toWorld(const QPointF& widget) const;
  QTransform worldToWidget() const;

  /// The size of the canvas in pixels, and how much of it fit() keeps free at every side. A view
  /// that was fitted and not moved since is fitted again.
  void setSize(const QSizeF& size, double margin = kMarginPx);

  /// Shows the box as large as it goes with the margin around it. A box without extent is shown at
  /// unit scale.
  void fit(const Bounds& box);

  /// Whether the whole box is in the window.
  bool holds(const Bounds& box) const;

  void panBy(const QPointF& pixels);
  void centreOn(const Vec2& world);

  /// Scales by `factor` (> 0) about a widget position, which stays where it is. The scale stays
  /// between 1 / kMaxZoomOut and kMaxZoomIn times the fitted one.
  void zoomAt(const QPointF& widget, double factor);
  void zoomAtCentre(double factor);

  static constexpr double kMarginPx = 34.0;  ///< room for letters beyond the ring
  static constexpr double kMaxZoomOut = 100.0;
  static constexpr double kMaxZoomIn = 1e7;  ///< beyond it, doubles leave too few digits to drag

 signals:
  void changed();

 private:
  void set(const Vec2& centre, double scale);

  QSizeF size_{640.0, 480.0};
  double margin_ = kMarginPx;
  Vec2 centre_ = Vec2::Zero();
  double scale_ = 100.0;
  Bounds fitBox_{Vec2::Zero(), Vec2::Zero()};
  double fitScale_ = 100.0;
  bool fitted_ = true;
};

}  // namespace flatland::ui
