// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_probe.h"

namespace flatland::ui {

std::optional<SurfaceHit> hitAt(const LoadedSurface& surface, const Projection& projection,
                                const Eigen::Vector2d& px) {
  const Sight sight = sightThrough(projection, px);
  return surface.places->firstHit(sight.from, sight.along, !projection.distance.has_value());
}

std::optional<SurfaceReading> readingAt(const LoadedSurface& surface, const Projection& projection,
                                        const Eigen::Vector2d& px, const SurfaceView& view) {
  const TriangleMesh& mesh = *surface.mesh;
  const std::optional<SurfaceHit> hit = hitAt(surface, projection, px);
  if (!hit) return std::nullopt;
  SurfaceReading reading{};
  reading.hit = *hit;
  reading.vertex = hit->nearestVertex(mesh);
  reading.fileVertex = mesh.fileVertex[reading.vertex];
  reading.inFile = mesh.origin + mesh.unit * hit->at;
  if (surface.fields) {
    if (const auto terms = termsAt(mesh, *surface.fields, view, reading.vertex)) {
      reading.terms = terms->towardsGrowth();
    }
  }
  return reading;
}

}  // namespace flatland::ui
