// SPDX-License-Identifier: MIT
#include "core3d/study/bridge.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core3d/lines/line_finder.h"
#include "core3d/mesh/build_mesh.h"
#include "core3d/study/line_distances.h"
#include "core3d/study/unit_random.h"

namespace flatland {

namespace {

constexpr int kSamplesPerLine = 100;
constexpr double kOwnEdges = 4.0;  // what is nearer to a line was found of it, as far as limits go
constexpr double kTrialHeight = 0.4;  // enough for a few dozen edges clear of the borders
constexpr int kRandomPoints = 9, kRandomDegree = 5;  // smooth enough to have four derivatives
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::size_t indexOf(BridgeLimit limit) { return static_cast<std::size_t>(limit); }

LineOptions bridgeLines(double threshold) {
  LineOptions options;
  options[LineFamily::ApparentRidges] = true;
  options[LineFamily::OccludingContours] = true;
  options.threshold[static_cast<std::size_t>(LineFamily::ApparentRidges)] = threshold;
  return options;
}

/// t of the curve at the middle of a piece, from the parameters of its triangle's vertices.
double parameterOf(const LineSegment& segment, const SweptMesh& swept, const TriangleMesh& mesh,
                   int pieces) {
  const auto& corners = mesh.triangles[segment.triangle];
  Eigen::Vector3d p[3];
  double t[3];
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = mesh.position(corners[k]).cast<double>();
    t[k] = swept.parameters[mesh.fileVertex[corners[k]]];
  }
  // Across the seam of a closed curve, 0 is its end.
  const double highest = std::max({t[0], t[1], t[2]});
  for (double& each : t) {
    if (highest - each > 0.5 * pieces) each += pieces;
  }
  const Eigen::Vector3d middle = (0.5f * (segment.a.at + segment.b.at)).cast<double>();
  Eigen::Matrix<double, 3, 2> sides;
  sides << p[1] - p[0], p[2] - p[0];
  const Eigen::Matrix2d square = sides.transpose() * sides;
  const double determinant = square.determinant();
  if (!(determinant > 0.0)) return t[0];
  const Eigen::Vector2d right = sides.transpose() * (middle - p[0]);
  const double a = (square(1, 1) * right.x() - square(0, 1) * right.y()) / determinant;
  const double b = (square(0, 0) * right.y() - square(1, 0) * right.x()) / determinant;
  const double at = t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
  return at > pieces ? at - pieces : std::clamp(at, 0.0, static_cast<double>(pieces));
}

/// A segment in the unit of the file, for distances from places.
struct Stretch {
  Eigen::Vector3d a, b;
  double distance(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d along = b - a;
    const double square = along.squaredNorm();
    const double share = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (a + share * along - p).norm();
  }
};

/// Places along a line, those near the lids of an extrusion left out.
std::vector<Eigen::Vector3d> placesOn(const PredictedLine& line, const BridgePrediction& prediction,
                                      const BridgeScale& scale) {
  std::vector<Eigen::Vector3d> places;
  if (line.closed) {
    for (std::size_t i = 0; i < line.points.size(); i += 2) places.push_back(line.points[i]);
    return places;
  }
  for (int i = 0; i < kSamplesPerLine; ++i) {
    const double share = (i + 0.5) / kSamplesPerLine;
    const Eigen::Vector3d p = line.points[0] + share * (line.points[1] - line.points[0]);
    if (!prediction.isNearLid(p, scale)) places.push_back(p);
  }
  return places;
}

LineAgreement agreementOf(MarkKind kind, const BridgePrediction& prediction, const SweptMesh& swept,
                          const TriangleMesh& mesh, const BridgeScale& scale,
                          const std::vector<LineSegment>& found) {
  LineAgreement agreement;
  agreement.pieces = found.size();
  const int pieceTotal = pieceCount(prediction.surface().curve);
  struct Target {
    const PredictedLine* line;
    BridgeLimit limit;
    std::vector<Eigen::Vector3d> places;
  };
  std::vector<Target> targets;
  for (const PredictedLine& line : prediction.lines()) {
    if (line.kind != kind) continue;
    Target target{&line, prediction.limitOf(line, scale), placesOn(line, prediction, scale)};
    if (target.limit == BridgeLimit::None && target.places.empty()) target.limit = BridgeLimit::End;
    ++agreement.linesBy[indexOf(target.limit)];
    if (target.limit != BridgeLimit::FacesAway) targets.push_back(std::move(target));
  }
  std::vector<MeasuredPiece> held;
  std::vector<Stretch> stretches;
  double heldLength = 0.0, stray = 0.0;
  for (const LineSegment& segment : found) {
    MeasuredPiece piece = pieceOf(mesh, segment);
    stretches.push_back({mesh.origin + mesh.unit * segment.a.at.cast<double>(),
                         mesh.origin + mesh.unit * segment.b.at.cast<double>()});
    const double t = parameterOf(segment, swept, mesh, pieceTotal);
    BridgeLimit limit = prediction.limitAt(kind, t, scale);
    if (limit == BridgeLimit::None && prediction.isNearLid(piece.middle, scale)) {
      limit = BridgeLimit::End;
    }
    piece.distance = std::numeric_limits<double>::infinity();
    BridgeLimit ofLine = BridgeLimit::None;
    for (const Target& target : targets) {
      const double distance = prediction.distance(*target.line, piece.middle);
      if (distance >= piece.distance) continue;
      piece.distance = distance;
      ofLine = target.limit;
    }
    // What is found of a line that a limit applies to belongs to the line.
    if (limit == BridgeLimit::None && piece.distance < kOwnEdges * scale.edge) limit = ofLine;
    agreement.lengthBy[indexOf(limit)] += piece.length / scale.edge;
    if (limit != BridgeLimit::None) continue;
    heldLength += piece.length;
    if (piece.distance > scale.edge) stray += piece.length;
    held.push_back(piece);
  }
  agreement.strayShare = heldLength > 0.0 ? stray / heldLength : 0.0;
  agreement.medianEdges = distancePercentile(held, 0.5) / scale.edge;
  agreement.percentile95Edges = distancePercentile(held, 0.95) / scale.edge;

  std::vector<MeasuredPiece> back;
  double covered = 0.0;
  for (const Target& target : targets) {
    if (target.limit != BridgeLimit::None) continue;
    for (const Eigen::Vector3d& p : target.places) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Stretch& stretch : stretches) nearest = std::min(nearest, stretch.distance(p));
      back.push_back({p, 1.0, nearest});
      if (nearest <= scale.edge) covered += 1.0;
    }
  }
  agreement.lines = agreement.linesBy[indexOf(BridgeLimit::None)];
  agreement.coverage = back.empty() ? kNaN : covered / static_cast<double>(back.size());
  agreement.backMedianEdges = distancePercentile(back, 0.5) / scale.edge;
  agreement.backPercentile95Edges = distancePercentile(back, 0.95) / scale.edge;
  return agreement;
}

BridgeTrial drawnTrial(std::mt19937_64& engine) {
  std::vector<Vec2> points;
  for (int k = 0; k < kRandomPoints; ++k) {
    const double x = unitRandom(engine), y = unitRandom(engine);
    points.emplace_back(x, y);
  }
  const double up = 2.0 * unitRandom(engine) - 1.0,
               turn = 2.0 * std::numbers::pi * unitRandom(engine);
  const double out = std::sqrt(1.0 - up * up);
  const BSpline spline(kRandomDegree, false, points,
                       BSpline::uniformKnots(kRandomDegree, false, points.size()));
  BridgeTrial trial{{spline, SweptSurface::Kind::Extrusion, kTrialHeight},
                    {out * std::cos(turn), out * std::sin(turn), up},
                    {},
                    {},
                    0.0};
  trial.surface =
      turnedLike({trial.surface.curve}, trial.surface, {.towards = trial.towards, .eye = {}});
  return trial;
}

/// Why a trial may be further away than others.
void addCauses(const BridgePrediction& prediction, BridgeTrial& trial) {
  const BridgeScale scale{trial.row.edge, trial.row.size};
  LimitAhead& nearest = trial.ahead;
  for (const PredictedLine& line : prediction.lines()) {
    if (line.kind != MarkKind::ApparentRidge) continue;
    const LimitAhead ahead = prediction.limitAhead(line, scale);
    if (ahead.coarser == 1.0) continue;  // not held
    const double k = frameOf(jetAt(trial.surface.curve, line.t)).k;
    trial.gentlestEdges = std::max(trial.gentlestEdges, 1.0 / (std::abs(k) * scale.edge));
    if (ahead.limit == BridgeLimit::None) continue;
    if (nearest.limit == BridgeLimit::None || ahead.coarser < nearest.coarser) nearest = ahead;
  }
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return kNaN;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

BridgeRow compareLines(const BridgePrediction& prediction, const SweptMesh& swept,
                       const TriangleMesh& mesh, double size, const FeatureLines& found) {
  BridgeRow row;
  row.edge = meanEdge(mesh);
  row.size = size;
  const BridgeScale scale{row.edge, size};
  row.ridges = agreementOf(MarkKind::ApparentRidge, prediction, swept, mesh, scale,
                           found.of(LineFamily::ApparentRidges));
  row.contours = agreementOf(MarkKind::Silhouette, prediction, swept, mesh, scale,
                             found.of(LineFamily::OccludingContours));
  return row;
}

std::vector<BridgeSeries> measureBridge(const BridgePrediction& prediction,
                                        const BridgeOptions& options) {
  std::vector<BridgeSeries> all;
  if (!prediction.flat().view) return all;
  for (const FieldEstimator estimator : options.estimators) {
    for (const RidgeDerivative derivative : options.derivatives) {
      all.push_back({estimator, derivative, {}, {}});
    }
  }
  LineOptions lines = bridgeLines(options.threshold);
  double done = 0.0, work = 0.0;
  for (const int cells : options.cells) work += static_cast<double>(cells) * cells;
  for (const int cells : options.cells) {
    const SweptMesh swept = sweptMesh(prediction.surface(), cells);
    const BuiltMesh built = buildMesh(swept.soup);
    const double share =
        static_cast<double>(cells) * cells / static_cast<double>(options.estimators.size());
    for (std::size_t i = 0; i < all.size(); i += options.derivatives.size()) {
      const SurfaceFields fields = estimateFields(
          built.mesh,
          {.estimator = all[i].estimator, .threads = options.threads, .stop = options.stop});
      if (options.stop.stop_requested()) return {};
      LineFinder finder(built.mesh, fields);
      for (std::size_t k = i; k < i + options.derivatives.size(); ++k) {
        lines.derivative = all[k].derivative;
        const FeatureLines found = finder.find({.towards = prediction.towards(), .eye = {}}, lines);
        all[k].rows.push_back(
            compareLines(prediction, swept, built.mesh, fields.size * built.mesh.unit, found));
        all[k].rows.back().cells = cells;
      }
      done += share;
      if (options.progress) options.progress(done / work);
    }
  }
  for (BridgeSeries& series : all) series.order = orderOf(convergenceOf(series).rows);
  return all;
}

ConvergenceSeries convergenceOf(const BridgeSeries& series) {
  ConvergenceSeries all{series.estimator, series.derivative, {}, series.order};
  for (const BridgeRow& row : series.rows) {
    all.rows.push_back({.cells = row.cells,
                        .edge = row.edge,
                        .pieces = row.ridges.pieces,
                        .medianEdges = row.ridges.medianEdges,
                        .percentile95Edges = row.ridges.percentile95Edges,
                        .strayShare = row.ridges.strayShare,
                        .missedShare = 1.0 - row.ridges.coverage});
  }
  return all;
}

BridgeTrials measureRandomBridges(const BridgeTrialOptions& options) {
  constexpr std::size_t kMostDraws = 50;
  BridgeTrials result;
  std::mt19937_64 engine(options.seed);
  const BridgeOptions one{.cells = {options.cells},
                          .estimators = {options.estimator},
                          .derivatives = {options.derivative},
                          .threshold = options.threshold,
                          .threads = options.threads,
                          .progress = {},
                          .stop = options.stop};
  const auto count = static_cast<std::size_t>(std::max(options.count, 0));
  std::vector<double> medians, backs;
  double covered = 0.0;
  while (result.trials.size() < count && result.drawn < kMostDraws * count &&
         !options.stop.stop_requested()) {
    BridgeTrial trial = drawnTrial(engine);
    const BridgePrediction prediction(trial.surface, {.towards = trial.towards, .eye = {}});
    ++result.drawn;
    // What no mesh could show needs none.
    std::array<std::size_t, kBridgeLimitCount> linesBy{};
    for (const PredictedLine& line : prediction.lines()) {
      if (line.kind == MarkKind::ApparentRidge) ++linesBy[indexOf(prediction.limitOf(line, {}))];
    }
    if (linesBy[indexOf(BridgeLimit::None)] > 0) {
      const std::vector<BridgeSeries> series = measureBridge(prediction, one);
      if (series.empty()) break;  // stopped
      trial.row = series[0].rows[0];
      linesBy = trial.row.ridges.linesBy;
    }
    for (std::size_t k = 0; k < kBridgeLimitCount; ++k) result.linesBy[k] += linesBy[k];
    const LineAgreement& ridges = trial.row.ridges;
    if (ridges.lines == 0) continue;
    addCauses(prediction, trial);
    const double median = ridges.medianEdges;
    medians.push_back(std::isfinite(median) ? median : std::numeric_limits<double>::infinity());
    backs.push_back(ridges.backMedianEdges);
    if (median < BridgeTrials::kNearEdges) ++result.belowTenth;
    covered += ridges.coverage * static_cast<double>(ridges.lines);
    result.trials.push_back(std::move(trial));
    if (options.progress) {
      options.progress(static_cast<double>(result.trials.size()) / static_cast<double>(count));
    }
  }
  result.medianEdges = medianOf(std::move(medians));
  result.backMedianEdges = medianOf(std::move(backs));
  const std::size_t lines = result.linesBy[indexOf(BridgeLimit::None)];
  result.coverage = lines > 0 ? covered / static_cast<double>(lines) : kNaN;
  return result;
}

}  // namespace flatland
