// SPDX-License-Identifier: MIT
#include "core3d/diff/jet_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core3d/diff/local_fit.h"
#include "core3d/diff/one_ring.h"
#include "core3d/diff/vertex_blocks.h"

namespace flatland {

namespace {

using Normals = std::vector<Eigen::Vector3d>;

// How large a neighbourhood is, in rings. kUnresolved: the surface bends within an edge, no
// polynomial holds, and the estimate of the one-ring, which looks least far, is the sharpest.
constexpr float kUnresolved = 1.0f;
constexpr int kSmallest = 2, kFirst = 3, kLargest = 6;
constexpr double kWidest = 24.0;  // with the user's scale: 1,800 vertices each

// A fit holds if it misses the vertices of none of its rings by more than the mesh's noise times
// this (root mean square): noise alone does not reach it on six vertices.
constexpr double kNoiseTimes = 3.0;
// In edges: a fit of three rings that misses a ring by more is not that of a resolved surface. A
// groove or stitch of one edge's width that turns the normal by 20 degrees is missed by as much.
constexpr double kUnresolvedMiss = 0.06;
// The share of vertices that are called free of features when noise is measured.
constexpr double kPlainShare = 0.1;
// In edges: noise may displace a line (the zero of a third derivative, by the rate at which that
// changes) by this much before a wider fit is tried.
constexpr double kDisplacement = 0.3;
// Standard deviations that noise does not reach.
constexpr double kSurely = 2.0;
// A residual that is not noise is one-sided over many vertices; it does this times as much harm.
// Over two rings it cannot be seen; it grows like the fifth power of the size.
constexpr double kTwoRingsShare = 0.13;

// Root mean square distance of the vertices from a smooth surface, in the mesh's unit, where the
// mesh has no features; 0 where there is nothing to tell it from.
double noiseOf(const std::vector<std::uint32_t>& order, LocalFit& fit) {
  constexpr std::size_t kSamples = 4000;
  const std::size_t step = 1 + order.size() / kSamples;
  std::vector<double> noise;
  for (std::size_t i = 0; i < order.size(); i += step) {
    if (!fit.startAt(order[i]) || !fit.growTo(kFirst)) continue;
    const HeightPolynomial h = fit.over(kFirst);
    const double points = fit.points(kFirst);
    const double spare = points - static_cast<double>(HeightPolynomial::sizeOf(h.degree));
    if (spare < 5.0) continue;
    noise.push_back(fit.edge() * fit.misses(h, kFirst).all * std::sqrt(points / spare));
  }
  if (noise.empty()) return 0.0;
  const auto at =
      noise.begin() + static_cast<std::ptrdiff_t>(kPlainShare * static_cast<double>(noise.size()));
  std::nth_element(noise.begin(), at, noise.end());
  return *at;
}

// The options without what has been told or asked for the whole: the one-ring as a part of it.
FieldOptions quiet(FieldOptions options) {
  options.scale = 1.0;
  options.progress = {};
  return options;
}

// The number of rings for a vertex.
float sizeAt(LocalFit& fit, double noise) {
  const double noiseInEdges = std::max(noise, fit.rounding()) / fit.edge();
  const double allowed = kNoiseTimes * noiseInEdges;
  fit.growTo(kFirst);
  HeightPolynomial h = fit.over(kFirst);
  const auto [missed, worst] = fit.misses(h, kFirst);
  if (worst > std::max(allowed, kUnresolvedMiss)) return kUnresolved;
  // Whether the third derivatives of a fit are known, by its own fourth ones or those of a wider
  // fit.
  const auto isKnown = [noiseInEdges](const HeightPolynomial& fitted, const HeightPolynomial& by) {
    // What of the fourth derivatives is not noise, and the cubes of curvatures, which are a part of
    // the rate at which C changes (of a curve h'''' - 3 h''^3).
    const double fourth = by.fourthNorm() - kSurely * noiseInEdges * std::sqrt(by.fourthVariance);
    const double rate = std::max(0.0, fourth) + 3.0 * std::pow(by.secondNorm(), 3.0);
    return noiseInEdges * std::sqrt(fitted.thirdVariance) <= kDisplacement * rate;
  };
  int size = kFirst;
  while (worst <= allowed && size < kLargest && !isKnown(h, h) && fit.growTo(size + 1)) {
    const HeightPolynomial wider = fit.over(size + 1);
    if (fit.misses(wider, size + 1).worstRing > allowed || isKnown(h, wider)) break;
    h = wider;
    ++size;
  }
  if (size > kFirst) return static_cast<float>(size);
  const HeightPolynomial smaller = fit.over(kSmallest);
  const bool better =
      smaller.degree == h.degree &&
      std::max(noiseInEdges, kTwoRingsShare * missed) * std::sqrt(smaller.thirdVariance) <
          std::max(noiseInEdges, missed) * std::sqrt(h.thirdVariance);
  return static_cast<float>(better ? kSmallest : kFirst);
}

// The vertices in an order that depends on the shape alone: by the lengths of the edges round them.
// A mesh that is turned, moved or renumbered keeps it, but for ties.
std::vector<std::uint32_t> inOrderOfShape(const TriangleMesh& mesh,
                                          const VertexNeighbours& neighbours) {
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  // Positive floats are ordered like their bits; in a whole number with the vertex they sort fast.
  std::vector<std::uint64_t> keys(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const Eigen::Vector3f p = mesh.position(v);
    float lengths = 0.0f;
    for (const std::uint32_t q : neighbours.of(v)) lengths += (mesh.position(q) - p).squaredNorm();
    keys[v] = std::uint64_t{std::bit_cast<std::uint32_t>(lengths)} << 32 | v;
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

// Vertices no two of which are neighbours and that leave no room for more: about every third, the
// first in the order. Sizes are chosen there and spread, which costs less than choosing everywhere
// and makes them change slowly from vertex to vertex; where they jump, lines break. Creases have
// nothing to choose and take the turn of no one beside them.
std::vector<char> sparseVertices(const VertexNeighbours& neighbours,
                                 const std::vector<std::uint32_t>& order) {
  std::vector<char> chosen(neighbours.onCrease.size(), 1);
  for (const std::uint32_t v : order) {
    if (neighbours.onCrease[v]) chosen[v] = 0;
    if (!chosen[v]) continue;
    for (const std::uint32_t q : neighbours.of(v)) chosen[q] = 0;
  }
  return chosen;
}

// Means over the vertex and its neighbours, of those that have a size. A crease stays unresolved
// whatever lies beside it, and what lies beside it does not get that from it.
std::vector<float> spread(const std::vector<float>& sizes, const VertexNeighbours& neighbours) {
  std::vector<float> means(sizes.size());
  for (std::uint32_t v = 0; v < sizes.size(); ++v) {
    if (neighbours.onCrease[v]) {
      means[v] = kUnresolved;
      continue;
    }
    float sum = 2.0f * sizes[v], weight = sizes[v] > 0.0f ? 2.0f : 0.0f;
    for (const std::uint32_t q : neighbours.of(v)) {
      if (neighbours.onCrease[q]) continue;
      sum += sizes[q];
      weight += sizes[q] > 0.0f ? 1.0f : 0.0f;
    }
    means[v] = weight > 0.0f ? sum / weight : 0.0f;
  }
  return means;
}

// (1 - t) a + t b, in the frame of b.
SurfacePoint mixed(const SurfacePoint& a, const SurfacePoint& b, double t) {
  SurfacePoint mix = b;
  const Eigen::Matrix2d turn = b.frame.transpose() * a.frame;
  const Eigen::Vector2d e1 = turn.row(0), e2 = turn.row(1);
  mix.n = ((1.0 - t) * a.n + t * b.n).normalized();
  mix.frame.col(0) = (b.frame.col(0) - mix.n * mix.n.dot(b.frame.col(0))).normalized();
  mix.frame.col(1) = mix.n.cross(Eigen::Vector3d(mix.frame.col(0)));
  mix.K = (1.0 - t) * turn * a.K * turn.transpose() + t * b.K;
  const double C[4] = {a.C(e1, e1, e1), a.C(e1, e1, e2), a.C(e1, e2, e2), a.C(e2, e2, e2)};
  for (std::size_t i = 0; i < 4; ++i)
    mix.C.coefficients[i] = (1.0 - t) * C[i] + t * b.C.coefficients[i];
  return mix;
}

}  // namespace

SurfaceFields jetFields(const TriangleMesh& mesh, const FieldOptions& options) {
  const Normals normals = vertexNormals(mesh, options);
  if (normals.empty()) return {};
  const VertexNeighbours neighbours(mesh);
  const std::vector<std::uint32_t> order = inOrderOfShape(mesh, neighbours);
  const double noise = [&] {
    LocalFit fit(mesh, neighbours, normals);
    return noiseOf(order, fit);
  }();

  std::vector<float> sizes(mesh.vertexCount(), 0.0f);
  const std::vector<char> sparse = sparseVertices(neighbours, order);
  const auto choose = [&] {
    return
        [&, fit = LocalFit(mesh, neighbours, normals)](std::size_t begin, std::size_t end) mutable {
          for (std::size_t v = begin; v < end; ++v) {
            if (sparse[v] && fit.startAt(static_cast<std::uint32_t>(v)))
              sizes[v] = sizeAt(fit, noise);
          }
        };
  };
  if (!overBlocks(sizes.size(), options, 0.05, 0.4, choose)) return {};
  sizes = spread(spread(sizes, neighbours), neighbours);

  const auto isSmall = [&](float size) { return size * options.scale < kSmallest; };
  SurfaceFields fields;
  if (std::any_of(sizes.begin(), sizes.end(), isSmall)) {
    fields = oneRingFields(mesh, quiet(options));
    if (fields.vertexCount() == 0) return {};
  } else {
    fields.resize(sizes.size());
    fields.size = surfaceSize(mesh);
  }
  const auto write = [&] {
    return [&, fit = LocalFit(mesh, neighbours, normals)](std::size_t begin,
                                                          std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        const double size = sizes[v] * options.scale;
        const double share = std::clamp((size - kUnresolved) / (kSmallest - kUnresolved), 0.0, 1.0);
        if (share == 0.0) continue;  // what the one-ring wrote stays
        const auto fitted = fit.at(v, std::clamp<double>(size, kSmallest, kWidest));
        if (!fitted) continue;
        const SurfacePoint point = fit.pointOf(*fitted);
        fields.set(v, share < 1.0 ? mixed(fields.at(mesh, v), point, share) : point);
      }
    };
  };
  if (!overBlocks(sizes.size(), options, 0.4, 1.0, write)) return {};
  return fields;
}

}  // namespace flatland
