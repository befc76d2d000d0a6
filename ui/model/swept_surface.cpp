// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/swept_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flatland/features/orientation.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"

namespace flatland::ui {

namespace {

constexpr char kRevolution[] = "revolution", kExtrusion[] = "extrusion";
constexpr int kUsualCells = 128;  // few lines of a curve are near nothing then, and it is soon made
constexpr double kRaisedDeg = 25.0;   // enough to see that there is a surface
constexpr double kAxisGap = 0.25;     // from the curve, of its width or height
constexpr double kHeightShare = 0.8;  // of the curve's longer side

/// Two digits: numbers that a person would have typed.
double shortened(double value) {
  if (value == 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  return std::round(value / unit) * unit;
}

/// Of the curve itself: control points may be far from it.
Bounds sampledBounds(const Curve& curve) {
  constexpr int kPerPiece = 48;
  Bounds box{pointAt(curve, 0.0), pointAt(curve, 0.0)};
  for (const Vec2& p : sampledPoints(curve, kPerPiece)) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

}  // namespace

bool isSwept(const Scene& scene) { return scene.surface && scene.surface->mesh == kSweptMesh; }

SweptSurface::Kind kindOf(const SweptSetting& swept) {
  return swept.kind == kRevolution ? SweptSurface::Kind::Revolution : SweptSurface::Kind::Extrusion;
}

std::string nameOf(SweptSurface::Kind kind) {
  return kind == SweptSurface::Kind::Revolution ? kRevolution : kExtrusion;
}

std::optional<SweptSurface> sweptOf(const Scene& scene) {
  if (!isSwept(scene) || !scene.surface->swept) return std::nullopt;
  const SweptSetting& setting = *scene.surface->swept;
  if (setting.curve >= scene.curves.size() || !std::isfinite(setting.amount)) return std::nullopt;
  const SceneCurve& curve = scene.curves[setting.curve];
  SweptSurface surface{curve.shape, kindOf(setting), setting.amount};
  if (surface.kind == SweptSurface::Kind::Extrusion && !(surface.amount > 0.0)) {
    return std::nullopt;
  }
  if (isClosed(curve.shape)) return surface;
  const SurfaceView view{.towards = scene.surface->camera.towards, .eye = {}};
  const FlatView flat = flatViewOf(surface, view);
  // The outside of an open curve is its left (core3d/mesh/swept.h).
  surface.turned = normalSide(curve, frameOf(flat.view.value_or(scene.view))) < 0;
  return surface;
}

SurfaceSetting withEveryRidge(SurfaceSetting setting) {
  SurfaceFamily ridges = familyOf(setting, LineFamily::ApparentRidges);
  if (ridges.threshold != usualFamily(LineFamily::ApparentRidges).threshold) return setting;
  ridges.threshold = 0.0;
  return withFamily(std::move(setting), ridges);
}

SurfaceSetting withUsualRidges(SurfaceSetting setting) {
  SurfaceFamily ridges = familyOf(setting, LineFamily::ApparentRidges);
  if (ridges.threshold != 0.0) return setting;
  const SurfaceFamily usual = usualFamily(LineFamily::ApparentRidges);
  ridges.threshold = usual.threshold;
  std::erase_if(setting.families,
                [&](const SurfaceFamily& family) { return family.name == usual.name; });
  return ridges == usual ? setting : withFamily(std::move(setting), ridges);
}

SurfaceSetting sweptSetting(const Scene& scene, std::size_t curve, SweptSurface::Kind kind) {
  SurfaceSetting setting = scene.surface.value_or(SurfaceSetting{});
  const Bounds box = sampledBounds(scene.curves[curve].shape);
  const Vec2 size = box.high - box.low;
  SweptSetting swept;
  swept.kind = nameOf(kind);
  swept.curve = curve;
  swept.cells = kUsualCells;
  if (kind == SweptSurface::Kind::Extrusion) {
    const double height = shortened(kHeightShare * std::max(size.x(), size.y()));
    if (height > 0.0) swept.amount = height;
  } else {
    swept.amount = shortened(box.low.x() - kAxisGap * std::max(size.x(), size.y()));
  }
  // Kept cameras look at another one of the kind as they did at this.
  if (!setting.swept || setting.swept->kind != swept.kind) setting.savedCameras.clear();
  setting.mesh = kSweptMesh;
  setting.swept = swept;
  setting.plane.reset();
  setting = withCamera(std::move(setting), usualCamera(kind, scene.view));
  return withEveryRidge(std::move(setting));
}

SurfaceCamera usualCamera(SweptSurface::Kind kind, const View& flat) {
  SurfaceCamera camera;
  const Vec2 w = frameOf(flat).towards;
  if (kind == SweptSurface::Kind::Revolution) {
    const double end = w.y() < 0.0 ? -1.0 : 1.0;
    camera.towards = {0.0, end, 0.0};
    camera.up = {0.0, 0.0, -end};
    return camera;
  }
  const double raised = kRaisedDeg * std::numbers::pi / 180.0;
  camera.towards = {std::cos(raised) * w.x(), std::cos(raised) * w.y(), std::sin(raised)};
  camera.up = Eigen::Vector3d::UnitZ();
  return camera;
}

}  // namespace flatland::ui
