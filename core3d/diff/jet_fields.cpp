// SPDX-License-Identifier: MIT
#include "core3d/diff/jet_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core3d/diff/height_fit.h"
#include "core3d/diff/one_ring.h"
#include "core3d/diff/vertex_blocks.h"
#include "core3d/diff/vertex_rings.h"

namespace flatland {

namespace {

using Eigen::Vector3d;

constexpr int kLeastRings = 2, kBaseRings = 3, kMostRings = 6, kWidestRings = 24;
// How many times the mesh's noise a fit may miss the vertices of one of its rings by.
constexpr double kTolerance = 2.0;
// Positions are floats in [-1, 1].
constexpr double kRounding = 2e-8;
// In edges: how far a line may be misplaced by noise before a wider fit is preferred.
constexpr double kGoal = 0.05;

// The surface round one vertex as heights over its tangent plane, in units of an edge.
class LocalFit {
 public:
  LocalFit(const TriangleMesh& mesh, const VertexNeighbours& neighbours,
           const std::vector<Vector3d>& normals)
      : mesh_(mesh), normals_(normals), rings_(neighbours) {}

  // False if the vertex has no normal.
  bool startAt(std::uint32_t v) {
    n_ = normals_[v];
    if (n_.isZero(0.0)) return false;
    p_ = mesh_.position(v).cast<double>();
    e1_ = n_.unitOrthogonal();
    e2_ = n_.cross(e1_);
    rings_.startAt(v);
    rings_.grow();
    double sum = 0.0;
    for (const std::uint32_t q : rings_.ring(1))
      sum += (mesh_.position(q).cast<double>() - p_).norm();
    const auto count = static_cast<double>(rings_.ring(1).size());
    unit_ = sum / count;
    if (!(unit_ > 0.0)) return false;
    const double scale = 1.0 / unit_;
    e1_ *= scale;
    e2_ *= scale;
    const Vector3d up = n_ * scale;
    up_ = up;
    sums_.clear();
    sums_.emplace_back();
    sums_[0].add(0.0, 0.0, 0.0, 1.0);
    addRing(1);
    return true;
  }

  // Adds rings until there are k; false if the surface ends before.
  bool growTo(int k) {
    while (rings_.rings() < k) {
      rings_.grow();
      addRing(rings_.rings());
    }
    return !rings_.ring(k).empty();
  }

  HeightSums within(int k) const {
    HeightSums sum = sums_[0];
    for (int i = 1; i <= k; ++i) sum += sums_[static_cast<std::size_t>(i)];
    return sum;
  }
  const HeightSums& ring(int k) const { return sums_[static_cast<std::size_t>(k)]; }
  double unit() const { return unit_; }

  SurfacePoint pointOf(const HeightPolynomial& h) const {
    // r(u, v) = p + unit (u e1 + v e2 + h n), at u = v = 0, e1 and e2 of length 1.
    const Vector3d e1 = e1_ * unit_, e2 = e2_ * unit_;
    const double twice = 1.0 / unit_, thrice = twice * twice;
    SurfaceJet jet;
    jet.p = p_ + unit_ * h.at(0, 0) * n_;
    jet.u = e1 + h.at(1, 0) * n_;
    jet.v = e2 + h.at(0, 1) * n_;
    jet.uu = 2.0 * twice * h.at(2, 0) * n_;
    jet.uv = twice * h.at(1, 1) * n_;
    jet.vv = 2.0 * twice * h.at(0, 2) * n_;
    jet.uuu = 6.0 * thrice * h.at(3, 0) * n_;
    jet.uuv = 2.0 * thrice * h.at(2, 1) * n_;
    jet.uvv = 2.0 * thrice * h.at(1, 2) * n_;
    jet.vvv = 6.0 * thrice * h.at(0, 3) * n_;
    return surfacePointOf(jet);
  }

 private:
  void addRing(int k) {
    HeightSums& sums = sums_.emplace_back();
    for (const std::uint32_t q : rings_.ring(k)) {
      const double c = n_.dot(normals_[q]);
      if (c <= 0.0) continue;
      const Vector3d d = mesh_.position(q).cast<double>() - p_;
      sums.add(d.dot(e1_), d.dot(e2_), d.dot(up_), c * c);
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<Vector3d>& normals_;
  VertexRings rings_;
  Vector3d n_, p_, e1_, e2_, up_;
  double unit_ = 1.0;
  std::vector<HeightSums> sums_;
};

double rms(const HeightSums& sums, const HeightPolynomial& h) {
  return std::sqrt(squaredResiduals(sums, h) / sums.powers[0]);
}

// Root mean square distance of vertices from their smooth surface, as far as the mesh can tell.
double noiseOf(const TriangleMesh& mesh, LocalFit& fit) {
  constexpr std::size_t kSamples = 4000;
  const std::size_t step = std::max<std::size_t>(1, mesh.vertexCount() / kSamples);
  std::vector<double> noise;
  for (std::size_t v = 0; v < mesh.vertexCount(); v += step) {
    if (!fit.startAt(static_cast<std::uint32_t>(v)) || !fit.growTo(3)) continue;
    const HeightSums sums = fit.within(3);
    const HeightPolynomial h = fitHeight(sums, 4);
    const double spare = sums.points - static_cast<double>(HeightPolynomial::sizeOf(h.degree));
    if (spare < 5) continue;
    noise.push_back(fit.unit() * rms(sums, h) * std::sqrt(sums.points / spare));
  }
  if (noise.empty()) return 0.0;
  const auto middle = noise.begin() + static_cast<std::ptrdiff_t>(noise.size() / 2);
  std::nth_element(noise.begin(), middle, noise.end());
  return *middle;
}

}  // namespace

SurfaceFields jetFields(const TriangleMesh& mesh, const FieldOptions& options) {
  const std::vector<Vector3d> normals = vertexNormals(mesh, options);
  if (normals.empty()) return {};
  const VertexNeighbours neighbours(mesh);
  double noise;
  {
    LocalFit fit(mesh, neighbours, normals);
    noise = std::max(kRounding, noiseOf(mesh, fit));
  }
  SurfaceFields fields;
  fields.resize(mesh.vertexCount());
  fields.size = surfaceSize(mesh);
  const auto makeWorker = [&] {
    return
        [&, fit = LocalFit(mesh, neighbours, normals)](std::size_t begin, std::size_t end) mutable {
          for (std::size_t i = begin; i < end; ++i) {
            const auto v = static_cast<std::uint32_t>(i);
            if (!fit.startAt(v)) continue;
            const double allowed = kTolerance * noise / fit.unit();
            int rings = kLeastRings;
            fit.growTo(kLeastRings);
            HeightPolynomial best;
            bool have = false;
            for (int k = kBaseRings; k <= kMostRings && fit.growTo(k); ++k) {
              const HeightSums sums = fit.within(k);
              const HeightPolynomial h = fitHeight(sums, 4);
              bool holds = true;
              for (int r = 1; r <= k && holds; ++r)
                holds = fit.ring(r).points == 0 || rms(fit.ring(r), h) <= allowed;
              if (!holds && k > kLeastRings) break;
              best = h;
              have = true;
              rings = k;
              const double quartic =
                  24.0 * std::sqrt(h.at(4, 0) * h.at(4, 0) + h.at(0, 4) * h.at(0, 4) +
                                   0.5 * h.at(2, 2) * h.at(2, 2));
              const double cubicError = 24.0 * noise / fit.unit() / std::pow(k, 4);
              if (cubicError <= kGoal * quartic) break;
            }
            if (options.scale > 1.0) {
              rings = std::min(kWidestRings, static_cast<int>(std::lround(rings * options.scale)));
              fit.growTo(rings);
              have = false;
            }
            if (!have) best = fitHeight(fit.within(rings), 4);
            fields.set(v, fit.pointOf(best));
          }
        };
  };
  if (!overBlocks(mesh.vertexCount(), options, 0.05, 1.0, makeWorker)) return {};
  return fields;
}

}  // namespace flatland
