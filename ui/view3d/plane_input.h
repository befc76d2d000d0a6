// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QKeyEvent;
class QMouseEvent;

namespace flatland::ui {

/// The handles of the cutting plane under mouse and keys: the middle is pulled along the normal, a
/// place of the rim turns the plane. [ and ] move it; C gives the arrow keys to the plane, which
/// they turn then, and takes them away. A drag, and a key held down, is one step for undo; Esc
/// takes a drag back. Sees events before the camera does, so install it after SurfaceInput.
class PlaneInput : public QObject {
  Q_OBJECT

 public:
  PlaneInput(QWidget& canvas, const SurfaceModels& models);

 signals:
  void hint(const QString& text);
  /// Nothing is held any more, and another thing may be below the pointer, or have the keys.
  void handChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool key(const QKeyEvent& event);
  bool isKey(const QKeyEvent& event) const;
  void endDrag();
  void setPlane(const SurfacePlane& plane, int gesture);
  std::optional<int> handleAt(const QPointF& px) const;
  const SurfacePlane* plane() const;
  Projection projection() const;

  QWidget& canvas_;
  SurfaceModels models_;
  std::optional<SurfacePlane> before_;  ///< the drag
  int held_ = 0;                        ///< its handle; the grip's is shared with other views
  QPointF pressed_;
  int gesture_ = 0;
};

}  // namespace flatland::ui
