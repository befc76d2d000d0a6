// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "ui/view3d/surface_models.h"

class QOpenGLFramebufferObject;

namespace flatland::ui {

class GlPainter;

/// The surface drawn by OpenGL into an image, which is shown as any picture is. A QOpenGLWidget
/// would make Qt create the window anew when the first surface comes, and compose every later
/// repaint of the window by OpenGL, which takes four times as long where the processor does the
/// work of a card. There, too, edges are smoothed when the camera rests, and not while it moves.
class GlCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit GlCanvas(const SurfaceModels& models, QWidget* parent = nullptr);
  ~GlCanvas() override;

  /// True if this platform has OpenGL 3.3 core, and no canvas has failed. Asked once.
  static bool possible();

 signals:
  void painted(double milliseconds);
  /// Once, the last that comes of it: another canvas has to take its place.
  void failed(const QString& reason);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  using Buffer = std::unique_ptr<QOpenGLFramebufferObject>;

  void renew();
  void begin();
  void draw(const QSize& pixels);
  void giveUp(const QString& reason);

  SurfaceModels models_;
  QOffscreenSurface surface_;
  QOpenGLContext context_;
  std::unique_ptr<GlPainter> painter_;
  Buffer fine_;   ///< several samples for each pixel of the canvas
  Buffer plain_;  ///< one for each
  QImage image_;
  bool stale_ = true;    ///< the image shows what was
  bool broken_ = false;  ///< has failed
  QTimer rest_;          ///< runs while the camera moves
};

}  // namespace flatland::ui
