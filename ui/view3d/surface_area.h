// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "ui/view3d/surface_models.h"

class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace flatland::ui {

class SurfaceInput;
class SurfaceOverlay;

/// The view of the surface: its picture with words over it, how far reading has come, and what to
/// do where there is no surface. The picture is by OpenGL where that is possible, else painted.
/// Nothing is read or drawn before it is shown for the first time.
class SurfaceArea : public QWidget {
  Q_OBJECT

 public:
  explicit SurfaceArea(const SurfaceModels& models, QWidget* parent = nullptr);

  /// What shows the surface; null before the area was shown.
  QWidget* canvas() const { return canvas_; }
  SurfaceOverlay* overlay() const { return overlay_; }
  void setSpinning(bool spins);

  QSize sizeHint() const override { return {720, 560}; }
  QSize minimumSizeHint() const override { return {240, 200}; }

 signals:
  void hint(const QString& text);
  void failed(const QString& reason);
  void spinningChanged(bool spins);

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeProgress();
  void makeCanvas();
  void showState();
  void probe();

  SurfaceModels models_;
  QStackedWidget* pages_;
  QLabel* empty_;
  QWidget* progress_;
  QLabel* doing_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QWidget* canvas_ = nullptr;
  SurfaceInput* input_ = nullptr;
  SurfaceOverlay* overlay_ = nullptr;
  std::optional<QPointF> pointer_;
  QTimer probeTimer_;
};

}  // namespace flatland::ui
