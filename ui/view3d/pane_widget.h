// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "ui/view3d/surface_models.h"

class QToolButton;

namespace flatland::ui {

class SurfaceInput;
class SurfaceOverlay;

/// One view of the surface: its picture with words over it, by OpenGL where that is possible and as
/// long as it works, else painted. Beside others it has a row that says what it shows, with a menu
/// to change that, and a frame if it is the one that panels are about.
class PaneWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PaneWidget(const SurfaceModels& models, QWidget* parent = nullptr);

  QWidget* canvas() const { return canvas_; }
  SurfaceOverlay* overlay() const { return overlay_; }
  SurfaceInput* input() const { return input_; }

 signals:
  void hint(const QString& text);
  void failed(const QString& reason);
  void spinningChanged(bool spins);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeCanvas();
  void useCanvas(QWidget* canvas);
  void paintWithoutOpenGl();
  void showSetting();
  void showTitle();
  void probe();

  SurfaceModels models_;
  QToolButton* title_;
  QString words_;  ///< of the title, which has as much of them as there is room for
  QWidget* canvas_ = nullptr;
  SurfaceInput* input_ = nullptr;
  SurfaceOverlay* overlay_ = nullptr;
  std::optional<QPointF> pointer_;
  QTimer probeTimer_;
};

}  // namespace flatland::ui
