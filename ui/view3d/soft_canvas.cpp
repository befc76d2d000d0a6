// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/soft_canvas.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QPainter>
#include <utility>

#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

SoftCanvas::SoftCanvas(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models), job_([this] { paint(); }) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface() || change.what == Change::What::Camera) renew();
  });
  connect(&models_.source, &SurfaceSource::changed, this, &SoftCanvas::renew);
  connect(&models_.seen, &SeenSource::changed, this, &SoftCanvas::renew);
  connect(&models_.bridges.source, &BridgeSource::changed, this, &SoftCanvas::renew);
  connect(&models_.bridges.section, &SectionSource::changed, this, &SoftCanvas::renew);
  connect(&models_.display, &Display::changed, this, &SoftCanvas::renew);
}

void SoftCanvas::renew() { job_.wish(); }

void SoftCanvas::paint() {
  if (size().isEmpty()) return;
  using Painted = std::pair<QImage, double>;
  const QSize pixels = size() * devicePixelRatioF();
  job_.start<Painted>(
      [picture = pictureOf(models_), pixels](const JobControl&) -> std::optional<Painted> {
        QElapsedTimer timer;
        timer.start();
        QImage image = paintSurface(picture, pixels);
        return Painted{std::move(image), static_cast<double>(timer.nsecsElapsed()) / 1e6};
      },
      [this](const Painted& done) {
        image_ = done.first;
        update();
        emit painted(done.second);
      });
}

void SoftCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (!image_.isNull()) painter.drawImage(QRectF(rect()), image_);
}

void SoftCanvas::resizeEvent(QResizeEvent*) { renew(); }

void SoftCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) renew();
  QWidget::changeEvent(event);
}

}  // namespace flatland::ui
