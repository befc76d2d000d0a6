// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/view_link.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ui/model/cutting_plane.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

namespace {

using Eigen::Vector3d;

constexpr double kSameDeg = 1e-7;  ///< rounding of turns there and back is far below it
constexpr double kMatchDeg = 0.1;  ///< a scene written by hand has a few digits
constexpr double kDeg = 180.0 / std::numbers::pi;

bool sameAngle(double aDeg, double bDeg) { return std::abs(normalizedDeg(aDeg - bDeg)) < kSameDeg; }

}  // namespace

ViewLink::ViewLink(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &ViewLink::follow);
  on_ = !disagree();
  judged_ = canLink();
  showWhyNot();
}

bool ViewLink::canLink() const {
  return sweptOf(document_.scene()).has_value() || (document_.scene().surface && section_);
}

void ViewLink::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on_) cameraTurned();
  emit changed();
}

void ViewLink::judgeScene() {
  judged_ = canLink();
  if (!on_ || !disagree()) return;
  on_ = false;
  emit changed();
}

void ViewLink::setSectionPlane(const std::optional<CutPlane>& plane) {
  section_ = plane;
  if (!judged_ && canLink()) judgeScene();
  showWhyNot();
}

std::optional<View> ViewLink::flatView(std::string* whyNot) const {
  const Scene& scene = document_.scene();
  const SurfaceCamera& camera = scene.surface->camera;
  if (camera.perspectiveDeg || scene.view.distance) {
    *whyNot = kNoFlatPerspective;
    return std::nullopt;
  }
  if (const std::optional<SweptSurface> swept = sweptOf(scene)) {
    FlatView flat = flatViewOf(*swept, {.towards = camera.towards, .eye = {}});
    *whyNot = std::move(flat.whyNot);
    return flat.view;
  }
  PlaneView flat = planeViewOf(*section_, {.towards = camera.towards, .eye = {}});
  *whyNot = std::move(flat.whyNot);
  return flat.view;
}

bool ViewLink::disagree() const {
  if (!canLink()) return false;
  std::string whyNot;
  const std::optional<View> flat = flatView(&whyNot);
  if (!flat) return false;
  return std::abs(normalizedDeg(flat->angleDeg - document_.scene().view.angleDeg)) > kMatchDeg;
}

void ViewLink::follow(const Change& change) {
  // From then on it is what a person made of the scene.
  if (change.what != Change::What::Camera && change.what != Change::What::File) judged_ = true;
  switch (change.what) {
    case Change::What::Camera:
      if (on_) cameraTurned();
      break;
    case Change::What::View:
    case Change::What::Surface:
      if (on_) viewTurned();
      break;
    default:
      break;
  }
  showWhyNot();
}

void ViewLink::showWhyNot() {
  std::string whyNot;
  if (canLink()) flatView(&whyNot);
  if (whyNot == whyNot_) return;
  whyNot_ = std::move(whyNot);
  emit changed();
}

void ViewLink::cameraTurned() {
  if (!canLink()) return;
  std::string whyNot;
  const std::optional<View> flat = flatView(&whyNot);
  if (!flat || sameAngle(flat->angleDeg, document_.scene().view.angleDeg)) return;
  document_.setView({.angleDeg = normalizedDeg(flat->angleDeg), .distance = {}});
}

// Called by undo too: it moves the camera, and pushes nothing.
void ViewLink::viewTurned() {
  if (!canLink()) return;
  const Scene& scene = document_.scene();
  const SurfaceCamera& before = scene.surface->camera;
  if (before.perspectiveDeg || scene.view.distance) return;
  SurfaceCamera camera = before;
  const std::optional<SweptSurface> swept = sweptOf(scene);
  if (swept && swept->kind == SweptSurface::Kind::Revolution) {
    std::string whyNot;
    const std::optional<View> flat = flatView(&whyNot);
    const bool end = sameAngle(std::abs(scene.view.angleDeg), 90.0);
    if (!end || (flat && sameAngle(flat->angleDeg, scene.view.angleDeg))) return;
    const SurfaceCamera along = usualCamera(swept->kind, scene.view);
    camera.towards = along.towards;
    camera.up = along.up;
  } else {
    const Vector3d right = swept ? Vector3d::UnitX() : section_->right;
    const Vector3d up = swept ? Vector3d::UnitY() : section_->up;
    const Vec2 w(right.dot(before.towards), up.dot(before.towards));
    const double angle = std::atan2(w.y(), w.x());
    if (w.norm() < kSeenAlong || sameAngle(angle * kDeg, scene.view.angleDeg)) return;
    const Eigen::AngleAxisd turn(scene.view.angleDeg / kDeg - angle, right.cross(up));
    camera.towards = (turn * before.towards).normalized();
    camera.up = turn * before.up;
  }
  document_.setCamera(camera);
}

}  // namespace flatland::ui
