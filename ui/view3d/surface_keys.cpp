// SPDX-License-Identifier: GPL-3.0-or-later
// What keys do to the camera: the part of SurfaceInput that is a list.
#include <QKeyEvent>
#include <QWidget>

#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_input.h"

namespace flatland::ui {

namespace {

using Eigen::Vector2d;

constexpr double kZoomPerKey = 1.2;
constexpr double kKeyStepShare = 1.0 / 36.0;  ///< of the height: an arrow key turns by 5 degrees

}  // namespace

bool isSurfaceKey(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  switch (event.key()) {
    case Qt::Key_1:
    case Qt::Key_3:
    case Qt::Key_5:
    case Qt::Key_7:
    case Qt::Key_9:
    case Qt::Key_0:
    case Qt::Key_F:
    case Qt::Key_P:
    case Qt::Key_R:
    case Qt::Key_Home:
    case Qt::Key_Space:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return true;
    default:
      return false;
  }
}

/// On the wall Esc leaves the projector, as it says there, and the class keeps its point.
bool SurfaceInput::dropsPick() const {
  return models_.pick.hit() && !models_.display.isProjector();
}

bool SurfaceInput::key(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape) {
    if (drag_ != Drag::None) {
      const SurfaceCamera before = *before_;
      endDrag();
      setCamera(before);
      return true;
    }
    if (isSpinning()) {
      setSpinning(false);
    } else if (dropsPick()) {
      models_.pick.pick(std::nullopt);
    } else {
      return false;
    }
    return true;
  }
  if (!isSurfaceKey(event)) return false;
  const double step = kKeyStepShare * canvas_.height();
  const Vector2d middle(0.5 * canvas_.width(), 0.5 * canvas_.height());
  const auto arrow = [&](double x, double y) {
    const Vector2d by(x * step, y * step);
    setCamera(event.modifiers().testFlag(Qt::ShiftModifier)
                  ? panned(camera(), projection(), by)
                  : orbited(camera(), by, canvas_.height()));
  };
  SurfaceCamera other = camera();
  const Eigen::Vector3d up = upAxisOf(*models_.document.scene().surface);
  switch (event.key()) {
    case Qt::Key_1:
      setCamera(seenFrom(other, StandardView::Front, up));
      break;
    case Qt::Key_3:
      setCamera(seenFrom(other, StandardView::Right, up));
      break;
    case Qt::Key_7:
      setCamera(seenFrom(other, StandardView::Top, up));
      break;
    case Qt::Key_9:
      other.towards = -other.towards;
      setCamera(other);
      break;
    case Qt::Key_5:
      setCamera(withPerspectiveToggled(other));
      break;
    case Qt::Key_F:
      other.centre.setZero();
      other.zoom = 1.0;
      setCamera(other);
      break;
    case Qt::Key_P:
      pickAt({middle.x(), middle.y()});
      break;
    case Qt::Key_0:
    case Qt::Key_R:
    case Qt::Key_Home:
      setCamera(homeCamera(up));
      break;
    case Qt::Key_Space:
      if (!event.isAutoRepeat()) setSpinning(!isSpinning());
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      setCamera(zoomedAt(other, projection(), middle, kZoomPerKey));
      break;
    case Qt::Key_Minus:
      setCamera(zoomedAt(other, projection(), middle, 1.0 / kZoomPerKey));
      break;
    case Qt::Key_Left:
      arrow(-1.0, 0.0);
      break;
    case Qt::Key_Right:
      arrow(1.0, 0.0);
      break;
    case Qt::Key_Up:
      arrow(0.0, -1.0);
      break;
    default:
      arrow(0.0, 1.0);
      break;
  }
  return true;
}

}  // namespace flatland::ui
