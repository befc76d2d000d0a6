// SPDX-License-Identifier: MIT
#include "core3d/diff/local_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace flatland {

namespace {

constexpr WeightedHeight kItself{0.0, 0.0, 0.0, 1.0};

// Of ring k in a fit of this size.
double weightOf(int k, double size) {
  const double x = k / (size + 1.0);
  return 1.0 - x * x;
}

}  // namespace

LocalFit::LocalFit(const TriangleMesh& mesh, const VertexNeighbours& neighbours,
                   const std::vector<Eigen::Vector3d>& normals)
    : mesh_(mesh), normals_(normals), rings_(neighbours) {}

bool LocalFit::placeAt(std::uint32_t v) {
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
  edge_ = sum / static_cast<double>(rings_.ring(1).size());
  return edge_ > 0.0;
}

bool LocalFit::startAt(std::uint32_t v) {
  if (!placeAt(v)) return false;
  sums_.clear();
  sums_.emplace_back().add({&kItself, 1});
  addRing(1);
  return true;
}

bool LocalFit::growTo(int k) {
  while (rings_.rings() < k) {
    rings_.grow();
    addRing(rings_.rings());
  }
  return !rings_.ring(k).empty();
}

void LocalFit::addHeights(int k, double weight) {
  const double scale = 1.0 / edge_;
  for (const std::uint32_t q : rings_.ring(k)) {
    const double cosine = n_.dot(normals_[q]);
    if (!(cosine > 0.0)) continue;
    const Eigen::Vector3d d = scale * (mesh_.position(q).cast<double>() - p_);
    heights_.push_back({d.dot(e1_), d.dot(e2_), d.dot(n_), weight * cosine * cosine});
  }
}

void LocalFit::addRing(int k) {
  heights_.clear();
  addHeights(k, 1.0);
  sums_.emplace_back().add(heights_);
}

HeightPolynomial LocalFit::over(double size) {
  const int whole = static_cast<int>(std::ceil(size));
  growTo(whole);
  HeightSums sums = sums_[0];
  for (int k = 1; k <= whole; ++k) {
    sums.add(sums_[static_cast<std::size_t>(k)], weightOf(k, size));
  }
  return fitHeight(sums, 4);
}

std::optional<HeightPolynomial> LocalFit::at(std::uint32_t v, double size) {
  if (!placeAt(v)) return std::nullopt;
  heights_.assign(1, kItself);
  const int whole = static_cast<int>(std::ceil(size));
  for (int k = 1; k <= whole; ++k) {
    if (k > 1) rings_.grow();
    addHeights(k, weightOf(k, size));
  }
  HeightSums sums;
  sums.add(heights_);
  return fitHeight(sums, 4);
}

LocalFit::Misses LocalFit::misses(const HeightPolynomial& polynomial, int k) const {
  double squares = 0.0, weights = 0.0, worst = 0.0;
  for (int i = 1; i <= k; ++i) {
    const HeightSums& sums = sums_[static_cast<std::size_t>(i)];
    const double weight = sums.powers[0];
    if (!(weight > 0.0)) continue;
    const double ring = squaredResiduals(sums, polynomial);
    squares += ring;
    weights += weight;
    worst = std::max(worst, ring / weight);
  }
  return {weights > 0.0 ? std::sqrt(squares / weights) : 0.0, std::sqrt(worst)};
}

double LocalFit::rounding() const {
  constexpr double kSpacingShare = 0.2886751345948129;  // uniform within a spacing: 1 / sqrt(12)
  double squares = 0.0;
  for (int i = 0; i < 3; ++i) {
    // Of the neighbours, so not that of a coordinate which happens to be 0 at the vertex.
    const double spacing = std::ldexp(1.0, std::ilogb(std::abs(p_[i]) + edge_) - 23);
    squares += n_[i] * n_[i] * spacing * spacing;
  }
  return kSpacingShare * std::sqrt(squares);
}

int LocalFit::points(int k) const {
  int sum = 0;
  for (int i = 0; i <= k; ++i) sum += sums_[static_cast<std::size_t>(i)].points;
  return sum;
}

SurfacePoint LocalFit::pointOf(const HeightPolynomial& h) const {
  // r(u, v) = p + edge (u e1 + v e2 + h(u, v) n), taken by lengths along e1 and e2.
  const double once = 1.0 / edge_, twice = once * once;
  SurfaceJet jet;
  jet.p = p_ + edge_ * h.at(0, 0) * n_;
  jet.u = e1_ + h.at(1, 0) * n_;
  jet.v = e2_ + h.at(0, 1) * n_;
  jet.uu = 2.0 * once * h.at(2, 0) * n_;
  jet.uv = once * h.at(1, 1) * n_;
  jet.vv = 2.0 * once * h.at(0, 2) * n_;
  jet.uuu = 6.0 * twice * h.at(3, 0) * n_;
  jet.uuv = 2.0 * twice * h.at(2, 1) * n_;
  jet.uvv = 2.0 * twice * h.at(1, 2) * n_;
  jet.vvv = 6.0 * twice * h.at(0, 3) * n_;
  return surfacePointOf(jet);
}

}  // namespace flatland
