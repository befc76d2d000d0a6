// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sweep_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOptionFocusRect>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/flat/wheel.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"
#include "ui/plot/sweep_overlay.h"
#include "ui/plot/sweep_snap.h"

namespace flatland::ui {

namespace {

constexpr double kReachPx = 7.0;
constexpr double kSmallestShare = 1e-4;  // of the diagram, to which it zooms
constexpr double kProbeStep = 0.005;     // of the parameter, for the keys
constexpr double kLegendFromPx = 300.0;  // below this height it would leave too little
constexpr double kWheelNotch = 120.0;

}  // namespace

SweepView::SweepView(const CanvasModels& models, const SweepSource& source, QWidget* parent)
    : QWidget(parent), models_(models), source_(source), turner_(models.document, models.stage) {
  setObjectName("sweep.view");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("View sweep"));
  setToolTip(
      tr("Click: go there. Drag: turn the view. Wheel: zoom. Middle button: move. "
         "Left, Right: turn by 1° (Shift 0.1°, Ctrl next event). Space: play."));
  connect(&source_, &SweepSource::changed, this, &SweepView::redraw);
  connect(&models_.display, &Display::changed, this, &SweepView::redraw);
  connect(&models_.probe, &Probe::changed, this, qOverload<>(&QWidget::update));
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.what == Change::What::Scene) window_.reset();
    update();
  });
}

double SweepView::scale() const { return models_.display.uiScale(); }

Vec2 SweepView::toFigure(const QPointF& widget) const {
  return Vec2(widget.x(), widget.y()) / scale();
}

SweepFigureOptions SweepView::options() const {
  SweepFigureOptions options;
  options.width = width() / scale();
  options.height = height() / scale();
  options.kinds = models_.display.families();
  // An apparent ridge ends where it meets a minimum: without it the rings would name nothing.
  if (models_.display.shows(MarkKind::ApparentRidge)) {
    options.kinds.set(static_cast<std::size_t>(MarkKind::ApparentMinimum));
  }
  options.palette = themePalette();
  options.words = wordsOfTheWindow();
  options.legend = options.height >= kLegendFromPx;
  options.window = window_;
  if (source_.data() && source_.data()->visibility && source_.data()->visibility->marked) {
    options.visibility = &*source_.data()->visibility;
  }
  return options;
}

std::optional<SweepAxes> SweepView::axes() const {
  if (!source_.data() || source_.data()->lengths.empty()) return std::nullopt;
  return sweepAxes(source_.data()->sweep, source_.data()->lengths, options());
}

std::optional<QPointF> SweepView::positionOf(double angleDeg, int curve, double u) const {
  const auto a = axes();
  if (!a || curve >= a->curveCount()) return std::nullopt;
  return scale() * QPointF(a->x(angleDeg), a->y(curve, u));
}

Figure SweepView::figureForFile() const {
  SweepFigureOptions forFile = options();
  forFile.width = SweepFigureOptions{}.width;
  forFile.height = SweepFigureOptions{}.height;
  forFile.palette = Palette::Light;
  forFile.legend = true;
  forFile.window.reset();
  forFile.viewAngleDeg = models_.document.scene().view.angleDeg;
  return sweepFigure(source_.data()->sweep, source_.data()->lengths, forFile);
}

void SweepView::redraw() {
  picture_ = {};
  update();
}

void SweepView::resizeEvent(QResizeEvent*) { redraw(); }

void SweepView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) redraw();
  QWidget::changeEvent(event);
}

void SweepView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const SceneColours& colours = sceneColours(themePalette());
  const auto a = axes();
  if (!a) {
    painter.fillRect(rect(), toQColor(colours.background));
    painter.setPen(toQColor(colours.text));
    painter.drawText(rect(), Qt::AlignCenter,
                     models_.document.scene().curves.empty() ? tr("No curve") : tr("Computing…"));
    return;
  }
  if (picture_.isNull()) {
    picture_ = QPixmap(size() * devicePixelRatioF());
    picture_.setDevicePixelRatio(devicePixelRatioF());
    picture_.fill(toQColor(colours.background));
    QPainter once(&picture_);
    once.scale(scale(), scale());
    paintFigure(once, sweepFigure(source_.data()->sweep, source_.data()->lengths, options()));
  }
  painter.drawPixmap(0, 0, picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.save();
  painter.scale(scale(), scale());
  paintSweepOverlay(painter, models_, *source_.data(), *a,
                    {.width = width() / scale(),
                     .fold = hovering_ ? eventAt(hover_) : nullptr,
                     .pointer = toFigure(hover_)});
  painter.restore();
  if (hasFocus()) {
    QStyleOptionFocusRect focus;
    focus.initFrom(this);
    focus.rect = rect().adjusted(1, 1, -1, -1);
    style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
  }
}

const SweepEvent* SweepView::eventAt(const QPointF& widget) const {
  const auto a = axes();
  return a && models_.display.shows(MarkKind::ApparentRidge)
             ? foldNear(*source_.data(), *a, toFigure(widget), kReachPx)
             : nullptr;
}

QString SweepView::describe(const QPointF& widget) const {
  const auto a = axes();
  if (!a) return {};
  if (const SweepEvent* fold = eventAt(widget)) {
    return tr("An apparent ridge is born or merges with a minimum at %1°, arc length %2")
        .arg(fold->angleDeg, 0, 'f', 4)
        .arg(fold->u, 0, 'g', 6);
  }
  const auto place = a->placeAt(toFigure(widget));
  if (!place) return {};
  return tr("%1°, arc length %2").arg(place->angleDeg, 0, 'f', 1).arg(place->u, 0, 'g', 4);
}

void SweepView::goTo(const QPointF& widget) {
  const auto a = axes();
  if (!a) return;
  const auto place = snappedPlace(*source_.data(), *a, toFigure(widget), kReachPx);
  if (!place) return;
  turner_.turnTo(place->angleDeg, models_.probe,
                 Probe::Place{static_cast<std::size_t>(place->curve),
                              source_.data()->parameterAt(place->curve, place->u)});
}

void SweepView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    panning_ = event->position();
  } else if (event->button() == Qt::LeftButton) {
    turner_.begin();
    before_ = models_.probe.place();
    goTo(event->position());
  }
}

void SweepView::mouseMoveEvent(QMouseEvent* event) {
  hover_ = event->position();
  hovering_ = true;
  if (panning_) {
    moveBy(hover_ - *panning_);
    panning_ = hover_;
  } else if (turner_.isActive() && event->buttons().testFlag(Qt::LeftButton)) {
    const auto a = axes();
    const auto place = a ? snappedPlace(*source_.data(), *a, toFigure(hover_), 0.0) : std::nullopt;
    if (place) turner_.turnTo(place->angleDeg);
  }
  emit hovered(describe(hover_));
  update();
}

void SweepView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) panning_.reset();
  if (event->button() == Qt::LeftButton) {
    turner_.end();
    before_.reset();
  }
}

void SweepView::leaveEvent(QEvent*) {
  hovering_ = false;
  emit hovered({});
  update();
}

void SweepView::wheelEvent(QWheelEvent* event) {
  const double notches = (event->angleDelta().y() + event->angleDelta().x()) / kWheelNotch;
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  const bool ctrl = event->modifiers().testFlag(Qt::ControlModifier);
  if (!shift && !wheelZoomsHere(*event, models_.display)) {
    const QPoint pixels = event->pixelDelta();
    moveBy(pixels.isNull() ? QPointF(event->angleDelta()) / 8.0 : QPointF(pixels));
  } else {
    zoom(event->position(), std::pow(1.2, notches), !shift, !ctrl);
  }
  event->accept();
}

void SweepView::moveBy(const QPointF& pixels) {
  const auto a = axes();
  if (!a) return;
  const Vec2 by = toFigure(pixels);
  SweepWindow window = a->window();
  const double degrees =
      -by.x() / (a->box().right - a->box().left) * (window.angleHigh - window.angleLow);
  const double lengths = by.y() / (a->box().bottom - a->box().top) * (window.uHigh - window.uLow);
  setWindow({window.angleLow + degrees, window.angleHigh + degrees, window.uLow + lengths,
             window.uHigh + lengths});
}

void SweepView::zoom(const QPointF& widget, double factor, bool angles, bool lengths) {
  const auto a = axes();
  if (!a) return;
  const Vec2 px = toFigure(widget);
  const double angle = a->angleAt(px.x()), u = a->stackedUAt(px.y());
  SweepWindow w = a->window();
  if (angles) {
    w.angleLow = angle + (w.angleLow - angle) / factor;
    w.angleHigh = angle + (w.angleHigh - angle) / factor;
  }
  if (lengths) {
    w.uLow = u + (w.uLow - u) / factor;
    w.uHigh = u + (w.uHigh - u) / factor;
  }
  setWindow(w);
}

// Keeps the window inside the diagram and not smaller than can be told apart.
void SweepView::setWindow(SweepWindow window) {
  const auto a = axes();
  if (!a) return;
  const auto fitted = [](double& low, double& high, double least, double most) {
    const double range = std::clamp(high - low, kSmallestShare * (most - least), most - least);
    const double middle = 0.5 * (low + high);
    low = std::clamp(middle - 0.5 * range, least, most - range);
    high = low + range;
  };
  fitted(window.angleLow, window.angleHigh, -180.0, 180.0);
  fitted(window.uLow, window.uHigh, 0.0, a->total());
  window_ = window;
  redraw();
}

void SweepView::showAll() {
  window_.reset();
  redraw();
}

void SweepView::goToEvent(int step) {
  if (!source_.data()) return;
  const double now = models_.document.scene().view.angleDeg;
  if (const auto angle = nextEventDeg(source_.data()->sweep, now, step)) turner_.turnTo(*angle);
}

bool SweepView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    for (const int own : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Space,
                          Qt::Key_Escape, Qt::Key_F, Qt::Key_Plus, Qt::Key_Minus}) {
      if (key == own) event->accept();
    }
  }
  return QWidget::event(event);
}

void SweepView::keyPressEvent(QKeyEvent* event) {
  const auto modifiers = event->modifiers();
  const QPointF middle = rect().toRectF().center();
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right: {
      const int step = event->key() == Qt::Key_Right ? 1 : -1;
      turner_.begin();  // until the key is released
      if (modifiers.testFlag(Qt::ControlModifier)) {
        goToEvent(step);
      } else {
        turner_.turnByStep(step * (modifiers.testFlag(Qt::ShiftModifier) ? 0.1 : 1.0));
      }
      return;
    }
    case Qt::Key_Up:
      return models_.probe.moveBy(kProbeStep);
    case Qt::Key_Down:
      return models_.probe.moveBy(-kProbeStep);
    case Qt::Key_F:
      return showAll();
    case Qt::Key_Plus:
      return zoom(middle, 1.25, true, true);
    case Qt::Key_Minus:
      return zoom(middle, 0.8, true, true);
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) emit playToggled();
      return;
    case Qt::Key_Escape:
      if (turner_.isActive()) {
        turner_.cancel();
        if (before_) models_.probe.setPlace(before_);
      } else {
        emit escaped();
      }
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void SweepView::keyReleaseEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) turner_.end();
  QWidget::keyReleaseEvent(event);
}

void SweepView::focusOutEvent(QFocusEvent* event) {
  turner_.end();  // the release of the key goes elsewhere
  QWidget::focusOutEvent(event);
}

}  // namespace flatland::ui
