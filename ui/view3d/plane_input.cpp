// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/plane_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <numbers>

#include "ui/commands/scene_commands.h"
#include "ui/model/bridges.h"
#include "ui/model/cutting_plane.h"
#include "ui/model/orbit.h"

namespace flatland::ui {

namespace {

using Eigen::Vector2d;

constexpr double kReachPx = 10.0;    ///< around a handle
constexpr double kStepShare = 0.02;  ///< of the ball's radius: one key; Shift a tenth
constexpr double kTurnRad = std::numbers::pi / 90.0;

Vector2d vectorOf(const QPointF& p) { return {p.x(), p.y()}; }

}  // namespace

PlaneInput::PlaneInput(QWidget& canvas, const SurfaceModels& models)
    : QObject(&canvas), canvas_(canvas), models_(models) {
  canvas.installEventFilter(this);
}

const SurfacePlane* PlaneInput::plane() const {
  const auto& setting = models_.document.scene().surface;
  return models_.there() && setting->plane && models_.source.surface() ? &*setting->plane : nullptr;
}

Projection PlaneInput::projection() const {
  return orbitProjection(models_.camera(), models_.source.surface()->ballRadius, canvas_.width(),
                         canvas_.height());
}

std::optional<int> PlaneInput::handleAt(const QPointF& px) const {
  const PlaneHandles handles = handlesOf(*plane(), models_.source.surface()->ballRadius);
  const Projection seen = projection();
  std::optional<int> nearest;
  double least = kReachPx * models_.display.uiScale();
  const auto offer = [&](const Eigen::Vector3d& p, int number) {
    const auto at = seen.toScreen(p);
    if (!at || (*at - vectorOf(px)).norm() > least) return;
    least = (*at - vectorOf(px)).norm();
    nearest = number;
  };
  for (int i = 0; i < 4; ++i) offer(handles.rim[static_cast<std::size_t>(i)], i + 1);
  offer(handles.centre, 0);
  return nearest;
}

bool PlaneInput::eventFilter(QObject*, QEvent* event) {
  PlaneGrip& grip = models_.bridges.grip;
  if (!plane()) {
    endDrag();
    grip.setHandle(std::nullopt);
    grip.setHasKeys(false);
    return false;
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      if (!before_) return false;
      if (static_cast<const QMouseEvent*>(event)->buttons() == Qt::NoButton) endDrag();
      return true;
    case QEvent::Leave:
      if (!before_) grip.setHandle(std::nullopt);
      return false;
    case QEvent::FocusOut:
      endDrag();
      return false;
    case QEvent::ShortcutOverride:
      if (!isKey(static_cast<const QKeyEvent&>(*event))) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event));
    default:
      return false;
  }
}

bool PlaneInput::press(const QMouseEvent& event) {
  if (before_) return true;  // a second button changes nothing
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
  const std::optional<int> handle = handleAt(event.position());
  if (!handle) {
    models_.bridges.grip.setHasKeys(false);
    return false;
  }
  canvas_.setFocus(Qt::MouseFocusReason);
  models_.bridges.grip.setHandle(handle);
  models_.bridges.grip.setHasKeys(true);
  before_ = *plane();
  held_ = *handle;
  pressed_ = event.position();
  gesture_ = models_.document.newGesture();
  return true;
}

bool PlaneInput::move(const QMouseEvent& event) {
  PlaneGrip& grip = models_.bridges.grip;
  // The button went up where no one told the canvas.
  if (before_ && event.buttons() == Qt::NoButton) endDrag();
  if (!before_) {
    if (event.buttons() != Qt::NoButton) return false;
    const std::optional<int> handle = handleAt(event.position());
    if (handle == grip.handle()) return false;
    grip.setHandle(handle);
    if (handle) {
      canvas_.setCursor(Qt::PointingHandCursor);
    } else {
      canvas_.unsetCursor();
    }
    emit handChanged();
    return false;
  }
  const double radius = models_.source.surface()->ballRadius;
  const Vector2d to = vectorOf(event.position());
  if (held_ == 0) {
    setPlane(pulled(*before_, projection(), vectorOf(pressed_), to, radius), gesture_);
  } else {
    const auto rim = static_cast<std::size_t>(held_ - 1);
    setPlane(turnedTo(*before_, handlesOf(*before_, radius).rim[rim], projection(), to), gesture_);
  }
  emit hint(tr("Moving the plane; Esc takes it back"));
  return true;
}

void PlaneInput::endDrag() {
  if (!before_) return;
  before_.reset();
  canvas_.unsetCursor();
  emit handChanged();
}

bool PlaneInput::isKey(const QKeyEvent& event) const {
  switch (event.key()) {
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
      return true;  // on some keyboards with AltGr
    case Qt::Key_C:
      return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    case Qt::Key_Escape:
      return before_ || models_.bridges.grip.hasKeys();
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return models_.bridges.grip.hasKeys();
    default:
      return false;
  }
}

bool PlaneInput::key(const QKeyEvent& event) {
  if (!isKey(event)) return false;
  PlaneGrip& grip = models_.bridges.grip;
  if (event.key() == Qt::Key_Escape) {
    if (before_) {
      setPlane(*before_, gesture_);
      endDrag();
    } else {
      grip.setHasKeys(false);
      emit handChanged();
    }
    return true;
  }
  if (before_) return true;  // keys would be undone by the next movement
  if (event.key() == Qt::Key_C) {
    if (!event.isAutoRepeat()) grip.setHasKeys(!grip.hasKeys());
    emit hint(grip.hasKeys() ? tr("The arrow keys turn the plane; [ and ] move it")
                             : tr("The arrow keys turn the surface"));
    return true;
  }
  if (!event.isAutoRepeat()) gesture_ = models_.document.newGesture();
  const double share = event.modifiers().testFlag(Qt::ShiftModifier) ? 0.1 : 1.0;
  const double radius = models_.source.surface()->ballRadius;
  const Eigen::Matrix3d axes = projection().axes;
  const Eigen::Vector3d right = axes.row(0), up = axes.row(1);
  switch (event.key()) {
    case Qt::Key_BracketLeft:
      setPlane(moved(*plane(), -share * kStepShare * radius, radius), gesture_);
      break;
    case Qt::Key_BracketRight:
      setPlane(moved(*plane(), share * kStepShare * radius, radius), gesture_);
      break;
    case Qt::Key_Left:
      setPlane(turnedAbout(*plane(), up, -share * kTurnRad), gesture_);
      break;
    case Qt::Key_Right:
      setPlane(turnedAbout(*plane(), up, share * kTurnRad), gesture_);
      break;
    case Qt::Key_Up:
      setPlane(turnedAbout(*plane(), right, -share * kTurnRad), gesture_);
      break;
    default:
      setPlane(turnedAbout(*plane(), right, share * kTurnRad), gesture_);
      break;
  }
  return true;
}

void PlaneInput::setPlane(const SurfacePlane& plane, int gesture) {
  SurfaceSetting setting = *models_.document.scene().surface;
  setting.plane = plane;
  models_.document.push(std::make_unique<SetSurface>(models_.document, std::move(setting),
                                                     tr("move plane"), gesture));
}

}  // namespace flatland::ui
