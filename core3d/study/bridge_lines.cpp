// SPDX-License-Identifier: MIT
#include "core3d/study/bridge_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core3d/lines/contrast.h"
#include "flatland/features/orientation.h"
#include "flatland/features/terms.h"

namespace flatland {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kCirclePoints = 256;
constexpr int kArcSteps = 1024;  // on a piece, for distances along the curve
// Fits reach over two to three rings of neighbours (docs/math/surface_fields.md): what is nearer
// than that is smoothed over, or looked at from one side.
constexpr double kNearEdges = 4.0;
// Below it, an error of the normal of a hundredth changes lambda by two fifths.
constexpr double kSmallFacing = 0.05;
constexpr double kFewestEdgesOfRadius = 4.0;
// By how much the meridian's eigenvalue must exceed the parallel's. Estimated curvatures err by
// some percent.
constexpr double kClearWin = 1.2;
// A maximum that falls by twice what the line finder asks for has to be found.
constexpr double kClearFall = 2.0 * Contrast::kFall;
// Of curvatures on the two sides of a joint, relative to their sizes and that of the curve.
constexpr double kJump = 1e-6;

constexpr std::array kNames = {"none", "faces-away",      "parallel-wins", "pole",  "crease",
                               "end",  "silhouette-near", "sharp-bend",    "slight"};
constexpr std::array kReasons = {
    "the line has to be there",
    "the surface faces away: ridges are looked for on the side that is seen",
    "the parallel turns the normal as much as the meridian: no circle is a maximum",
    "the axis is within 4 edges: parallels shrink to a point",
    "a corner, cusp or jump of curvature is within 4 edges: the surface is not smooth",
    "a border is within 4 edges: curvature is estimated from one side",
    "a silhouette is within 4 edges, or n.w is below 0.05: lambda grows without bound there",
    "the radius of curvature is below 4 edges, here or within 4 edges: the mesh is too coarse for "
    "the bend",
    "lambda falls by less than twice what a line must have: a plain with noise on it"};

}  // namespace

std::string_view nameOf(BridgeLimit limit) { return kNames[static_cast<std::size_t>(limit)]; }
std::string_view reasonOf(BridgeLimit limit) { return kReasons[static_cast<std::size_t>(limit)]; }

SweptMesh sweptMesh(const SweptSurface& surface, int cells) {
  const int pieces = pieceCount(surface.curve);
  Sweeping sweeping;
  sweeping.samplesPerPiece = std::max(1, (cells + pieces - 1) / pieces);
  const std::vector<Vec2> points = sampledPoints(surface.curve, sweeping.samplesPerPiece);
  double length = 0.0, farthest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) length += (points[i] - points[i - 1]).norm();
    farthest = std::max(farthest, std::abs(points[i].x() - surface.amount));
  }
  const bool extruded = surface.kind == SweptSurface::Kind::Extrusion;
  const double across = extruded ? surface.amount : 2.0 * kPi * farthest;
  const double step = length / (pieces * sweeping.samplesPerPiece);
  const double layers = step > 0.0 ? std::round(across / step) : 1.0;
  // A sweep much longer than its curve would need more layers than anyone looks at.
  const int fewest = extruded ? 2 : 12, most = 8 * std::max(cells, fewest);
  sweeping.layers = static_cast<int>(std::clamp(layers, 1.0 * fewest, 1.0 * most));
  SweptMesh mesh = extruded ? extrude(surface.curve, surface.amount, sweeping)
                            : revolve(surface.curve, surface.amount, sweeping);
  if (surface.turned) {
    std::vector<std::uint32_t>& corners = mesh.soup.corners;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      std::swap(corners[i + 1], corners[i + 2]);
  }
  return mesh;
}

SweptSurface turnedLike(const SceneCurve& curve, SweptSurface surface, const SurfaceView& view) {
  const FlatView flat = flatViewOf(surface, view);
  if (!flat.view || isClosed(curve.shape)) return surface;
  // The outside of an open curve is its left (swept.h).
  surface.turned = normalSide(curve, frameOf(*flat.view)) < 0;
  return surface;
}

FlatView flatViewOf(const SweptSurface& surface, const SurfaceView& view) {
  if (view.eye) return {{}, std::string(kNoFlatPerspective)};
  const Eigen::Vector3d w = view.towards.normalized();
  if (surface.kind == SweptSurface::Kind::Extrusion) {
    const Vec2 flat = w.head<2>();
    if (flat.norm() < kSeenAlong) {
      return {{}, "an extrusion seen along its rulings is a silhouette throughout"};
    }
    return {View{.angleDeg = std::atan2(flat.y(), flat.x()) * 180.0 / kPi, .distance = {}}, {}};
  }
  if (std::hypot(w.x(), w.z()) > kSeenAlong) {
    return {{}, "a surface of revolution has to be seen along its axis, from 0,1,0 or 0,-1,0"};
  }
  return {View{.angleDeg = w.y() > 0.0 ? 90.0 : -90.0, .distance = {}}, {}};
}

/// What the limits look at.
struct BridgePrediction::Place {
  double facing = 0.0;  // n.w of the surface; 0 at a cusp
  double k = 0.0, lambda = 0.0, parallel = 0.0;
  double radius = std::numeric_limits<double>::infinity();  // from the axis
  bool cusp = false;
};

BridgePrediction::Place BridgePrediction::placeAt(double t) const {
  Place place;
  const Jet jet = jetAt(surface_.curve, t);
  if (!(jet.d1.norm() > 0.0)) {
    place.cusp = true;
    return place;
  }
  const Terms terms = termsAt(jet, frame_, 1);
  place.k = terms.k;
  place.lambda = terms.lambda.value_or(std::numeric_limits<double>::infinity());
  const double side = surface_.turned ? -1.0 : 1.0;
  if (surface_.kind == SweptSurface::Kind::Extrusion) {
    place.facing = side * extrudedPoint(surface_.curve, t, 0.0).n.dot(towards_);
    return place;
  }
  const double radius = jet.p.x() - surface_.amount;
  const double turn = radius != 0.0 ? frameOf(jet).normal.x() / radius : terms.k;
  place.parallel = turn * turn;
  place.radius = std::abs(radius);
  place.facing = radius != 0.0
                     ? side * revolvedPoint(surface_.curve, surface_.amount, t, 0.0).n.dot(towards_)
                     : terms.nw;
  return place;
}

double BridgePrediction::arcOf(double t) const {
  const double at = std::clamp(t * kArcSteps, 0.0, static_cast<double>(arcs_.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(at), arcs_.size() - 2);
  return arcs_[i] + (at - static_cast<double>(i)) * (arcs_[i + 1] - arcs_[i]);
}

BridgePrediction::BridgePrediction(const SweptSurface& surface, const SurfaceView& view)
    : surface_(surface), towards_(view.towards.normalized()), flat_(flatViewOf(surface, view)) {
  if (!flat_.view) return;
  const Curve& curve = surface_.curve;
  frame_ = frameOf(*flat_.view);
  const int pieces = pieceCount(curve);
  arcs_.push_back(0.0);
  Vec2 last = pointAt(curve, 0.0);
  for (int i = 1; i <= pieces * kArcSteps; ++i) {
    const Vec2 next = pointAt(curve, static_cast<double>(i) / kArcSteps);
    arcs_.push_back(arcs_.back() + (next - last).norm());
    last = next;
  }
  if (!isClosed(curve)) ends_ = {0.0, arcs_.back()};
  const double length = arcs_.back();
  for (int i = isClosed(curve) ? 0 : 1; i < pieces; ++i) {
    const Jet before = jetAt(curve, (i + pieces - 1) % pieces, 1.0), after = jetAt(curve, i, 0.0);
    if (!(before.d1.norm() > 0.0) || !(after.d1.norm() > 0.0)) continue;  // a corner's mark
    const Frame a = frameOf(before), b = frameOf(after);
    if (std::abs(a.k - b.k) > kJump * (std::abs(a.k) + std::abs(b.k) + 1.0 / length)) {
      creases_.push_back(arcOf(i));
    }
  }
  const FeatureSet features = findFeatures(Scene{{SceneCurve{curve}}, *flat_.view});
  for (const Degenerate& piece : features.degenerate) {
    if (piece.what != Degenerate::What::StraightEndOn) continue;  // silhouettes without a mark
    silhouettes_.insert(silhouettes_.end(), {arcOf(piece.tLow), arcOf(piece.tHigh)});
  }
  for (const Unresolved& part : features.unresolved) {
    if (part.kind != MarkKind::Silhouette) continue;
    silhouettes_.insert(silhouettes_.end(), {arcOf(part.tLow), arcOf(part.tHigh)});
  }
  for (const Mark& mark : features.marks) {
    if (mark.kind == MarkKind::Silhouette) silhouettes_.push_back(arcOf(mark.t));
    if (mark.kind == MarkKind::Ridge || mark.kind == MarkKind::Valley) {
      bends_.push_back({arcOf(mark.t), std::abs(placeAt(mark.t).k)});
    }
    if (mark.kind == MarkKind::Corner) creases_.push_back(arcOf(mark.t));
    if (mark.kind != MarkKind::ApparentRidge && mark.kind != MarkKind::Silhouette) continue;
    PredictedLine line{mark.kind, mark.t, mark.point, placeAt(mark.t).facing, 0.0, false, {}};
    line.lambda = mark.lambda.value_or(std::numeric_limits<double>::infinity());
    if (surface_.kind == SweptSurface::Kind::Extrusion) {
      for (const double side : {-0.5, 0.5}) {
        line.points.emplace_back(mark.point.x(), mark.point.y(), side * surface_.amount);
      }
    } else {
      line.closed = true;
      const double radius = mark.point.x() - surface_.amount;
      for (int i = 0; i < kCirclePoints; ++i) {
        const double angle = 2.0 * kPi * i / kCirclePoints;
        line.points.emplace_back(surface_.amount + radius * std::cos(angle), mark.point.y(),
                                 radius * std::sin(angle));
      }
    }
    lines_.push_back(std::move(line));
  }
}

BridgeLimit BridgePrediction::limitAt(MarkKind kind, double t, const BridgeScale& scale) const {
  const Place place = placeAt(t);
  const bool ridge = kind == MarkKind::ApparentRidge;
  const double reach = kNearEdges * scale.edge, arc = arcOf(t), length = arcs_.back();
  const auto isNear = [&](double other) {
    const double apart = std::abs(arc - other);
    return (isClosed(surface_.curve) ? std::min(apart, length - apart) : apart) <= reach;
  };
  if (place.cusp) return BridgeLimit::Crease;
  if (ridge && place.facing < 0.0) return BridgeLimit::FacesAway;
  if (ridge && place.lambda < kClearWin * place.parallel) return BridgeLimit::ParallelWins;
  if (place.radius <= reach) return BridgeLimit::Pole;
  if (std::any_of(creases_.begin(), creases_.end(), isNear)) return BridgeLimit::Crease;
  if (std::any_of(ends_.begin(), ends_.end(), isNear)) return BridgeLimit::End;
  const bool silhouette =
      place.facing < kSmallFacing || std::any_of(silhouettes_.begin(), silhouettes_.end(), isNear);
  if (ridge && silhouette) return BridgeLimit::SilhouetteNear;
  const auto isSharp = [&](double k) { return k * kFewestEdgesOfRadius * scale.edge > 1.0; };
  const auto bendsNear = [&](const Bend& bend) { return isSharp(bend.k) && isNear(bend.arc); };
  if (isSharp(std::abs(place.k)) || std::any_of(bends_.begin(), bends_.end(), bendsNear)) {
    return BridgeLimit::SharpBend;
  }
  return BridgeLimit::None;
}

// The line finder walks along r, which leaves the curve's plane; what it covers along the curve is
// less by the cosine between them.
bool BridgePrediction::isSlight(const PredictedLine& line, double size) const {
  const auto alongCurve = [&](double t) {
    const SurfacePoint point = surface_.kind == SweptSurface::Kind::Extrusion
                                   ? extrudedPoint(surface_.curve, t, 0.0)
                                   : revolvedPoint(surface_.curve, surface_.amount, t, 0.0);
    const auto seen = apparentCurvature(seenFrom(point, towards_));
    if (!seen || !(seen->r.norm() > 0.0)) return 1.0;
    const Eigen::Vector3d r = (point.frame * seen->r).normalized();
    return std::abs(r.head<2>().dot(jetAt(surface_.curve, t).d1.normalized()));
  };
  const double top = std::sqrt(line.lambda);
  const double reach = Contrast::kReach * size * alongCurve(line.t);
  const double end = pieceCount(surface_.curve), step = 1.0 / kArcSteps;
  for (const double sign : {-1.0, 1.0}) {
    double walked = 0.0, low = top, t = line.t;
    Vec2 from = line.mark;
    while (walked < reach && low > (1.0 - kClearFall) * top) {
      t += sign * step;
      if (isClosed(surface_.curve)) {
        t -= end * std::floor(t / end);
      } else if (t < 0.0 || t > end) {
        break;
      }
      const Vec2 next = pointAt(surface_.curve, t);
      walked += (next - from).norm();
      from = next;
      const Place place = placeAt(t);
      if (place.cusp) break;
      const double root = std::sqrt(std::max(place.lambda, place.parallel));
      if (root > (1.0 + Contrast::kFall) * top) return true;
      low = std::min(low, root);
    }
    if (low > (1.0 - kClearFall) * top) return true;
  }
  return false;
}

BridgeLimit BridgePrediction::limitOf(const PredictedLine& line, const BridgeScale& scale) const {
  const BridgeLimit limit = limitAt(line.kind, line.t, scale);
  if (limit != BridgeLimit::None || line.kind != MarkKind::ApparentRidge) return limit;
  return scale.size > 0.0 && isSlight(line, scale.size) ? BridgeLimit::Slight : BridgeLimit::None;
}

LimitAhead BridgePrediction::limitAhead(const PredictedLine& line, const BridgeScale& scale) const {
  constexpr double kMostCoarser = 8.0, kStep = 1.1;
  for (double coarser = 1.0; coarser <= kMostCoarser; coarser *= kStep) {
    const BridgeLimit limit = limitOf(line, {coarser * scale.edge, scale.size});
    if (limit != BridgeLimit::None) return {limit, coarser};
  }
  return {};
}

bool BridgePrediction::isNearLid(const Eigen::Vector3d& p, const BridgeScale& scale) const {
  return surface_.kind == SweptSurface::Kind::Extrusion &&
         0.5 * surface_.amount - std::abs(p.z()) <= kNearEdges * scale.edge;
}

double BridgePrediction::distance(const PredictedLine& line, const Eigen::Vector3d& p) const {
  if (surface_.kind == SweptSurface::Kind::Extrusion) return (p.head<2>() - line.mark).norm();
  const double radius = std::hypot(p.x() - surface_.amount, p.z());
  return std::hypot(radius - std::abs(line.mark.x() - surface_.amount), p.y() - line.mark.y());
}

std::vector<Eigen::Vector3f> inMeshCoordinates(const std::vector<Eigen::Vector3d>& points,
                                               const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3f> inMesh;
  inMesh.reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    inMesh.push_back(((p - mesh.origin) / mesh.unit).cast<float>());
  }
  return inMesh;
}

}  // namespace flatland
