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
#include "ui/model/theme.h"
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
  paintOverlay(painter, *a);
  painter.restore();
  if (hasFocus()) {
    QStyleOptionFocusRect focus;
    focus.initFrom(this);
    focus.rect = rect().adjusted(1, 1, -1, -1);
    style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
  }
}

// The view and the probe as lines, and the ring under the pointer.
void SweepView::paintOverlay(QPainter& painter, const SweepAxes& axes) {
  const SceneColours& colours = sceneColours(themePalette());
  const SweepAxes::Box& box = axes.box();
  painter.save();
  painter.setClipRect(
      QRectF(QPointF(box.left - 1, box.top - 1), QPointF(box.right + 1, box.bottom + 1)));
  const double x = axes.x(normalizedDeg(models_.document.scene().view.angleDeg));
  painter.setPen(QPen(toQColor(colours.screen), 2.0, Qt::DashLine));
  painter.drawLine(QPointF(x, box.top), QPointF(x, box.bottom));
  const auto& place = models_.probe.place();
  const SweepData& shown = *source_.data();
  // A probe on the new curve has no place on the axis of an earlier one.
  if (place && place->curve < shown.scene.curves.size() &&
      shown.scene.curves[place->curve] == models_.document.scene().curves[place->curve]) {
    const int curve = static_cast<int>(place->curve);
    const double y = axes.y(curve, shown.lengthAt(curve, place->t));
    painter.setPen(QPen(toQColor(colours.text), 1.2, Qt::DotLine));
    painter.drawLine(QPointF(box.left, y), QPointF(box.right, y));
    painter.setBrush(toQColor(colours.background));
    painter.setPen(QPen(toQColor(colours.text), 1.6));
    painter.drawEllipse(QPointF(x, y), 3.5, 3.5);
  }
  painter.restore();
  const SweepEvent* fold = hovering_ ? eventAt(hover_) : nullptr;
  const QString angle = tr("%1°").arg(models_.document.scene().view.angleDeg, 0, 'f', 2);
  const auto label = [&](const QPointF& at, const QString& text) {
    QFont font = painter.font();
    font.setPixelSize(12);
    painter.setFont(font);
    QRectF around = QFontMetricsF(font).boundingRect(text).adjusted(-4, -2, 4, 2);
    around.moveCenter(at);
    const double left = std::max(2.0, std::min(around.left(), width() / scale() - around.width()));
    around.moveLeft(left);
    painter.setPen(QPen(toQColor(colours.text), 1.0));
    painter.setBrush(toQColor(colours.background));
    painter.drawRoundedRect(around, 3, 3);
    painter.drawText(around, Qt::AlignCenter, text);
  };
  if (x >= box.left - 1 && x <= box.right + 1) label({x, box.top - 11.0}, angle);
  if (fold) {
    const Vec2 at = toFigure(hover_);
    label({at.x(), at.y() - 18.0}, tr("born or merged at %1°").arg(fold->angleDeg, 0, 'f', 3));
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
  turner_.turnTo(place->angleDeg);
  models_.probe.setPlace(Probe::Place{static_cast<std::size_t>(place->curve),
                                      source_.data()->parameterAt(place->curve, place->u)});
}

void SweepView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    panning_ = event->position();
  } else if (event->button() == Qt::LeftButton) {
    turner_.begin();
    goTo(event->position());
  }
}

void SweepView::mouseMoveEvent(QMouseEvent* event) {
  hover_ = event->position();
  hovering_ = true;
  if (panning_) {
    if (const auto a = axes()) {
      const Vec2 from = toFigure(*panning_), to = toFigure(hover_);
      SweepWindow window = a->window();
      const double degrees = (from.x() - to.x()) / (a->box().right - a->box().left) *
                             (window.angleHigh - window.angleLow);
      const double lengths =
          (to.y() - from.y()) / (a->box().bottom - a->box().top) * (window.uHigh - window.uLow);
      setWindow({window.angleLow + degrees, window.angleHigh + degrees, window.uLow + lengths,
                 window.uHigh + lengths});
      panning_ = hover_;
    }
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
  if (event->button() == Qt::LeftButton) turner_.end();
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
  zoom(event->position(), std::pow(1.2, notches), !shift, !ctrl);
  event->accept();
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
