// SPDX-License-Identifier: MIT
#include "core3d/study/triangle_lesson.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core3d/lines/apparent_ridge_parts.h"
#include "core3d/lines/line_finder.h"
#include "core3d/lines/vertex_terms.h"

namespace flatland {

namespace {

using Corner = TriangleLesson::Corner;
using Piece = TriangleLesson::Piece;
using Vec = Eigen::Vector3d;

Vec unitOrZero(const Vec& v) {
  const double length = v.norm();
  return length > 0.0 ? Vec(v / length) : Vec(Vec::Zero());
}

LineOptions optionsFor(double threshold) {
  LineOptions options;
  options[LineFamily::ApparentRidges] = true;
  options.threshold[static_cast<std::size_t>(LineFamily::ApparentRidges)] = threshold;
  return options;
}

}  // namespace

std::string_view nameOf(RidgeVerdict verdict) {
  constexpr std::string_view kNames[kRidgeVerdictCount] = {
      "unknown normal",  "creased", "no crossing", "turned away", "singular point",
      "directions turn", "weak",    "minimum",     "flat",        "kept"};
  return kNames[static_cast<std::size_t>(verdict)];
}

struct TriangleStudy::State {
  const TriangleMesh& mesh;
  const SurfaceFields& fields;
  Sheets sheets;
  SharpEdges sharp;
  LineFinder finder;
  SeenVertices seen;

  Corner cornerAt(const SurfaceView& view, std::uint32_t vertex) const;
  void addRing(Corner& corner) const;
  void addCrossings(const SeenMesh& sight, const Crossings& found, TriangleLesson& lesson) const;
  void addPieces(const SeenMesh& sight, const OrientedFace& face, TriangleLesson& lesson) const;
  Piece pieceOf(const SeenMesh& sight, const OrientedFace& face, std::uint32_t triangle,
                const LineEnd& a, const LineEnd& b, std::initializer_list<int> corners) const;
  RidgeVerdict verdictOf(const SeenMesh& sight, const OrientedFace& face,
                         const TriangleLesson& lesson) const;
};

TriangleStudy::TriangleStudy(const TriangleMesh& mesh, const SurfaceFields& fields)
    : state_(new State{
          mesh, fields, Sheets(mesh), SharpEdges(mesh, fields), LineFinder(mesh, fields), {}}) {}
TriangleStudy::~TriangleStudy() = default;

Corner TriangleStudy::State::cornerAt(const SurfaceView& view, std::uint32_t vertex) const {
  Corner corner;
  corner.vertex = vertex;
  corner.at = mesh.position(vertex).cast<double>();
  corner.n = fields.normal(vertex).cast<double>();
  corner.tangent.setZero();
  corner.growing.setZero();
  const auto terms = termsAt(mesh, fields, view, vertex);
  if (!terms) return corner;
  corner.nw = terms->nw;
  corner.lambda = terms->lambda.value_or(std::numeric_limits<double>::infinity());
  corner.tangent = unitOrZero(terms->r);
  corner.derivative = terms->feature + terms->offset + terms->perspective;
  corner.flipped = corner.derivative < 0.0;
  corner.growing = corner.flipped ? Vec(-corner.tangent) : corner.tangent;
  if (corner.derivative == 0.0) corner.growing.setZero();
  addRing(corner);
  // Per step on the screen, which is |r| long on the surface.
  corner.ringDerivative *= terms->r.norm();
  return corner;
}

void TriangleStudy::State::addRing(Corner& corner) const {
  const auto lambdaAt = [this](std::uint32_t v) {
    const float q = seen.nw[v] != 0.0f ? seen.root[v] / seen.nw[v] : 0.0f;
    return std::isfinite(q * q) ? q * q : 0.0f;
  };
  const RingDifference ring = ringDifference(mesh, fields.normal(corner.vertex),
                                             corner.tangent.cast<float>(), lambdaAt, corner.vertex);
  const double size = fields.size;
  for (int i = 0; i < std::min(ring.sides, 2); ++i) {
    corner.ring.push_back(ring.at[i].cast<double>());
    corner.ringLambda.push_back(size * size * static_cast<double>(ring.lambda[i]));
  }
  corner.ringDerivative = size * size * size * static_cast<double>(ring.derivative);
}

void TriangleStudy::State::addCrossings(const SeenMesh& sight, const Crossings& found,
                                        TriangleLesson& lesson) const {
  const OrientedFace plain = apparentRidgeFace(sight, lesson.triangle, false);
  const auto& v = mesh.triangles[lesson.triangle];
  for (int i = 0; i < found.count; ++i) {
    const EdgePoint& point = found.points[i];
    const auto k = static_cast<std::size_t>(point.corner), next = (k + 1) % 3;
    // D_tA lambda per step on the screen, as the thesis has it: the factor (n.w)^4 divided out.
    const auto derivativeAt = [&](std::size_t c) {
      const double nw = sight.seen.nw[v[c]];
      return nw != 0.0 ? static_cast<double>(plain.slope[c]) / (nw * nw * nw * nw) : 0.0;
    };
    const double a = derivativeAt(k), b = derivativeAt(next);
    const float strength = apparentRidgeStrength(sight, v[k], v[next], point.t);
    lesson.crossings.push_back({point.corner, static_cast<double>(point.t),
                                a + b > 0.0 ? a / (a + b) : 0.5,
                                endAt(mesh, lesson.triangle, point, strength).at.cast<double>(),
                                static_cast<double>(strength)});
  }
}

Piece TriangleStudy::State::pieceOf(const SeenMesh& sight, const OrientedFace& face,
                                    std::uint32_t triangle, const LineEnd& a, const LineEnd& b,
                                    std::initializer_list<int> corners) const {
  Piece piece;
  piece.a = a.at.cast<double>();
  piece.b = b.at.cast<double>();
  piece.strength = static_cast<double>(std::max(a.strength, b.strength));
  piece.isMaximum = true;
  const Vec along = unitOrZero(piece.b - piece.a);
  for (const int k : corners) {
    Piece::Test test;
    test.corner = k;
    const Vec p = face.p[k].cast<double>(), from = piece.a - p;
    const Vec perpendicular = from - along * from.dot(along);
    test.foot = p + perpendicular;
    const double size = perpendicular.norm() * static_cast<double>(face.r[k].norm());
    test.cosine = size > 0.0 ? perpendicular.dot(face.r[k].cast<double>()) / size : 0.0;
    test.passes = pointsTowards(face.p[k], face.r[k], a.at, b.at);
    piece.isMaximum = piece.isMaximum && test.passes;
    piece.tests.push_back(test);
  }
  const RidgeFall fall = apparentRidgeFall(sight, triangle);
  const float reach = Contrast::kReach * sight.size();
  const float slope = fallOfDerivative(face, fall.derivative, a.at, b.at);
  piece.fall = fall.curvature > 0.0f
                   ? static_cast<double>(0.5f * slope * reach * reach / fall.curvature)
                   : 0.0;
  piece.standsOut = Contrast::mayFall(slope, fall.curvature, reach) &&
                    apparentRidgeStandsOut(sight, triangle, a.at, b.at);
  return piece;
}

void TriangleStudy::State::addPieces(const SeenMesh& sight, const OrientedFace& face,
                                     TriangleLesson& lesson) const {
  const auto endOf = [&](const TriangleLesson::Crossing& crossing) {
    return LineEnd{crossing.at.cast<float>(), static_cast<float>(crossing.strength), {}};
  };
  if (lesson.crossings.size() == 2) {
    lesson.pieces.push_back(pieceOf(sight, face, lesson.triangle, endOf(lesson.crossings[0]),
                                    endOf(lesson.crossings[1]), {0, 1, 2}));
  } else if (lesson.crossings.size() == 3) {
    LineEnd middle{(face.p[0] + face.p[1] + face.p[2]) / 3.0f, 0.0f, {}};
    for (const auto& crossing : lesson.crossings) middle.strength += endOf(crossing).strength;
    middle.strength /= 3.0f;
    for (const auto& crossing : lesson.crossings) {
      lesson.pieces.push_back(pieceOf(sight, face, lesson.triangle, endOf(crossing), middle,
                                      {crossing.corner, (crossing.corner + 1) % 3}));
    }
  }
}

RidgeVerdict TriangleStudy::State::verdictOf(const SeenMesh& sight, const OrientedFace& face,
                                             const TriangleLesson& lesson) const {
  const auto& v = mesh.triangles[lesson.triangle];
  unsigned every = 0xff, some = 0;
  for (const std::uint32_t corner : v) {
    every &= seen.flags[corner];
    some |= seen.flags[corner];
  }
  if (!(every & VertexFlag::kKnown)) return RidgeVerdict::UnknownNormal;
  if (sharp.splits(lesson.triangle)) return RidgeVerdict::Creased;
  if (std::none_of(lesson.opposed.begin(), lesson.opposed.end(), [](bool b) { return b; }))
    return RidgeVerdict::NoCrossing;
  if (!sight.shows(lesson.triangle, every & VertexFlag::kFront, some & VertexFlag::kFront))
    return RidgeVerdict::TurnedAway;
  if (lesson.crossings.empty()) return RidgeVerdict::SingularPoint;
  if (!directionsAgree(face)) return RidgeVerdict::DirectionsTurn;
  // The best of the pieces: each fails by the first of three.
  RidgeVerdict best = RidgeVerdict::Weak;
  const float threshold = sight.threshold(LineFamily::ApparentRidges);
  for (const Piece& piece : lesson.pieces) {
    RidgeVerdict verdict = RidgeVerdict::Kept;
    if (!(static_cast<float>(piece.strength) >= threshold) || !(some & VertexFlag::kStrong)) {
      verdict = RidgeVerdict::Weak;
    } else if (!piece.isMaximum) {
      verdict = RidgeVerdict::Minimum;
    } else if (!piece.standsOut) {
      verdict = RidgeVerdict::Flat;
    }
    best = std::max(best, verdict);
  }
  return best;
}

TriangleLesson TriangleStudy::lesson(std::uint32_t triangle, const SurfaceView& view,
                                     double threshold, bool unfiltered) {
  State& s = *state_;
  const LineOptions options = optionsFor(threshold);
  const VertexNeeds needs{
      .ridges = true, .minRoot = static_cast<float>(threshold / s.fields.size), .everywhere = true};
  const VertexRun all{0, static_cast<std::uint32_t>(s.mesh.vertexCount()), true, true, false};
  s.seen.resize(s.mesh.vertexCount(), needs);
  seeVertices(s.mesh, s.fields, view, needs.minRoot, {&all, 1}, s.seen);
  const SeenMesh sight{s.mesh, s.fields, view, options, s.seen, s.sheets};

  TriangleLesson lesson;
  lesson.triangle = triangle;
  lesson.threshold = threshold;
  lesson.unfiltered = unfiltered;
  const auto& v = s.mesh.triangles[triangle];
  for (std::size_t k = 0; k < 3; ++k) lesson.corners[k] = s.cornerAt(view, v[k]);
  const OrientedFace face = apparentRidgeFace(sight, triangle, !unfiltered);
  for (std::size_t k = 0; k < 3; ++k) {
    lesson.opposed[k] = face.r[k].dot(face.r[(k + 1) % 3]) < 0.0f;
  }
  s.addCrossings(sight, orientedCrossings(face), lesson);
  s.addPieces(sight, face, lesson);
  lesson.verdict = s.verdictOf(sight, face, lesson);
  LineOptions asked = options;
  asked.unfiltered = unfiltered;
  const FeatureLines lines = s.finder.find(view, asked);
  for (const LineSegment& segment : lines.of(LineFamily::ApparentRidges)) {
    if (segment.triangle != triangle) continue;
    const auto own =
        std::find_if(lesson.pieces.begin(), lesson.pieces.end(), [&segment](const Piece& piece) {
          return piece.a.cast<float>() == segment.a.at && piece.b.cast<float>() == segment.b.at;
        });
    // A sharp edge is a line of this family too, but no piece of the triangle.
    if (own == lesson.pieces.end()) continue;
    own->drawn = true;
    lesson.drawn = true;
  }
  return lesson;
}

}  // namespace flatland
