// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pane_widget.h"

#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/model/bridge_ticks.h"
#include "ui/view3d/gl_canvas.h"
#include "ui/view3d/pane_menu.h"
#include "ui/view3d/plane_input.h"
#include "ui/view3d/soft_canvas.h"
#include "ui/view3d/surface_input.h"
#include "ui/view3d/surface_overlay.h"

namespace flatland::ui {

namespace {

constexpr double kReachPx = 6.0;   ///< of a predicted line under the pointer
constexpr int kProbeDelayMs = 25;  ///< a moving pointer is looked up at most so often
constexpr int kTitleRestPx = 40;   ///< of the width of the title: the arrow of its menu
constexpr int kFramePx = 2;        ///< around the view that panels are about

}  // namespace

PaneWidget::PaneWidget(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models), title_(new QToolButton(this)) {
  const QString id = QStringLiteral("surface.pane.%1").arg(models_.pane);
  setObjectName(id);
  title_->setObjectName(id + ".menu");
  title_->setAutoRaise(true);
  title_->setPopupMode(QToolButton::InstantPopup);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* menu = new QMenu(title_);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    models_.views.setActive(models_.pane);
    fillPaneMenu(*menu, models_);
  });
  title_->setMenu(menu);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(0);
  layout->addWidget(title_);
  makeCanvas();
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showSetting();
    if (change.what == Change::What::Camera) probeTimer_.start();
  });
  connect(&models_.views, &SurfaceViews::activeChanged, this, qOverload<>(&QWidget::update));
  probeTimer_.setSingleShot(true);
  probeTimer_.setInterval(kProbeDelayMs);
  connect(&probeTimer_, &QTimer::timeout, this, &PaneWidget::probe);
  showSetting();
}

void PaneWidget::makeCanvas() {
  if (!GlCanvas::possible()) return useCanvas(new SoftCanvas(models_, this));
  auto* gl = new GlCanvas(models_, this);
  useCanvas(gl);
  connect(gl, &GlCanvas::failed, this, &PaneWidget::failed);
  // It tells that in the middle of an event of its own.
  connect(gl, &GlCanvas::failed, this, &PaneWidget::paintWithoutOpenGl, Qt::QueuedConnection);
  connect(gl, &GlCanvas::painted, overlay_, &SurfaceOverlay::setFrameMs);
}

void PaneWidget::paintWithoutOpenGl() {
  if (!qobject_cast<GlCanvas*>(canvas_)) return;
  QWidget* const before = canvas_;
  const bool hadFocus = before->hasFocus();
  input_->setSpinning(false);
  before->setObjectName({});
  before->hide();
  before->deleteLater();
  auto* soft = new SoftCanvas(models_, this);
  useCanvas(soft);
  soft->show();
  if (hadFocus) soft->setFocus();
}

void PaneWidget::useCanvas(QWidget* canvas) {
  canvas_ = canvas;
  const bool first = models_.pane == 0;
  canvas_->setObjectName(first ? QStringLiteral("surface.canvas")
                               : QStringLiteral("surface.canvas.%1").arg(models_.pane));
  canvas_->setAccessibleName(first ? tr("Picture of the surface")
                                   : tr("Picture of the surface, view %1").arg(models_.pane + 1));
  static_cast<QVBoxLayout*>(layout())->addWidget(canvas_, 1);
  overlay_ = new SurfaceOverlay(models_, canvas_);
  if (auto* soft = qobject_cast<SoftCanvas*>(canvas_)) {
    connect(soft, &SoftCanvas::painted, overlay_, &SurfaceOverlay::setFrameMs);
  }
  input_ = new SurfaceInput(*canvas_, models_);
  connect(input_, &SurfaceInput::hint, this, &PaneWidget::hint);
  auto* plane = new PlaneInput(*canvas_, models_);  // after the camera's, to be asked before it
  connect(plane, &PlaneInput::hint, this, &PaneWidget::hint);
  connect(plane, &PlaneInput::handChanged, input_, &SurfaceInput::hintAtHand);
  connect(input_, &SurfaceInput::spinningChanged, this, &PaneWidget::spinningChanged);
  connect(input_, &SurfaceInput::pointedAt, this, [this](const std::optional<QPointF>& px) {
    pointer_ = px;
    if (!px) overlay_->setReading(std::nullopt);
    if (!probeTimer_.isActive()) probeTimer_.start();
  });
  canvas_->installEventFilter(this);
}

bool PaneWidget::eventFilter(QObject* watched, QEvent* event) {
  if (watched == canvas_ && event->type() == QEvent::Resize) {
    overlay_->resize(canvas_->size());
    models_.seen.setAspect(static_cast<double>(qMax(canvas_->width(), 1)) /
                           qMax(canvas_->height(), 1));
  }
  if (watched == canvas_ && event->type() == QEvent::FocusIn) {
    models_.views.setActive(models_.pane);
  }
  return QWidget::eventFilter(watched, event);
}

void PaneWidget::showSetting() {
  const bool several = models_.views.count() > 1;
  title_->setVisible(several);
  if (several && models_.there()) {
    words_ = paneWords(models_);
    title_->setAccessibleName(tr("View %1: %2").arg(models_.pane + 1).arg(words_));
    title_->setToolTip(tr("%1. A click changes what this view shows").arg(words_));
  }
  showTitle();
  const int frame = several ? kFramePx : 0;
  layout()->setContentsMargins(frame, frame, frame, frame);
  update();
}

void PaneWidget::showTitle() {
  title_->setText(fontMetrics().elidedText(words_, Qt::ElideRight, width() - kTitleRestPx));
}

void PaneWidget::resizeEvent(QResizeEvent* event) {
  showTitle();
  QWidget::resizeEvent(event);
}

void PaneWidget::paintEvent(QPaintEvent*) {
  if (models_.views.count() < 2 || models_.views.active() != models_.pane) return;
  QPainter painter(this);
  painter.fillRect(rect(), palette().highlight());
  const QRect inner = rect().adjusted(kFramePx, kFramePx, -kFramePx, -kFramePx);
  painter.fillRect(inner, palette().window());
}

void PaneWidget::probe() {
  const auto& surface = models_.source.surface();
  if (!pointer_ || !surface || !models_.there()) {
    overlay_->setPredicted(std::nullopt);
    return overlay_->setReading(std::nullopt);
  }
  const Projection projection =
      orbitProjection(models_.camera(), surface->ballRadius, canvas_->width(), canvas_->height());
  const Eigen::Vector2d px(pointer_->x(), pointer_->y());
  overlay_->setReading(readingAt(*surface, projection, px, models_.foundView()));
  const BridgeSource& bridge = models_.bridges.source;
  const bool predicts = bridge.isShown() && bridge.view() && !bridge.view()->limits.empty();
  overlay_->setPredicted(predicts ? predictedLineAt(*bridge.view(), projection, px, kReachPx)
                                  : std::nullopt);
}

}  // namespace flatland::ui
