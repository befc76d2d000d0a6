// SPDX-License-Identifier: MIT
#include "core3d/study/section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "flatland/curve/fit.h"
#include "flatland/features/orientation.h"

namespace flatland {

namespace {

/// r at a vertex, in space; 0 where there is none.
Eigen::Vector3d ridgeDirection(const TriangleMesh& mesh, const SurfaceFields& fields,
                               const SurfaceView& view, std::uint32_t v) {
  const SurfacePoint point = fields.at(mesh, v);
  const Eigen::Vector3d w = view.towardsViewer(point.p);
  const auto seen = apparentCurvature(seenFrom(point, w, view.distanceTo(point.p)));
  if (!seen || !seen->r.allFinite()) return Eigen::Vector3d::Zero();
  return point.frame * seen->r;
}

}  // namespace

Section sectionOf(const TriangleMesh& mesh, const CutPlane& plane, double tolerance) {
  Section section{plane, sliceMesh(mesh, plane), {}, {}};
  for (std::size_t i = 0; i < section.slice.lines.size(); ++i) {
    const SliceLine& line = section.slice.lines[i];
    const auto fit = fitBezierChain(inPlane(line, plane), line.closed, {.tolerance = tolerance});
    if (!fit) continue;  // points that are apart in space are apart in their plane
    section.scene.curves.push_back({fit->chain});
    section.lineOf.push_back(i);
    section.maxDeviation = std::max(section.maxDeviation, fit->maxDeviation);
    section.corners += fit->corners;
  }
  setView(section, {.angleDeg = 90.0, .distance = {}});
  return section;
}

void setView(Section& section, const View& view) {
  section.scene.view = view;
  const ViewFrame frame = frameOf(view);
  for (SceneCurve& curve : section.scene.curves) {
    curve.flipNormal = normalSide({curve.shape}, frame) < 0;  // the left is outside
  }
}

std::optional<CutPlane> planeAlongRidge(const TriangleMesh& mesh, const SurfaceFields& fields,
                                        const SurfaceView& view, const Eigen::Vector3d& p) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double distance = (mesh.positionInFile(v) - p).squaredNorm();
    if (distance < least) least = distance, nearest = v;
  }
  const Eigen::Vector3d r = ridgeDirection(mesh, fields, view, nearest);
  const Eigen::Vector3d w = view.towardsViewer(mesh.position(nearest).cast<double>());
  if (!(r.cross(w).norm() > 0.0)) return std::nullopt;
  return planeAlong(mesh.positionInFile(nearest), r, w);
}

std::optional<double> offPlaneDeg(const TriangleMesh& mesh, const SurfaceFields& fields,
                                  const SurfaceView& view, const CutPlane& plane,
                                  std::uint32_t triangle) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : mesh.triangles[triangle]) {
    const Eigen::Vector3d w = view.towardsViewer(mesh.position(v).cast<double>());
    const Eigen::Vector3d r = ridgeDirection(mesh, fields, view, v);
    const Eigen::Vector3d onScreen = (r - r.dot(w) * w).normalized();
    sum += onScreen.dot(sum) < 0.0 ? Eigen::Vector3d(-onScreen) : onScreen;
  }
  if (!(sum.norm() > 0.0)) return std::nullopt;
  const double sine = std::min(1.0, std::abs(sum.normalized().dot(plane.normal)));
  return std::asin(sine) * 180.0 / std::numbers::pi;
}

SectionMarks compareSection(const Section& section, const TriangleMesh& mesh,
                            const SurfaceFields& fields, const SurfaceView& view,
                            const std::vector<LineSegment>& ridges) {
  SectionMarks result;
  const FeatureSet features = findFeatures(section.scene);
  result.complete = features.complete();
  for (const Mark& mark : features.marks) {
    const Eigen::Vector3d at = section.plane.inSpace(mark.point);
    const SliceLine& line =
        section.slice.lines[section.lineOf[static_cast<std::size_t>(mark.curve)]];
    std::uint32_t triangle = line.triangles.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line.triangles.size(); ++i) {
      const Eigen::Vector3d a = line.points[i].at, b = line.points[(i + 1) % line.points.size()].at;
      const double distance = (0.5 * (a + b) - at).norm() - 0.5 * (b - a).norm();
      if (distance < least) least = distance, triangle = line.triangles[i];
    }
    result.marks.push_back({mark, at, offPlaneDeg(mesh, fields, view, section.plane, triangle)});
  }
  for (const LineSegment& segment : ridges) {
    const Eigen::Vector3d a = mesh.origin + mesh.unit * segment.a.at.cast<double>(),
                          b = mesh.origin + mesh.unit * segment.b.at.cast<double>();
    const double ha = section.plane.height(a), hb = section.plane.height(b);
    if ((ha >= 0.0) == (hb >= 0.0)) continue;
    const double share = ha / (ha - hb);
    const Eigen::Vector3d at = a + share * (b - a);
    CrossedRidge ridge{at,
                       section.plane.inPlane(at),
                       offPlaneDeg(mesh, fields, view, section.plane, segment.triangle),
                       {},
                       (1.0 - share) * segment.a.strength + share * segment.b.strength};
    for (const Mark& mark : features.marks) {
      if (mark.kind != MarkKind::ApparentRidge) continue;
      const double distance = (mark.point - ridge.inPlane).norm();
      if (!ridge.toMark || distance < *ridge.toMark) ridge.toMark = distance;
    }
    result.ridges.push_back(ridge);
  }
  return result;
}

}  // namespace flatland
