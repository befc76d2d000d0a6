// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/gl_canvas.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "ui/view3d/gl_painter.h"

namespace flatland::ui {

namespace {

constexpr int kSamples = 4;  ///< a pixel: smooth edges

QSurfaceFormat wantedFormat() {
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(kSamples);
  return format;
}

bool tryOpenGl() {
  const QString platform = QGuiApplication::platformName();
  if (platform == "offscreen" || platform == "minimal") return false;
  QOpenGLContext context;
  context.setFormat(wantedFormat());
  if (!context.create()) return false;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return false;
  const bool good = context.format().version() >= qMakePair(3, 3) && !context.isOpenGLES();
  context.doneCurrent();
  return good;
}

}  // namespace

bool GlCanvas::possible() {
  static const bool kPossible = tryOpenGl();
  return kPossible;
}

GlCanvas::GlCanvas(const SurfaceModels& models, QWidget* parent)
    : QOpenGLWidget(parent), models_(models) {
  setFormat(wantedFormat());
  const auto repaint = qOverload<>(&QWidget::update);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface() || change.what == Change::What::Camera) update();
  });
  connect(&models_.source, &SurfaceSource::changed, this, repaint);
  connect(&models_.seen, &SeenSource::changed, this, repaint);
  connect(&models_.bridges.source, &BridgeSource::changed, this, repaint);
  connect(&models_.bridges.section, &SectionSource::changed, this, repaint);
  connect(&models_.display, &Display::changed, this, repaint);
}

GlCanvas::~GlCanvas() { release(); }

void GlCanvas::release() {
  if (!painter_) return;
  makeCurrent();
  painter_.reset();
  doneCurrent();
}

void GlCanvas::initializeGL() {
  // The context goes when the widget gets another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::release,
          Qt::UniqueConnection);
  painter_ = std::make_unique<GlPainter>();
  if (!painter_->fault().isEmpty()) emit failed(tr("OpenGL: %1").arg(painter_->fault()));
}

void GlCanvas::paintGL() {
  QElapsedTimer timer;
  timer.start();
  const double ratio = devicePixelRatioF();
  painter_->paint(pictureOf(models_), size() * ratio, ratio);
  // The time is that of the picture, not of handing over the commands.
  context()->functions()->glFinish();
  emit painted(static_cast<double>(timer.nsecsElapsed()) / 1e6);
}

}  // namespace flatland::ui
