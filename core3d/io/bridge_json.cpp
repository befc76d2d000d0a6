// SPDX-License-Identifier: MIT
#include "core3d/io/bridge_json.h"

#include <nlohmann/json.hpp>

namespace flatland {

namespace {

using nlohmann::ordered_json;

ordered_json vectorJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

template <typename Number>
ordered_json byLimit(const std::array<Number, kBridgeLimitCount>& by) {
  ordered_json object = ordered_json::object();
  for (std::size_t i = 0; i < kBridgeLimitCount; ++i)
    object[std::string(nameOf(static_cast<BridgeLimit>(i)))] = by[i];
  return object;
}

// Not a number is null: the library writes it so.
ordered_json agreementJson(const LineAgreement& a) {
  return {{"pieces", a.pieces},
          {"medianEdges", a.medianEdges},
          {"percentile95Edges", a.percentile95Edges},
          {"strayShare", a.strayShare},
          {"lines", a.lines},
          {"backMedianEdges", a.backMedianEdges},
          {"backPercentile95Edges", a.backPercentile95Edges},
          {"coverage", a.coverage},
          {"lengthBy", byLimit(a.lengthBy)},
          {"linesBy", byLimit(a.linesBy)}};
}

ordered_json rowJson(const BridgeRow& row) {
  return {{"cells", row.cells},
          {"edge", row.edge},
          {"ridges", agreementJson(row.ridges)},
          {"contours", agreementJson(row.contours)}};
}

}  // namespace

std::string bridgeJson(const BridgePrediction& prediction, const std::vector<BridgeSeries>& all) {
  const SweptSurface& surface = prediction.surface();
  const bool extruded = surface.kind == SweptSurface::Kind::Extrusion;
  ordered_json root{{"flatland", 1},
                    {"surface", extruded ? "extrusion" : "revolution"},
                    {extruded ? "height" : "axis", surface.amount},
                    {"towards", vectorJson(prediction.towards())},
                    {"viewAngleDeg", prediction.flat().view->angleDeg},
                    {"predicted", ordered_json::array()},
                    {"series", ordered_json::array()}};
  for (const PredictedLine& line : prediction.lines()) {
    ordered_json points = ordered_json::array();
    for (const Eigen::Vector3d& p : line.points) points.push_back(vectorJson(p));
    root["predicted"].push_back({{"kind", nameOf(line.kind)},
                                 {"t", line.t},
                                 {"point", {line.mark.x(), line.mark.y()}},
                                 {"facing", line.facing},
                                 {"lambda", line.lambda},
                                 {"limit", nameOf(prediction.limitOf(line, {}))},
                                 {"closed", line.closed},
                                 {"points", std::move(points)}});
  }
  for (const BridgeSeries& series : all) {
    ordered_json rows = ordered_json::array();
    for (const BridgeRow& row : series.rows) rows.push_back(rowJson(row));
    root["series"].push_back({{"estimator", nameOf(series.estimator)},
                              {"derivative", nameOf(series.derivative)},
                              {"order", series.order ? ordered_json(*series.order) : nullptr},
                              {"rows", std::move(rows)}});
  }
  return root.dump(1) + "\n";
}

std::string bridgeJson(const BridgeTrials& trials, const BridgeTrialOptions& options) {
  ordered_json root{{"flatland", 1},
                    {"seed", options.seed},
                    {"cells", options.cells},
                    {"estimator", nameOf(options.estimator)},
                    {"derivative", nameOf(options.derivative)},
                    {"threshold", options.threshold},
                    {"drawn", trials.drawn},
                    {"medianEdges", trials.medianEdges},
                    {"backMedianEdges", trials.backMedianEdges},
                    {"belowTenth", trials.belowTenth},
                    {"coverage", trials.coverage},
                    {"linesBy", byLimit(trials.linesBy)},
                    {"trials", ordered_json::array()}};
  for (const BridgeTrial& trial : trials.trials) {
    ordered_json points = ordered_json::array();
    for (const Vec2& p : controlPoints(trial.surface.curve)) points.push_back({p.x(), p.y()});
    ordered_json one = rowJson(trial.row);
    one["ahead"] = {{"limit", nameOf(trial.ahead.limit)}, {"coarser", trial.ahead.coarser}};
    one["gentlestEdges"] = trial.gentlestEdges;
    one["towards"] = vectorJson(trial.towards);
    one["points"] = std::move(points);
    root["trials"].push_back(std::move(one));
  }
  return root.dump(1) + "\n";
}

}  // namespace flatland
