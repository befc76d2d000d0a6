// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/gl_canvas.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QGuiApplication>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QPainter>

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
OpenGl& openGl();

QSurfaceFormat wantedFormat() {
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
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

OpenGl& openGl() {
  static OpenGl found = tryOpenGl();
  return found;
}

}  // namespace

bool GlCanvas::possible() { return openGl().possible; }

GlCanvas::GlCanvas(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &GlCanvas::renew);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.what == Change::What::Camera && openGl().software) rest_.start();
    if (change.touchesSurface() || change.what == Change::What::Camera) renew();
  });
  // A swept curve or a plane that is dragged moves the picture as the camera does.
  const auto moved = [this] {
    if (openGl().software) rest_.start();
    renew();
  };
  connect(&models_.source, &SurfaceSource::changed, this, moved);
  connect(&models_.seen, &SeenSource::changed, this, &GlCanvas::renew);
  connect(&models_.bridges.source, &BridgeSource::changed, this, &GlCanvas::renew);
  connect(&models_.bridges.section, &SectionSource::changed, this, moved);
  connect(&models_.display, &Display::changed, this, &GlCanvas::renew);
}

GlCanvas::~GlCanvas() {
  if (!painter_ || !context_.makeCurrent(&surface_)) return;
  fine_.reset();
  plain_.reset();
  painter_.reset();
  context_.doneCurrent();
}

void GlCanvas::renew() {
  stale_ = true;
  update();
}

void GlCanvas::begin() {
  context_.setFormat(wantedFormat());
  if (!context_.create()) return;
  surface_.setFormat(context_.format());
  surface_.create();
}

void GlCanvas::giveUp(const QString& reason) {
  broken_ = true;
  openGl().possible = false;
  emit failed(reason);
}

void GlCanvas::draw(const QSize& pixels) {
  stale_ = false;
  if (!context_.isValid()) begin();
  if (!context_.isValid() || !context_.makeCurrent(&surface_)) {
    return giveUp(tr("The surface cannot be drawn by OpenGL any more."));
  }
  if (!painter_) {
    painter_ = std::make_unique<GlPainter>();
    if (!painter_->fault().isEmpty()) {
      const QString fault = painter_->fault();
      painter_.reset();
      context_.doneCurrent();
      return giveUp(tr("OpenGL: %1").arg(fault));
    }
  }
  const double ratio = devicePixelRatioF();
  const bool software = openGl().software;
  if (!plain_ || plain_->size() != pixels) {
    plain_ = std::make_unique<QOpenGLFramebufferObject>(pixels, QOpenGLFramebufferObject::Depth);
    fine_.reset();
  }
  const int factor = software ? kFiner : 1;
  if (!fine_ && !(software && rest_.isActive())) {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setSamples(software ? 0 : kSamples);
    fine_ = std::make_unique<QOpenGLFramebufferObject>(factor * pixels, format);
  }
  const bool smooth = !(software && rest_.isActive()) && fine_->isValid();
  (smooth ? fine_ : plain_)->bind();
  const int scale = smooth ? factor : 1;
  painter_->paint(pictureOf(models_), scale * pixels, scale * ratio, rest_.isActive());
  // Where it is larger, each pixel becomes the mean of four.
  if (smooth) {
    QOpenGLFramebufferObject::blitFramebuffer(plain_.get(), QRect({}, pixels), fine_.get(),
                                              QRect({}, factor * pixels), GL_COLOR_BUFFER_BIT,
                                              factor > 1 ? GL_LINEAR : GL_NEAREST);
  }
  image_ = plain_->toImage();
  plain_->release();
  context_.doneCurrent();
  // Nothing of it is transparent; said so, it is copied to the window as it is.
  if (image_.format() == QImage::Format_ARGB32_Premultiplied) {
    image_.reinterpretAsFormat(QImage::Format_RGB32);
  }
}

void GlCanvas::paintEvent(QPaintEvent*) {
  const QSize pixels = size() * devicePixelRatioF();
  if (!broken_ && !pixels.isEmpty() && (stale_ || image_.size() != pixels)) {
    QElapsedTimer timer;
    timer.start();
    draw(pixels);
    if (!broken_) emit painted(static_cast<double>(timer.nsecsElapsed()) / 1e6);
  }
  QPainter painter(this);
  if (image_.isNull()) return painter.fillRect(rect(), palette().base());
  painter.drawImage(QRectF(rect()), image_);
}

void GlCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) renew();
  QWidget::changeEvent(event);
}

}  // namespace flatland::ui
