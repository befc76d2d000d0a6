// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_area.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/view3d/gl_canvas.h"
#include "ui/view3d/soft_canvas.h"
#include "ui/view3d/surface_input.h"
#include "ui/view3d/surface_overlay.h"

namespace flatland::ui {

namespace {

constexpr int kProbeDelayMs = 25;  ///< a moving pointer is looked up at most so often

}  // namespace

SurfaceArea::SurfaceArea(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      pages_(new QStackedWidget(this)),
      empty_(new QLabel(this)),
      progress_(nullptr) {
  setObjectName("surface-area");
  progress_ = makeProgress();  // not before its own parts have their initial values
  empty_->setObjectName("surface.empty");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setMargin(24);
  pages_->addWidget(empty_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  layout->addWidget(progress_);
  layout->addWidget(pages_, 1);
  connect(&models_.source, &SurfaceSource::changed, this, &SurfaceArea::showState);
  connect(&models_.source, &SurfaceSource::busyChanged, this, &SurfaceArea::showState);
  connect(&models_.source, &SurfaceSource::progressed, this,
          [this](double share) { bar_->setValue(qRound(100.0 * share)); });
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showState();
    if (change.what == Change::What::Camera) probeTimer_.start();
  });
  connect(&models_.seen, &SeenSource::failed, this, &SurfaceArea::failed);
  probeTimer_.setSingleShot(true);
  probeTimer_.setInterval(kProbeDelayMs);
  connect(&probeTimer_, &QTimer::timeout, this, &SurfaceArea::probe);
  showState();
}

QWidget* SurfaceArea::makeProgress() {
  auto* row = new QWidget(this);
  row->setObjectName("surface.progress");
  doing_ = new QLabel(row);
  bar_ = new QProgressBar(row);
  bar_->setObjectName("surface.progress.bar");
  bar_->setAccessibleName(tr("Progress"));
  auto* cancel = new QToolButton(row);
  cancel->setObjectName("surface.cancel");
  cancel->setText(tr("Cancel"));
  cancel->setToolTip(tr("Give up reading; what was there before stays"));
  connect(cancel, &QToolButton::clicked, this, [this] { models_.source.cancel(); });
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(doing_);
  layout->addWidget(bar_, 1);
  layout->addWidget(cancel);
  return row;
}

void SurfaceArea::showEvent(QShowEvent* event) {
  // A first widget of OpenGL makes Qt create the window anew, which it must not while it is shown.
  if (!canvas_) QMetaObject::invokeMethod(this, &SurfaceArea::makeCanvas, Qt::QueuedConnection);
  models_.source.setActive(true);
  QWidget::showEvent(event);
}

void SurfaceArea::makeCanvas() {
  if (canvas_) return;
  if (GlCanvas::possible()) {
    auto* gl = new GlCanvas(models_, pages_);
    connect(gl, &GlCanvas::failed, this, &SurfaceArea::failed);
    canvas_ = gl;
  } else {
    canvas_ = new SoftCanvas(models_, pages_);
  }
  canvas_->setObjectName("surface");
  canvas_->setAccessibleName(tr("Surface"));
  canvas_->setMinimumSize(minimumSizeHint());
  overlay_ = new SurfaceOverlay(models_, canvas_);
  if (auto* gl = qobject_cast<GlCanvas*>(canvas_)) {
    connect(gl, &GlCanvas::painted, overlay_, &SurfaceOverlay::setFrameMs);
  } else {
    connect(static_cast<SoftCanvas*>(canvas_), &SoftCanvas::painted, overlay_,
            &SurfaceOverlay::setFrameMs);
  }
  input_ = new SurfaceInput(*canvas_, models_);
  connect(input_, &SurfaceInput::hint, this, &SurfaceArea::hint);
  connect(input_, &SurfaceInput::spinningChanged, this, &SurfaceArea::spinningChanged);
  connect(input_, &SurfaceInput::pointedAt, this, [this](const std::optional<QPointF>& px) {
    pointer_ = px;
    if (!px) overlay_->setReading(std::nullopt);
    if (!probeTimer_.isActive()) probeTimer_.start();
  });
  canvas_->installEventFilter(this);
  pages_->addWidget(canvas_);
  showState();
}

bool SurfaceArea::eventFilter(QObject* watched, QEvent* event) {
  if (watched == canvas_ && event->type() == QEvent::Resize) overlay_->resize(canvas_->size());
  return QWidget::eventFilter(watched, event);
}

void SurfaceArea::setSpinning(bool spins) {
  if (input_) input_->setSpinning(spins);
}

void SurfaceArea::showState() {
  const bool there = canvas_ && models_.source.surface();
  pages_->setCurrentWidget(there ? canvas_ : empty_);
  progress_->setVisible(models_.source.isBusy());
  if (models_.source.isBusy()) {
    const bool reading = models_.source.isReading();
    doing_->setText(reading ? tr("Reading the mesh") : tr("Estimating curvature"));
    bar_->setRange(0, reading ? 0 : 100);  // how long reading takes is not known
    if (!reading) bar_->setValue(0);
  }
  const auto& setting = models_.document.scene().surface;
  empty_->setText(
      setting ? QString::fromStdString(surfaceName(setting->mesh))
              : tr("No surface yet. Open a mesh (PLY, OBJ, STL, OFF, glTF) by Surface > Open Mesh, "
                   "drop one here, or take one of Surface > Solids."));
}

void SurfaceArea::probe() {
  const auto& surface = models_.source.surface();
  const auto& setting = models_.document.scene().surface;
  if (!overlay_ || !pointer_ || !surface || !setting) {
    if (overlay_) overlay_->setReading(std::nullopt);
    return;
  }
  const Projection projection =
      orbitProjection(setting->camera, surface->ballRadius, canvas_->width(), canvas_->height());
  overlay_->setReading(readingAt(*surface, projection, {pointer_->x(), pointer_->y()}));
}

}  // namespace flatland::ui
