// SPDX-License-Identifier: MIT
#include "core3d/lines/contrast.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

#include "core3d/lines/seen_vertices.h"

namespace flatland {
namespace {

// A place on the surface on the way along the directions.
struct Step {
  Eigen::Vector3f place, direction;
  float value;
};

// Behind a silhouette it is as at it: larger than anything.
float quotient(const CurvatureField& field, float value, float divisor) {
  if (field.divisor == nullptr) return value;
  divisor *= field.side;
  return divisor > 0.0f ? value / divisor : std::numeric_limits<float>::infinity();
}

// Between two vertices, directions brought to agree with `like`.
Step between(const CurvatureField& field, std::uint32_t a, std::uint32_t b, float t,
             const Eigen::Vector3f& like) {
  Eigen::Vector3f ra = field.r(a), rb = field.r(b);
  if (ra.dot(like) < 0.0f) ra = -ra;
  if (rb.dot(like) < 0.0f) rb = -rb;
  const Eigen::Vector3f pa = field.mesh.position(a), pb = field.mesh.position(b);
  const float value = field.value[a] + t * (field.value[b] - field.value[a]);
  const float divisor =
      field.divisor ? field.divisor[a] + t * (field.divisor[b] - field.divisor[a]) : 1.0f;
  return {pa + t * (pb - pa), ra + t * (rb - ra), quotient(field, value, divisor)};
}

// The middle of the piece: weights of the corners from the place.
Step inside(const CurvatureField& field, std::uint32_t triangle, const Eigen::Vector3f& place,
            const Eigen::Vector3f& normal) {
  const auto& v = field.mesh.triangles[triangle];
  Eigen::Vector3f p[3];
  for (std::size_t k = 0; k < 3; ++k) p[k] = field.mesh.position(v[k]);
  float weight[3], total = 0.0f;
  for (std::size_t k = 0; k < 3; ++k) {
    weight[k] = std::max(0.0f, (p[(k + 1) % 3] - place).cross(p[(k + 2) % 3] - place).dot(normal));
    total += weight[k];
  }
  // The strongest corner gives the sign that the others are brought to.
  std::size_t main = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (field.r(v[k]).squaredNorm() > field.r(v[main]).squaredNorm()) main = k;
  }
  const Eigen::Vector3f like = field.r(v[main]);
  Step step{place, Eigen::Vector3f::Zero(), 0.0f};
  float value = 0.0f, divisor = 0.0f;
  for (std::size_t k = 0; k < 3; ++k) {
    const float share = total > 0.0f ? weight[k] / total : 1.0f / 3.0f;
    const Eigen::Vector3f r = field.r(v[k]);
    step.direction += r.dot(like) < 0.0f ? Eigen::Vector3f(-share * r) : Eigen::Vector3f(share * r);
    value += share * field.value[v[k]];
    if (field.divisor) divisor += share * field.divisor[v[k]];
  }
  step.value = quotient(field, value, divisor);
  return step;
}

// A half-edge that the walk is about to leave a triangle by, and where.
struct Exit {
  std::uint32_t halfEdge;
  float t;  // from its start
};

// From inside a triangle: the edge ahead that the line through the place along the direction meets.
std::optional<Exit> firstExit(const TriangleMesh& mesh, std::uint32_t triangle, const Step& at,
                              const Eigen::Vector3f& normal) {
  const auto& v = mesh.triangles[triangle];
  const Eigen::Vector3f p[3] = {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
  const Eigen::Vector3f across = normal.cross(at.direction);
  std::optional<Exit> exit;
  float farthest = 0.0f;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Eigen::Vector3f &a = p[k], &b = p[(k + 1) % 3];
    const float sa = across.dot(a - at.place), sb = across.dot(b - at.place);
    if ((sa > 0.0f) == (sb > 0.0f)) continue;
    const float t = sa / (sa - sb);
    const float ahead = at.direction.dot(a + t * (b - a) - at.place);
    // One is ahead, the other behind; the place itself may lie on one of them.
    if (!exit || ahead > farthest) {
      exit = Exit{3 * triangle + k, t};
      farthest = ahead;
    }
  }
  return exit;
}

// From a place on half-edge `entry` of a triangle: the edge by which it is left; none if the
// direction points back.
std::optional<Exit> nextExit(const TriangleMesh& mesh, std::uint32_t entry,
                             const Eigen::Vector3f& place, const Eigen::Vector3f& direction) {
  const std::uint32_t ca = TriangleMesh::nextCorner(entry),
                      bc = TriangleMesh::previousCorner(entry);
  // The entry runs from b to a; c is opposite.
  const Eigen::Vector3f toB = mesh.position(mesh.vertexOf(entry)) - place,
                        toA = mesh.position(mesh.vertexOf(ca)) - place,
                        toC = mesh.position(mesh.vertexOf(bc)) - place;
  const Eigen::Vector3f across = (toA - toB).cross(toC).cross(direction);
  const float sa = across.dot(toA), sb = across.dot(toB), sc = across.dot(toC);
  const bool byA = (sc > 0.0f) != (sa > 0.0f);
  if (!byA && (sc > 0.0f) == (sb > 0.0f)) return std::nullopt;
  const float t = byA ? sa / (sa - sc) : sc / (sc - sb);
  const Eigen::Vector3f to =
      byA ? Eigen::Vector3f(toA + t * (toC - toA)) : Eigen::Vector3f(toC + t * (toB - toC));
  if (!(direction.dot(to) >= 0.0f)) return std::nullopt;
  return Exit{byA ? ca : bc, t};
}

bool fallsAlong(const CurvatureField& field, std::uint32_t triangle, Step at,
                const Eigen::Vector3f& normal, float reach) {
  // Enough for any reach on meshes of 10^9 triangles; stops a walk that goes in circles.
  constexpr int kMostSteps = 20000;
  // Squared cosine of 2.5 degrees: less turning than that in one triangle is straight enough.
  constexpr float kStraight = 0.998f;
  const TriangleMesh& mesh = field.mesh;
  const float low = at.value * (1.0f - Contrast::kFall), high = at.value * (1.0f + Contrast::kFall);
  float walked = 0.0f;
  std::uint32_t entry = TriangleMesh::kNone;  // half-edge that was crossed; none yet
  const auto leave = [&](const Eigen::Vector3f& direction) {
    if (entry != TriangleMesh::kNone) return nextExit(mesh, entry, at.place, direction);
    return firstExit(mesh, triangle, {at.place, direction, at.value}, normal);
  };
  const auto skipped = [&](const Exit& exit) {
    return field.flags && ((field.flags[mesh.vertexOf(exit.halfEdge)] |
                            field.flags[mesh.vertexOf(TriangleMesh::nextCorner(exit.halfEdge))]) &
                           VertexFlag::kSkipped);
  };
  const auto arrive = [&](const Exit& exit) {
    return between(field, mesh.vertexOf(exit.halfEdge),
                   mesh.vertexOf(TriangleMesh::nextCorner(exit.halfEdge)), exit.t, at.direction);
  };
  for (int i = 0; i < kMostSteps; ++i) {
    std::optional<Exit> exit = leave(at.direction);
    // The direction turns back: a singular place of the field.
    if (!exit) return false;
    if (skipped(*exit)) return true;
    Step next = arrive(*exit);
    const float dot = at.direction.dot(next.direction),
                squares = at.direction.squaredNorm() * next.direction.squaredNorm();
    if (dot * dot < kStraight * squares) {
      // Once more along the mean of the directions at both ends: without that a walk round a circle
      // drifts outward, and sees a fall that is none.
      const auto better = leave(at.direction.normalized() + next.direction.normalized());
      if (better) {
        exit = better;
        if (skipped(*exit)) return true;
        next = arrive(*exit);
      }
    }
    if (!(next.value < high)) return false;  // also what is no number
    if (next.value <= low) return true;
    walked += (next.place - at.place).norm();
    if (!(walked < reach)) return false;
    if (!mesh.hasOpposite(exit->halfEdge)) return true;
    entry = mesh.opposite[exit->halfEdge];
    at = next;
  }
  return false;
}

}  // namespace

bool standsOut(const CurvatureField& field, std::uint32_t triangle, const Eigen::Vector3f& place,
               float reach) {
  const auto& v = field.mesh.triangles[triangle];
  const Eigen::Vector3f a = field.mesh.position(v[0]);
  const Eigen::Vector3f normal =
      (field.mesh.position(v[1]) - a).cross(field.mesh.position(v[2]) - a);
  Step at = inside(field, triangle, place, normal);
  if (!(at.value > 0.0f)) return false;
  if (!fallsAlong(field, triangle, at, normal, reach)) return false;
  at.direction = -at.direction;
  return fallsAlong(field, triangle, at, normal, reach);
}

}  // namespace flatland
