// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core3d/diff/estimate_fields.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/study/known_ridges.h"

namespace flatland {

/// Where more of the length found is stray, or more of the known ridges is missed, the median
/// distance is not that of an approximated ridge, and the row takes no part in the order.
inline constexpr double kLargestStrayShare = 0.1;

/// What is measured: apparent ridges of meshes against those that are known, for each estimator and
/// each way to the derivative, over resolutions.
struct ConvergenceOptions {
  KnownCase subject = KnownCase::SineSheet;
  std::vector<int> cells = {50, 100, 200};  ///< of KnownMeshing, each >= 3
  bool irregular = true;
  std::uint64_t seed = 1;  ///< of the mesh's moves and the random curve
  double threshold = 0.0;  ///< strength that is asked of a line; 0 leaves out no weak ridge
  int threads = 0;         ///< of the estimators; 0: all cores
  std::function<void(double)> progress = {};  ///< called with the share done
  std::stop_token stop = {};
};

/// One mesh. Distances are from the midpoints of the pieces found to the nearest known ridge,
/// weighted by the pieces' lengths, in mean lengths of the mesh's edges.
struct ConvergenceRow {
  int cells = 0;
  double edge = 0.0;         ///< mean length of an edge
  std::size_t pieces = 0;    ///< found, within triangles
  double medianEdges = 0.0;  ///< median distance; not a number without pieces
  double percentile95Edges = 0.0;
  double strayShare = 0.0;   ///< of the length found, further than an edge from every known ridge
  double missedShare = 0.0;  ///< of the known ridges, further than an edge from what was found
};

struct ConvergenceSeries {
  FieldEstimator estimator;
  RidgeDerivative derivative;
  std::vector<ConvergenceRow> rows;  ///< one for each of ConvergenceOptions::cells
  /// Slope over the rows in which at most kLargestStrayShare is stray or missed: of log(median
  /// distance) against log(edge), distance as a length: 1 for an error that stays the same in
  /// edges, 2 for second order. Empty with less than two such rows.
  std::optional<double> order;
};

/// ConvergenceSeries::order of rows.
std::optional<double> orderOf(const std::vector<ConvergenceRow>& rows);

/// All four series; empty if stopped. Time grows with the square of the cells: seconds for 200.
std::vector<ConvergenceSeries> measureConvergence(const ConvergenceOptions& options);

/// Slope of the straight line through (log x, log y) with the least squares; nullopt with less than
/// two different x. Pairs that are not positive and finite are passed over.
std::optional<double> fittedOrder(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace flatland
