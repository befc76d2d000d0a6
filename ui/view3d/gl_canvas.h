// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "ui/view3d/surface_models.h"

namespace flatland::ui {

class GlPainter;

/// The surface drawn by OpenGL. Only where possible() says so: Qt's offscreen platform ends the
/// process when such a widget is shown.
class GlCanvas : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit GlCanvas(const SurfaceModels& models, QWidget* parent = nullptr);
  ~GlCanvas() override;

  /// True if this platform has OpenGL 3.3 core. Asked once.
  static bool possible();

 signals:
  void painted(double milliseconds);
  void failed(const QString& reason);

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void release();

  SurfaceModels models_;
  std::unique_ptr<GlPainter> painter_;
};

}  // namespace flatland::ui
