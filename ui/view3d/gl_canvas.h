// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <QTimer>
#include <memory>

#include "ui/view3d/surface_models.h"

class QOpenGLFramebufferObject;

namespace flatland::ui {

class GlPainter;
struct SurfacePicture;

/// The surface drawn by OpenGL. Only where possible() says so: Qt's offscreen platform ends the
/// process when such a widget is shown. Where the processor does the work of a card, edges are
/// smoothed when the camera rests, and not while it moves.
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
  void paintSmoothly(const SurfacePicture& picture, const QSize& pixels, double ratio);

  SurfaceModels models_;
  std::unique_ptr<GlPainter> painter_;
  std::unique_ptr<QOpenGLFramebufferObject> fine_;  ///< kFiner times as large as the canvas
  QTimer rest_;                                     ///< runs while the camera moves
};

}  // namespace flatland::ui
