// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_pick.h"

namespace flatland::ui {

namespace {

SurfaceHit placeIn(const TriangleMesh& mesh, std::uint32_t triangle,
                   const std::array<double, 3>& weights) {
  SurfaceHit hit{triangle, weights, Eigen::Vector3d::Zero()};
  for (std::size_t k = 0; k < 3; ++k) {
    hit.at += weights[k] * mesh.position(mesh.triangles[triangle][k]).cast<double>();
  }
  return hit;
}

/// The place of a surface nearest to one of another mesh of the same file.
std::optional<SurfaceHit> movedTo(const LoadedSurface& surface, const TriangleMesh& from,
                                  const SurfaceHit& hit) {
  const Eigen::Vector3d inFile = from.origin + from.unit * hit.at;
  return surface.places->nearest((inFile - surface.mesh->origin) / surface.mesh->unit);
}

bool same(const SurfaceHit& a, const SurfaceHit& b) {
  return a.triangle == b.triangle && a.weights == b.weights;
}

}  // namespace

SurfacePick::SurfacePick(const SurfaceSource& source, QObject* parent)
    : QObject(parent), source_(source) {
  connect(&source_, &SurfaceSource::changed, this, &SurfacePick::follow);
}

void SurfacePick::pick(const std::optional<SurfaceHit>& hit) {
  wish_.reset();
  if (!surface() || (!hit && !hit_) || (hit && hit_ && same(*hit, *hit_))) return;
  hit_ = hit;
  seen_ = hit ? surface() : nullptr;
  emit changed();
}

void SurfacePick::pickVertex(std::uint32_t vertex) {
  if (!surface() || vertex >= surface()->mesh->vertexCount()) return;
  const TriangleMesh& mesh = *surface()->mesh;
  const std::uint32_t corner = mesh.cornersAt[mesh.cornerStart[vertex]];
  std::array<double, 3> weights{};
  weights[corner % 3] = 1.0;
  pick(placeIn(mesh, corner / 3, weights));
}

void SurfacePick::pickTriangle(std::uint32_t triangle) {
  if (!surface() || triangle >= surface()->mesh->triangleCount()) return;
  constexpr double kThird = 1.0 / 3.0;
  pick(placeIn(*surface()->mesh, triangle, {kThird, kThird, kThird}));
}

void SurfacePick::pickWhenRead(bool isTriangle, std::uint32_t number) {
  if (!surface() || source_.isPreview()) {
    wish_ = Wish{isTriangle, number};
  } else if (isTriangle) {
    pickTriangle(number);
  } else {
    pickVertex(number);
  }
}

void SurfacePick::follow() {
  if (wish_ && surface() && !source_.isPreview()) {
    const Wish wish = *wish_;
    return pickWhenRead(wish.isTriangle, wish.number);
  }
  if (!hit_ || surface() == seen_) return;
  // Fields come later than their mesh, or anew; another mesh has other triangles.
  if (!surface() || !isSameSurface(*surface(), *seen_)) {
    hit_.reset();
  } else if (surface()->mesh != seen_->mesh) {
    hit_ = movedTo(*surface(), *seen_->mesh, *hit_);
  }
  seen_ = hit_ ? surface() : nullptr;
  emit changed();
}

}  // namespace flatland::ui
