// SPDX-License-Identifier: MIT
#include "core3d/study/convergence.h"

#include <algorithm>
#include <cmath>

#include "core3d/lines/line_finder.h"
#include "core3d/mesh/build_mesh.h"
#include "core3d/study/line_distances.h"

namespace flatland {

namespace {

constexpr int kSamplesPerRidge = 200;

ConvergenceRow rowOf(const KnownRidges& known, const TriangleMesh& mesh,
                     const std::vector<LineSegment>& segments) {
  ConvergenceRow row;
  row.edge = meanEdge(mesh);
  row.pieces = segments.size();
  std::vector<MeasuredPiece> pieces;
  double length = 0.0, stray = 0.0;
  for (const LineSegment& segment : segments) {
    pieces.push_back(pieceOf(mesh, segment));
    pieces.back().distance = known.distanceToRidge(pieces.back().middle);
    length += pieces.back().length;
    if (pieces.back().distance > row.edge) stray += pieces.back().length;
  }
  row.strayShare = length > 0.0 ? stray / length : 0.0;
  row.medianEdges = distancePercentile(pieces, 0.5) / row.edge;
  row.percentile95Edges = distancePercentile(pieces, 0.95) / row.edge;

  const std::vector<Eigen::Vector3d> samples = known.samples(kSamplesPerRidge);
  const auto isFound = [&](const Eigen::Vector3d& sample) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const MeasuredPiece& piece) {
      return (piece.middle - sample).squaredNorm() <= row.edge * row.edge;
    });
  };
  const auto found = std::count_if(samples.begin(), samples.end(), isFound);
  if (!samples.empty()) {
    row.missedShare = 1.0 - static_cast<double>(found) / static_cast<double>(samples.size());
  }
  return row;
}

}  // namespace

std::optional<double> fittedOrder(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<Eigen::Vector2d> logs;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const bool usable = x[i] > 0.0 && y[i] > 0.0 && std::isfinite(x[i]) && std::isfinite(y[i]);
    if (usable) logs.emplace_back(std::log(x[i]), std::log(y[i]));
  }
  if (logs.size() < 2) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : logs) mean += p / static_cast<double>(logs.size());
  double squares = 0.0, products = 0.0;
  for (const Eigen::Vector2d& p : logs) {
    squares += (p.x() - mean.x()) * (p.x() - mean.x());
    products += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  if (!(squares > 0.0)) return std::nullopt;
  return products / squares;
}

std::optional<double> orderOf(const std::vector<ConvergenceRow>& rows) {
  std::vector<double> edges, distances;
  for (const ConvergenceRow& row : rows) {
    if (std::max(row.strayShare, row.missedShare) > kLargestStrayShare) continue;
    edges.push_back(row.edge);
    distances.push_back(row.medianEdges * row.edge);
  }
  return fittedOrder(edges, distances);
}

std::vector<ConvergenceSeries> measureConvergence(const ConvergenceOptions& options) {
  const KnownRidges known(options.subject, options.seed);
  std::vector<ConvergenceSeries> all;
  for (const FieldEstimator estimator : {FieldEstimator::JetFit, FieldEstimator::OneRing}) {
    for (const RidgeDerivative derivative :
         {RidgeDerivative::ClosedForm, RidgeDerivative::OneRing}) {
      all.push_back({estimator, derivative, {}, {}});
    }
  }
  LineOptions lines;
  lines[LineFamily::ApparentRidges] = true;
  lines.threshold[static_cast<std::size_t>(LineFamily::ApparentRidges)] = options.threshold;
  double done = 0.0, work = 0.0;
  for (const int cells : options.cells) work += static_cast<double>(cells) * cells;

  for (const int cells : options.cells) {
    const BuiltMesh built = buildMesh(
        known.meshed({.cells = cells, .irregular = options.irregular, .seed = options.seed}));
    for (std::size_t i = 0; i < all.size(); i += 2) {
      const SurfaceFields fields = estimateFields(
          built.mesh,
          {.estimator = all[i].estimator, .threads = options.threads, .stop = options.stop});
      if (options.stop.stop_requested()) return {};
      LineFinder finder(built.mesh, fields);
      for (std::size_t k = i; k < i + 2; ++k) {
        lines.derivative = all[k].derivative;
        const FeatureLines found = finder.find({.towards = known.towards(), .eye = {}}, lines);
        ConvergenceRow row = rowOf(known, built.mesh, found.of(LineFamily::ApparentRidges));
        row.cells = cells;
        all[k].rows.push_back(row);
      }
      done += 0.5 * static_cast<double>(cells) * cells;
      if (options.progress) options.progress(done / work);
    }
  }
  for (ConvergenceSeries& series : all) series.order = orderOf(series.rows);
  return all;
}

}  // namespace flatland
