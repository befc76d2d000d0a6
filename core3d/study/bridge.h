// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core3d/diff/estimate_fields.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/study/bridge_lines.h"
#include "core3d/study/convergence.h"

namespace flatland {

/// How lines found on a mesh of a swept surface agree with those that flatland predicts. Distances
/// in mean lengths of the mesh's edges, not a number where there is nothing to measure.
///
/// Held against each other is what no limit applies to; what one applies to is counted by it.
/// Pieces are judged where they lie: one that is off its line by more than a few edges is still
/// counted.
struct LineAgreement {
  std::size_t pieces = 0;    ///< found, within triangles; all of them
  double medianEdges = 0.0;  ///< of the length found and held, to the nearest predicted line
  double percentile95Edges = 0.0;
  double strayShare = 0.0;       ///< of the length held, further than an edge from every line
  std::size_t lines = 0;         ///< predicted, that are held against what was found
  double backMedianEdges = 0.0;  ///< of places on these, to the nearest piece
  double backPercentile95Edges = 0.0;
  double coverage = 0.0;  ///< share of those places that are within an edge of a piece
  /// Length found, in edges, by the limit of its place; None is what is held.
  std::array<double, kBridgeLimitCount> lengthBy{};
  /// Predicted lines by limit; None is `lines`.
  std::array<std::size_t, kBridgeLimitCount> linesBy{};
};

/// One mesh.
struct BridgeRow {
  int cells = 0;
  double edge = 0.0;  ///< mean length of an edge, in the curve's unit
  double size = 0.0;  ///< SurfaceFields::size, in the curve's unit
  LineAgreement ridges, contours;
};

/// Prediction against the lines of one mesh, which was built from `swept`; `ridges` and `contours`
/// are what LineFinder found in the prediction's view. Precondition: there is a flat view.
BridgeRow compareLines(const BridgePrediction& prediction, const SweptMesh& swept,
                       const TriangleMesh& mesh, double size, const FeatureLines& found);

struct BridgeOptions {
  std::vector<int> cells = {16, 32, 64, 128};  ///< along the curve, each >= 3
  std::vector<FieldEstimator> estimators = {FieldEstimator::JetFit, FieldEstimator::OneRing};
  std::vector<RidgeDerivative> derivatives = {RidgeDerivative::ClosedForm,
                                              RidgeDerivative::OneRing};
  double threshold = 0.0;                     ///< of the apparent ridges
  int threads = 0;                            ///< of the estimators; 0: all cores
  std::function<void(double)> progress = {};  ///< called with the share done
  std::stop_token stop = {};
};

/// One estimator and derivative over the meshes.
struct BridgeSeries {
  FieldEstimator estimator;
  RidgeDerivative derivative;
  std::vector<BridgeRow> rows;
  std::optional<double> order;  ///< as ConvergenceSeries::order, of the ridges
};

/// All series; empty if stopped, or where there is no flat view.
std::vector<BridgeSeries> measureBridge(const BridgePrediction& prediction,
                                        const BridgeOptions& options);

/// The ridges of a series as one of a convergence study, for its figure.
ConvergenceSeries convergenceOf(const BridgeSeries& series);

/// Extrusions, 0.4 high, of random curves from directions that are even on the sphere. The curves
/// are B-splines of degree 5 with 9 control points even in the unit square, turned (turnedLike) to
/// the viewer. They are drawn until `count` of them have a line that has to be there
/// (BridgeLimit::None), at most 50 times as many.
struct BridgeTrialOptions {
  int count = 100;
  std::uint64_t seed = 1;
  int cells = 256;
  FieldEstimator estimator = FieldEstimator::JetFit;
  RidgeDerivative derivative = RidgeDerivative::ClosedForm;
  double threshold = 0.0;  ///< of the apparent ridges
  int threads = 0;
  std::function<void(double)> progress = {};
  std::stop_token stop = {};
};

/// One of the curves with a line that has to be there.
struct BridgeTrial {
  SweptSurface surface;
  Eigen::Vector3d towards;
  BridgeRow row;
  LimitAhead ahead;  ///< the nearest of its lines that are held
  /// Of these lines the largest radius of curvature, in edges: where it is large the line's place
  /// is hardly decided, and the curve runs fast, so that cells are longer than elsewhere.
  double gentlestEdges = 0.0;
};

struct BridgeTrials {
  static constexpr double kNearEdges = 0.1;  ///< a trial whose median is below counts as near
  std::vector<BridgeTrial> trials;
  std::size_t drawn = 0;  ///< curves, also those without a line that has to be there
  /// Medians over the trials of their medianEdges and backMedianEdges. A trial where nothing was
  /// found counts as infinitely far.
  double medianEdges = 0.0, backMedianEdges = 0.0;
  std::size_t belowTenth = 0;                            ///< trials with medianEdges < 0.1
  double coverage = 0.0;                                 ///< mean over the lines held
  std::array<std::size_t, kBridgeLimitCount> linesBy{};  ///< ridges of all curves drawn
};

/// The same for equal seeds on every machine. Fewer trials than asked for if stopped.
BridgeTrials measureRandomBridges(const BridgeTrialOptions& options);

}  // namespace flatland
