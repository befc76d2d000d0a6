// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/gl_canvas.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>

#include "ui/view3d/gl_painter.h"

namespace flatland::ui {

namespace {

constexpr int kSamples = 4;  ///< a pixel: smooth edges
// Samples make a picture of 250 000 triangles by the processor three times as slow; one that is
// drawn larger and made small is only needed when nothing moves.
constexpr int kFiner = 2;
constexpr int kRestMs = 250;

bool isSoftware(QOpenGLContext& context) {
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const QString renderer = QString::fromLatin1(name).toLower();
  for (const char* known : {"llvmpipe", "softpipe", "swiftshader", "software"}) {
    if (renderer.contains(QLatin1String(known))) return true;
  }
  return false;
}

struct OpenGl {
  bool possible = false;
  bool software = false;  ///< the processor does the work
};
const OpenGl& openGl();

QSurfaceFormat wantedFormat() {
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(kSamples);
  return format;
}

OpenGl tryOpenGl() {
  const QString platform = QGuiApplication::platformName();
  if (platform == "offscreen" || platform == "minimal") return {};
  QOpenGLContext context;
  context.setFormat(wantedFormat());
  if (!context.create()) return {};
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return {};
  OpenGl found;
  found.possible = context.format().version() >= qMakePair(3, 3) && !context.isOpenGLES();
  found.software = isSoftware(context);
  context.doneCurrent();
  return found;
}

const OpenGl& openGl() {
  static const OpenGl kFound = tryOpenGl();
  return kFound;
}

}  // namespace

bool GlCanvas::possible() { return openGl().possible; }

GlCanvas::GlCanvas(const SurfaceModels& models, QWidget* parent)
    : QOpenGLWidget(parent), models_(models) {
  QSurfaceFormat format = wantedFormat();
  if (openGl().software) format.setSamples(0);
  setFormat(format);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
  const auto repaint = qOverload<>(&QWidget::update);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.what == Change::What::Camera && openGl().software) rest_.start();
    if (change.touchesSurface() || change.what == Change::What::Camera) update();
  });
  // A swept curve or a plane that is dragged moves the picture as the camera does.
  const auto moved = [this] {
    if (openGl().software) rest_.start();
    update();
  };
  connect(&models_.source, &SurfaceSource::changed, this, moved);
  connect(&models_.seen, &SeenSource::changed, this, repaint);
  connect(&models_.bridges.source, &BridgeSource::changed, this, repaint);
  connect(&models_.bridges.section, &SectionSource::changed, this, moved);
  connect(&models_.display, &Display::changed, this, repaint);
}

GlCanvas::~GlCanvas() { release(); }

void GlCanvas::release() {
  if (!painter_) return;
  makeCurrent();
  fine_.reset();
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

void GlCanvas::paintSmoothly(const SurfacePicture& picture, const QSize& pixels, double ratio) {
  const QSize larger = kFiner * pixels;
  if (!fine_ || fine_->size() != larger) {
    fine_ = std::make_unique<QOpenGLFramebufferObject>(larger, QOpenGLFramebufferObject::Depth);
  }
  if (!fine_->bind()) return painter_->paint(picture, pixels, ratio);
  painter_->paint(picture, larger, kFiner * ratio);
  fine_->release();
  // Half as large: each pixel becomes the mean of four.
  QOpenGLFramebufferObject::blitFramebuffer(nullptr, QRect({}, pixels), fine_.get(),
                                            QRect({}, larger), GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void GlCanvas::paintGL() {
  QElapsedTimer timer;
  timer.start();
  const double ratio = devicePixelRatioF();
  if (openGl().software && !rest_.isActive()) {
    paintSmoothly(pictureOf(models_), size() * ratio, ratio);
  } else {
    painter_->paint(pictureOf(models_), size() * ratio, ratio);
  }
  // The time is that of the picture, not of handing over the commands.
  context()->functions()->glFinish();
  emit painted(static_cast<double>(timer.nsecsElapsed()) / 1e6);
}

}  // namespace flatland::ui
