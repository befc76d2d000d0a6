// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <optional>

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace flatland::ui {

/// What mouse, trackpad and keys do to the camera, on whatever widget shows the surface. Every
/// motion moves the camera of the view (SurfaceModels::setCamera); Esc takes a drag back, stops
/// spinning, or, but on the projector, drops the pick. A click without a drag picks the place under
/// it, on the background none; P picks in the middle of the picture.
class SurfaceInput : public QObject {
  Q_OBJECT

 public:
  SurfaceInput(QWidget& canvas, const SurfaceModels& models);

  void setSpinning(bool spins);
  bool isSpinning() const { return spin_.isActive(); }
  /// Says what the hand can do where the pointer is.
  void hintAtHand();

 signals:
  /// The pointer is over this place of the canvas, or left.
  void pointedAt(const std::optional<QPointF>& px);
  void hint(const QString& text);
  void spinningChanged(bool spins);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { None, Orbit, Pan, Roll };
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  bool dropsPick() const;  ///< by Esc
  void release(const QMouseEvent& event);
  void endDrag();
  void pickAt(const QPointF& px);
  void setCamera(const SurfaceCamera& camera);
  const SurfaceCamera& camera() const { return models_.camera(); }
  Projection projection() const;

  QWidget& canvas_;
  SurfaceModels models_;
  Drag drag_ = Drag::None;
  QPointF last_, pressed_;
  bool mayBeClick_ = false;              ///< the pointer has not left where it was pressed
  std::optional<SurfaceCamera> before_;  ///< the drag
  QTimer spin_;
};

/// True for keys that mean something here and may be shortcuts elsewhere.
bool isSurfaceKey(const QKeyEvent& event);

}  // namespace flatland::ui
