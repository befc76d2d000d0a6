// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <QWidget>
#include <cmath>
#include <numbers>

#include "ui/flat/wheel.h"
#include "ui/model/bridges.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_probe.h"

namespace flatland::ui {

namespace {

using Eigen::Vector2d;

constexpr double kClickReachPx = 4.0;  ///< a hand that does not drag moves less
constexpr double kZoomPerNotch = 1.2;
constexpr double kDegreesPerNotch = 120.0;  ///< QWheelEvent::angleDelta of one notch
constexpr int kSpinIntervalMs = 16;
constexpr double kSpinStepRad = std::numbers::pi / 360.0;  ///< a turn in about 12 s

Vector2d vectorOf(const QPointF& p) { return {p.x(), p.y()}; }

}  // namespace

SurfaceInput::SurfaceInput(QWidget& canvas, const SurfaceModels& models)
    : QObject(&canvas), canvas_(canvas), models_(models) {
  canvas.setFocusPolicy(Qt::StrongFocus);
  canvas.setMouseTracking(true);
  canvas.installEventFilter(this);
  spin_.setInterval(kSpinIntervalMs);
  connect(&spin_, &QTimer::timeout, this, [this] {
    if (models_.there() && drag_ == Drag::None) setCamera(spun(camera(), kSpinStepRad));
  });
}

void SurfaceInput::setSpinning(bool spins) {
  if (spins == spin_.isActive()) return;
  spins ? spin_.start() : spin_.stop();
  emit spinningChanged(spins);
}

Projection SurfaceInput::projection() const {
  const double radius = models_.source.surface() ? models_.source.surface()->ballRadius : 1.0;
  return orbitProjection(camera(), radius, canvas_.width(), canvas_.height());
}

void SurfaceInput::setCamera(const SurfaceCamera& camera) { models_.setCamera(camera); }

bool SurfaceInput::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Leave) emit pointedAt(std::nullopt);
  if (!models_.there()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      release(static_cast<const QMouseEvent&>(*event));
      return true;
    case QEvent::Wheel:
      return wheel(static_cast<const QWheelEvent&>(*event));
    case QEvent::NativeGesture: {
      const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
      if (gesture.gestureType() == Qt::ZoomNativeGesture) {
        setCamera(zoomedAt(camera(), projection(), vectorOf(gesture.position()),
                           std::max(1.0 + gesture.value(), 0.1)));
      } else if (gesture.gestureType() == Qt::RotateNativeGesture) {
        setCamera(rolled(camera(), -gesture.value() * std::numbers::pi / 180.0));
      }
      return true;
    }
    case QEvent::ShortcutOverride: {
      const auto& pressed = static_cast<const QKeyEvent&>(*event);
      const bool takesBack =
          pressed.key() == Qt::Key_Escape && (drag_ != Drag::None || isSpinning() || dropsPick());
      // Home goes to the first step where there is a lesson.
      const bool isOurs = isSurfaceKey(pressed) && pressed.key() != Qt::Key_Home;
      if (!isOurs && !takesBack) return false;
      event->accept();
      return true;
    }
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event));
    case QEvent::Enter:
    case QEvent::FocusIn:
      hintAtHand();  // what the canvas of curves said is of no use here
      return false;
    case QEvent::FocusOut:
      endDrag();
      return false;
    default:
      return false;
  }
}

bool SurfaceInput::press(const QMouseEvent& event) {
  if (drag_ != Drag::None) return true;  // a second button changes nothing
  canvas_.setFocus(Qt::MouseFocusReason);
  const bool left = event.button() == Qt::LeftButton;
  if (event.button() == Qt::MiddleButton || event.button() == Qt::RightButton ||
      (left && event.modifiers().testFlag(Qt::ShiftModifier))) {
    drag_ = Drag::Pan;
    canvas_.setCursor(Qt::SizeAllCursor);
  } else if (left) {
    drag_ = event.modifiers().testFlag(Qt::ControlModifier) ? Drag::Roll : Drag::Orbit;
    canvas_.setCursor(Qt::ClosedHandCursor);
  } else {
    return false;
  }
  last_ = pressed_ = event.position();
  mayBeClick_ = drag_ == Drag::Orbit;
  before_ = camera();
  emit pointedAt(std::nullopt);
  return true;
}

bool SurfaceInput::move(const QMouseEvent& event) {
  // The button went up where no one told the canvas.
  if (drag_ != Drag::None && event.buttons() == Qt::NoButton) endDrag();
  const QPointF at = event.position();
  const Vector2d by = vectorOf(at - last_);
  mayBeClick_ = mayBeClick_ && (at - pressed_).manhattanLength() <= kClickReachPx;
  switch (drag_) {
    case Drag::None:
      emit pointedAt(at);
      hintAtHand();
      return true;
    case Drag::Orbit:
      setCamera(orbited(camera(), by, canvas_.height()));
      emit hint(tr("Turning; Esc takes it back"));
      break;
    case Drag::Pan:
      setCamera(panned(camera(), projection(), by));
      emit hint(tr("Moving; Esc takes it back"));
      break;
    case Drag::Roll: {
      const QPointF middle(0.5 * canvas_.width(), 0.5 * canvas_.height());
      const Vector2d from = vectorOf(last_ - middle), to = vectorOf(at - middle);
      const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      setCamera(rolled(camera(), -angle));
      emit hint(tr("Rolling; Esc takes it back"));
      break;
    }
  }
  last_ = at;
  return true;
}

void SurfaceInput::release(const QMouseEvent& event) {
  if (event.buttons() != Qt::NoButton) return;
  const bool clicked = drag_ == Drag::Orbit && mayBeClick_;
  // A hand that trembles while it clicks turns nothing.
  if (clicked && !(camera() == *before_)) setCamera(*before_);
  endDrag();
  if (clicked) pickAt(pressed_);
}

void SurfaceInput::pickAt(const QPointF& px) {
  if (!models_.source.surface()) return;
  models_.pick.pick(hitAt(*models_.source.surface(), projection(), vectorOf(px)));
}

void SurfaceInput::endDrag() {
  if (drag_ == Drag::None) return;
  drag_ = Drag::None;
  before_.reset();
  canvas_.unsetCursor();
  hintAtHand();
}

void SurfaceInput::hintAtHand() {
  const PlaneGrip& grip = models_.bridges.grip;
  if (grip.handle()) {
    emit hint(*grip.handle() == 0 ? tr("Drag: move the plane along its normal")
                                  : tr("Drag: turn the plane"));
  } else if (grip.hasKeys()) {
    emit hint(tr("The arrow keys turn the plane; [ and ] move it; Esc gives them back"));
  } else {
    emit hint(
        tr("Drag: turn (Shift: move). Click: pick. Wheel: zoom. 1 3 7: views. 5: perspective."));
  }
}

bool SurfaceInput::wheel(const QWheelEvent& event) {
  if (wheelZoomsHere(event, models_.display)) {
    const double notches = event.angleDelta().y() / kDegreesPerNotch;
    setCamera(zoomedAt(camera(), projection(), vectorOf(event.position()),
                       std::pow(kZoomPerNotch, notches)));
    return true;
  }
  // Two fingers move the picture as on the flat canvas, with Shift they turn it.
  const QPoint pixels = event.pixelDelta();
  const Vector2d by =
      vectorOf(pixels.isNull() ? QPointF(event.angleDelta()) / 8.0 : QPointF(pixels));
  setCamera(event.modifiers().testFlag(Qt::ShiftModifier) ? orbited(camera(), by, canvas_.height())
                                                          : panned(camera(), projection(), by));
  return true;
}

}  // namespace flatland::ui
