// SPDX-License-Identifier: MIT
#include "core3d/lines/contrast.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

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

bool fallsAlong(const CurvatureField& field, std::uint32_t triangle, Step at, float reach) {
  // Enough for any reach on meshes of 10^9 triangles; stops a walk that goes in circles.
  constexpr int kMostSteps = 20000;
  const TriangleMesh& mesh = field.mesh;
  const float low = at.value * (1.0f - Contrast::kFall), high = at.value * (1.0f + Contrast::kFall);
  float walked = 0.0f;
  std::uint32_t entry = TriangleMesh::kNone;  // half-edge of `triangle` that was crossed
  for (int i = 0; i < kMostSteps; ++i) {
    const auto& v = mesh.triangles[triangle];
    const Eigen::Vector3f p[3] = {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
    const Eigen::Vector3f normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const Eigen::Vector3f across = normal.cross(at.direction);
    float s[3];
    for (std::size_t k = 0; k < 3; ++k) s[k] = across.dot(p[k] - at.place);
    int exit = -1;
    float exitT = 0.0f, farthest = 0.0f;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (3 * triangle + static_cast<std::uint32_t>(k) == entry ||
          (s[k] > 0.0f) == (s[next] > 0.0f))
        continue;
      const float t = s[k] / (s[k] - s[next]);
      const float ahead = at.direction.dot(p[k] + t * (p[next] - p[k]) - at.place);
      if (exit < 0 || ahead > farthest) {
        exit = k;
        exitT = t;
        farthest = ahead;
      }
    }
    if (exit < 0) return false;  // the direction turns back: a singular place of the field
    const std::uint32_t halfEdge = 3 * triangle + static_cast<std::uint32_t>(exit);
    const std::uint32_t a = v[static_cast<std::size_t>(exit)],
                        b = v[static_cast<std::size_t>((exit + 1) % 3)];
    if (field.flags && ((field.flags[a] | field.flags[b]) & VertexFlag::kSkipped)) return true;
    const Step next = between(field, a, b, exitT, at.direction);
    if (!(next.value < high)) return false;  // also what is no number
    if (next.value <= low) return true;
    walked += (next.place - at.place).norm();
    if (!(walked < reach)) return false;
    if (!mesh.hasOpposite(halfEdge)) return true;
    entry = mesh.opposite[halfEdge];
    triangle = entry / 3;
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
  if (!fallsAlong(field, triangle, at, reach)) return false;
  at.direction = -at.direction;
  return fallsAlong(field, triangle, at, reach);
}

}  // namespace flatland
