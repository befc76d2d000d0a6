// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/canvas.h"

#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <cmath>
#include <limits>

#include "ui/commands/curve_commands.h"
#include "ui/flat/canvas_painter.h"
#include "ui/flat/scene_summary.h"
#include "ui/flat/wheel.h"
#include "ui/model/core_words.h"

namespace flatland::ui {

namespace {

constexpr double kZoomPerNotch = 1.2;
constexpr double kDegreesPerNotch = 120.0;  ///< QWheelEvent::angleDelta of one notch
constexpr double kNudgePx = 2.0;            ///< one arrow key; Shift ten times, Ctrl or Alt a tenth

Pointer pointerOf(const QMouseEvent& event) { return {event.position(), event.modifiers()}; }

}  // namespace

FlatCanvas::FlatCanvas(const CanvasModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("canvas");
  setAccessibleName(tr("Canvas"));
  setAccessibleDescription(sceneSummary(models_.document));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setProperty("drawsFocus", true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  const auto repaint = qOverload<>(&QWidget::update);
  connect(&models_.document, &Document::changed, this, &FlatCanvas::documentChanged);
  connect(&models_.selection, &Selection::changed, this, repaint);
  connect(&models_.viewport, &Viewport::changed, this, repaint);
  connect(&models_.display, &Display::changed, this, repaint);
  connect(&models_.display, &Display::changed, this, &FlatCanvas::resizeDrawing);
  connect(&models_.stage, &Stage::changed, this, repaint);
  connect(&models_.probe, &Probe::changed, this, repaint);
  fit();
}

FlatCanvas::~FlatCanvas() = default;

void FlatCanvas::fit() {
  models_.stage.renew();
  models_.viewport.fit(models_.stage.fitBox());
}

void FlatCanvas::placeProbe() {
  const auto& curves = models_.document.scene().curves;
  std::optional<Probe::Place> place = models_.probe.home();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; pointer_ && c < curves.size(); ++c) {
    const Nearest here = nearestPoint(curves[c].shape, models_.viewport.toWorld(*pointer_));
    if (here.distance >= nearest) continue;
    nearest = here.distance;
    place = Probe::Place{c, here.t};
  }
  models_.probe.setPlace(place);
}

void FlatCanvas::documentChanged(const Change& change) {
  if (!change.touchesScene()) return;
  if (gesture_ && !gesture_->survives(change)) gesture_.reset();
  hovered_ = {};  // what was there may have moved away
  // A surface beside it has hints of its own.
  if (!gesture_ && (hasFocus() || underMouse())) showHint();
  if (change.what == Change::What::Scene) fit();
  setAccessibleDescription(sceneSummary(models_.document));
  update();
}

bool FlatCanvas::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    pinch(static_cast<const QNativeGestureEvent&>(*event));
    return true;
  }
  return QWidget::event(event);
}

void FlatCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(font());
  paintCanvas(painter, models_, size(),
              {.hovered = gesture_ ? Target{} : hovered_, .focused = showsFocus_ && hasFocus()});
  if (gesture_) gesture_->paint(painter);
}

void FlatCanvas::resizeEvent(QResizeEvent*) { resizeDrawing(); }

void FlatCanvas::resizeDrawing() {
  const double margin = Viewport::kMarginPx * drawnScale(models_.display, size());
  models_.viewport.setSize(size(), margin);
}

void FlatCanvas::begin(std::unique_ptr<Gesture> gesture) {
  gesture_ = std::move(gesture);
  showHint();
  update();
}

void FlatCanvas::cancelGesture() {
  const std::unique_ptr<Gesture> gesture = std::move(gesture_);
  gesture->cancel();
  showHint();
  update();
}

void FlatCanvas::mousePressEvent(QMouseEvent* event) {
  if (gesture_) return;  // a second button changes nothing
  const bool pan =
      event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && panKey_);
  if (pan) {
    setCursor(Qt::ClosedHandCursor);
    begin(beginPan(models_, pointerOf(*event)));
  } else if (event->button() == Qt::LeftButton) {
    begin(beginGesture(models_, targetAt(models_, size(), event->position()), pointerOf(*event),
                       size()));
  }
}

void FlatCanvas::mouseMoveEvent(QMouseEvent* event) {
  // The button went up where no one told the canvas, over another window for example.
  if (gesture_ && event->buttons() == Qt::NoButton) cancelGesture();
  if (gesture_) {
    gesture_->move(pointerOf(*event));
    showHint();
    update();
  } else {
    hover(event->position());
  }
  pointer_ = event->position();
  emit pointerAt(models_.viewport.toWorld(event->position()));
}

void FlatCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (!gesture_ || event->buttons() != Qt::NoButton) return;
  // Taken out first: what finish() changes must find no gesture under way.
  const std::unique_ptr<Gesture> gesture = std::move(gesture_);
  gesture->finish(pointerOf(*event));
  hover(event->position());
  update();
}

void FlatCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  const Target target = targetAt(models_, size(), event->position());
  if (event->button() == Qt::LeftButton && target.what == Target::What::Curve) {
    insertPointAt(target.point.curve, target.t);
    hover(event->position());
  } else if (event->button() == Qt::LeftButton && target.what == Target::What::Probe) {
    // The first click of the two may have put it here. On a mark, the very place of the mark.
    const auto& marks = models_.document.features().marks;
    const Probe::Place place = *models_.probe.place();
    const bool onMark =
        target.below && static_cast<std::size_t>(marks[*target.below].curve) == place.curve;
    insertPointAt(place.curve, onMark ? marks[*target.below].t : place.t);
    hover(event->position());
  } else if (const auto mark = markOnCurve(target, event->position());
             mark && event->button() == Qt::LeftButton) {
    // The very place of the mark, to its last bits.
    insertPointAt(static_cast<std::size_t>(mark->curve), mark->t);
    hover(event->position());
  } else {
    mousePressEvent(event);  // two quick clicks on a point or on nothing are two clicks
  }
}

std::optional<Mark> FlatCanvas::markOnCurve(const Target& target, const QPointF& at) const {
  if (target.what != Target::What::Mark) return std::nullopt;
  // Its image on the screen is another matter.
  const double reach = 12.0 * drawnScale(models_.display, size());
  const Mark& mark = models_.document.features().marks[target.mark];
  const QPointF away = models_.viewport.toWidget(mark.point) - at;
  if (std::hypot(away.x(), away.y()) > reach) return std::nullopt;
  return mark;
}

void FlatCanvas::insertPointAt(std::size_t curve, double t) {
  const Curve before = models_.document.scene().curves[curve].shape;
  const EditResult edited = withPointAt(before, t);
  if (!edited.curve) {
    emit hint(coreWords(edited.reason));
    return;
  }
  if (*edited.curve == before) return;  // there is a point already
  models_.document.push(std::make_unique<InsertPoint>(models_.document, curve, t));
  models_.selection.setPoints({{curve, pointAddedAt(*edited.curve, before, t)}});
}

void FlatCanvas::wheelEvent(QWheelEvent* event) {
  if (!wheelZoomsHere(*event, models_.display)) {
    const QPoint pixels = event->pixelDelta();
    models_.viewport.panBy(pixels.isNull() ? QPointF(event->angleDelta()) / 8.0 : QPointF(pixels));
  } else {
    const double notches = event->angleDelta().y() / kDegreesPerNotch;
    models_.viewport.zoomAt(event->position(), std::pow(kZoomPerNotch, notches));
  }
  event->accept();
}

void FlatCanvas::pinch(const QNativeGestureEvent& event) {
  if (event.gestureType() != Qt::ZoomNativeGesture) return;
  models_.viewport.zoomAt(event.position(), std::max(1.0 + event.value(), 0.1));
}

void FlatCanvas::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      if (gesture_) {
        cancelGesture();
      } else if (!models_.selection.points().empty() || models_.selection.mark()) {
        models_.selection.clear();
      } else if (models_.probe.place() && !models_.display.isProjector()) {
        models_.probe.setPlace(std::nullopt);
      } else {
        event->ignore();  // nothing here to take back: the window may have something
      }
      return;
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) {
        panKey_ = true;
        if (!gesture_) setCursor(Qt::OpenHandCursor);
      }
      return;
    case Qt::Key_Left:
      return nudge({-1.0, 0.0}, *event);
    case Qt::Key_Right:
      return nudge({1.0, 0.0}, *event);
    case Qt::Key_Up:
      return nudge({0.0, 1.0}, *event);
    case Qt::Key_Down:
      return nudge({0.0, -1.0}, *event);
    default:
      QWidget::keyPressEvent(event);
  }
}

void FlatCanvas::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return QWidget::keyReleaseEvent(event);
  if (event->isAutoRepeat()) return;
  panKey_ = false;
  if (!gesture_) unsetCursor();
}

void FlatCanvas::nudge(const Vec2& direction, const QKeyEvent& event) {
  if (gesture_ || models_.selection.points().empty()) return;
  double pixels = kNudgePx;
  if (event.modifiers().testFlag(Qt::ShiftModifier)) pixels *= 10.0;
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) pixels /= 10.0;
  if (!event.isAutoRepeat()) nudge_ = models_.document.newGesture();  // a held key is one step
  models_.document.push(std::make_unique<MovePoints>(
      models_.document, models_.document.scene(), models_.selection.points(),
      direction * (pixels / models_.viewport.scale()), JointMode::Keep, nudge_));
}

void FlatCanvas::focusInEvent(QFocusEvent* event) {
  showsFocus_ = event->reason() == Qt::TabFocusReason ||
                event->reason() == Qt::BacktabFocusReason ||
                event->reason() == Qt::ShortcutFocusReason;
  update();
}

void FlatCanvas::focusOutEvent(QFocusEvent*) {
  if (gesture_) cancelGesture();
  panKey_ = false;
  unsetCursor();
  update();
}

bool FlatCanvas::focusNextPrevChild(bool next) {
  models_.selection.step(next ? 1 : -1);
  return true;  // the Tab key stays here; F6 leads to the panels
}

void FlatCanvas::leaveEvent(QEvent*) {
  pointer_.reset();
  if (gesture_) return;
  hover(QPointF(-1e6, -1e6));
  emit pointerAt(std::nullopt);
}

void FlatCanvas::hover(const QPointF& position) {
  const Target target = targetAt(models_, size(), position);
  if (panKey_) {
    setCursor(Qt::OpenHandCursor);
  } else if (target.what == Target::What::Nothing) {
    unsetCursor();
  } else {
    const bool pick = target.what == Target::What::Mark;
    setCursor(pick ? Qt::PointingHandCursor : Qt::SizeAllCursor);
  }
  const bool same = target == hovered_;
  hovered_ = target;
  showHint();
  if (!same) update();
}

void FlatCanvas::showHint() {
  emit hint(gesture_ ? gesture_->status() : describe(models_, hovered_));
}

}  // namespace flatland::ui
