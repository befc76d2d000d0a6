// SPDX-License-Identifier: GPL-3.0-or-later
// The bridge from flatland to surfaces: what is predicted is exactly an apparent ridge of the
// surface (by the 3D equation, which the prediction does not use), and what is found on meshes is
// near it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core3d/mesh/build_mesh.h"
#include "core3d/study/bridge.h"
#include "flatland/curve/bspline.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

Curve randomCurve(Random& random, double left) {
  std::vector<Vec2> points;
  for (int i = 0; i < 6; ++i)
    points.emplace_back(left + 0.5 * i + uniform(random, -0.2, 0.2), uniform(random, -1, 1));
  return BezierChain(5, false, points);
}

Eigen::Vector3d randomDirection(Random& random) {
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

// Across t the derivative of lambda along the curve changes from growing to falling, and at t
// itself the sum of the terms is 0 to rounding.
void expectMaximum(const BridgePrediction& prediction, const PredictedLine& line) {
  const SweptSurface& s = prediction.surface();
  const auto seenAt = [&](double t) {
    const SurfacePoint point = s.kind == SweptSurface::Kind::Extrusion
                                   ? extrudedPoint(s.curve, t, 0.3)
                                   : revolvedPoint(s.curve, s.amount, t, 0.7);
    return *apparentCurvature(seenFrom(point, prediction.towards()));
  };
  const auto seen = seenAt(line.t);
  EXPECT_NEAR(seen.lambda, line.lambda, 1e-9 * line.lambda);
  EXPECT_NEAR(seen.sum(), 0.0, 1e-8 * (std::abs(seen.feature) + std::abs(seen.offset)));
  constexpr double kStep = 1e-5;
  EXPECT_GE(seen.lambda, seenAt(line.t - kStep).lambda);
  EXPECT_GE(seen.lambda, seenAt(line.t + kStep).lambda);
}

TEST(BridgePrediction, RulingsOfExtrusionsAreMaximaOfTheSurface) {
  Random random(announcedSeed("rulings", 61));
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const SweptSurface surface{randomCurve(random, 0.0), SweptSurface::Kind::Extrusion, 2.0};
    const BridgePrediction prediction(surface, {.towards = randomDirection(random), .eye = {}});
    ASSERT_TRUE(prediction.flat().view);
    for (const PredictedLine& line : prediction.lines()) {
      if (line.kind == MarkKind::Silhouette) {
        EXPECT_NEAR(line.facing, 0.0, 1e-9);
        continue;
      }
      if (line.t < 1e-3 || line.t > 1 - 1e-3 || std::abs(line.facing) < 1e-2) continue;
      expectMaximum(prediction, line);
      ++checked;
    }
  }
  EXPECT_GT(checked, 30);
}

TEST(BridgePrediction, CirclesOfRevolutionsAreMaximaWhereTheMeridianWins) {
  Random random(announcedSeed("circles", 62));
  int checked = 0, lost = 0;
  for (int i = 0; i < 300; ++i) {
    const double axis = i % 3 ? 0.2 : -0.6;
    const SweptSurface surface{randomCurve(random, 0.7), SweptSurface::Kind::Revolution, axis};
    const Eigen::Vector3d w(0.0, i % 2 ? 1.0 : -1.0, 0.0);
    const BridgePrediction prediction(surface, {.towards = w, .eye = {}});
    for (const PredictedLine& line : prediction.lines()) {
      if (line.kind != MarkKind::ApparentRidge) continue;
      if (line.t < 1e-3 || line.t > 1 - 1e-3 || std::abs(line.facing) < 1e-2) continue;
      const BridgeLimit limit = prediction.limitOf(line, {});
      if (limit == BridgeLimit::FacesAway) continue;
      const SurfacePoint point = revolvedPoint(surface.curve, axis, line.t, 0.0);
      const double parallel = std::pow(point.n.x() / (point.p.x() - axis), 2);
      EXPECT_EQ(limit == BridgeLimit::ParallelWins, line.lambda < 1.2 * parallel);
      for (const Eigen::Vector3d& p : line.points) {
        EXPECT_NEAR(std::hypot(p.x() - axis, p.z()), point.p.x() - axis, 1e-9);
        EXPECT_NEAR(prediction.distance(line, p), 0.0, 1e-9);
      }
      if (limit == BridgeLimit::ParallelWins) ++lost;
      if (limit != BridgeLimit::None) continue;
      expectMaximum(prediction, line);
      ++checked;
    }
  }
  EXPECT_GT(checked, 15);
  EXPECT_GT(lost, 2);
}

TEST(BridgePrediction, SaysWhenThereIsNoFlatView) {
  const Curve curve = BezierChain(2, false, {{0.5, 0}, {1, 1}, {2, 0}});
  const SweptSurface extruded{curve, SweptSurface::Kind::Extrusion, 1.0};
  const SweptSurface revolved{curve, SweptSurface::Kind::Revolution, 0.0};
  EXPECT_FALSE(flatViewOf(extruded, {.towards = Eigen::Vector3d::UnitZ(), .eye = {}}).view);
  EXPECT_FALSE(flatViewOf(revolved, {.towards = Eigen::Vector3d::UnitX(), .eye = {}}).view);
  EXPECT_FALSE(
      flatViewOf(extruded, {.towards = Eigen::Vector3d::UnitY(), .eye = Eigen::Vector3d(0, 9, 0)})
          .view);
  const FlatView none = flatViewOf(revolved, {.towards = Eigen::Vector3d::UnitX(), .eye = {}});
  EXPECT_FALSE(none.whyNot.empty());
  EXPECT_TRUE(
      BridgePrediction(revolved, {.towards = Eigen::Vector3d::UnitX(), .eye = {}}).lines().empty());
  EXPECT_DOUBLE_EQ(
      flatViewOf(extruded, {.towards = Eigen::Vector3d(0, 1, 5).normalized(), .eye = {}})
          .view->angleDeg,
      90.0);
  EXPECT_EQ(flatViewOf(revolved, {.towards = Eigen::Vector3d(0, 3, 0), .eye = {}}).view->angleDeg,
            90.0);
  EXPECT_EQ(flatViewOf(revolved, {.towards = Eigen::Vector3d(0, -3, 0), .eye = {}}).view->angleDeg,
            -90.0);
}

TEST(BridgePrediction, NamesWhatCannotHold) {
  const auto predicted = [](std::vector<Vec2> points, int degree, const Eigen::Vector3d& w) {
    return BridgePrediction(
        {BezierChain(degree, false, std::move(points)), SweptSurface::Kind::Extrusion, 1.0},
        {.towards = w.normalized(), .eye = {}});
  };
  // A parabola seen along its axis has its ridge in the middle; from below it faces away.
  const std::vector<Vec2> parabola = {{-1, 0}, {0, 2}, {1, 0}};
  const BridgePrediction above = predicted(parabola, 2, {0, 1, 0.3});
  ASSERT_EQ(above.lines().size(), 1u);
  const PredictedLine& crest = above.lines()[0];
  EXPECT_NEAR(crest.t, 0.5, 1e-12);
  EXPECT_EQ(above.limitOf(crest, {}), BridgeLimit::None);
  // No silhouette is anywhere, and the radius of curvature is 0.5.
  EXPECT_EQ(above.limitOf(crest, {.edge = 0.2, .size = 0.0}), BridgeLimit::SharpBend);
  EXPECT_EQ(above.limitOf(crest, {.edge = 0.5, .size = 0.0}), BridgeLimit::End);
  // On edges of 0.1 the bend is too sharp from 1.25 times as long ones on.
  const LimitAhead ahead = above.limitAhead(crest, {.edge = 0.1, .size = 0.0});
  EXPECT_EQ(ahead.limit, BridgeLimit::SharpBend);
  EXPECT_GE(ahead.coarser, 1.25);
  EXPECT_LE(ahead.coarser, 1.25 * 1.1);
  EXPECT_EQ(above.limitAhead(crest, {.edge = 0.2, .size = 0.0}).coarser, 1.0);
  EXPECT_EQ(above.limitAhead(crest, {.edge = 0.01, .size = 0.0}).limit, BridgeLimit::None);
  EXPECT_EQ(above.limitAhead(crest, {.edge = 0.01, .size = 0.0}).coarser, 0.0);
  const BridgePrediction below = predicted(parabola, 2, {0, -1, 0.3});
  ASSERT_EQ(below.lines().size(), 1u);
  EXPECT_EQ(below.limitOf(below.lines()[0], {}), BridgeLimit::FacesAway);
  // Two arcs that meet with one tangent but not with one curvature.
  const BridgePrediction joined =
      predicted({{-1, 0}, {-0.5, 0.5}, {0, 0.5}, {0.8, 0.5}, {1, 0.2}}, 2, {0, 1, 0});
  EXPECT_EQ(joined.limitAt(MarkKind::ApparentRidge, 1.0, {}), BridgeLimit::Crease);
  EXPECT_EQ(joined.limitAt(MarkKind::ApparentRidge, 0.5, {}), BridgeLimit::None);
  for (std::size_t i = 0; i < kBridgeLimitCount; ++i) {
    EXPECT_FALSE(reasonOf(static_cast<BridgeLimit>(i)).empty());
  }
}

TEST(BridgePrediction, RidgesNearASilhouetteAreNotHeld) {
  // y = 1 - x^2 from the side: n.w = 2x / sqrt(1 + 4x^2).
  const BridgePrediction side(
      {BezierChain(2, false, {{-1, 0}, {0, 2}, {1, 0}}), SweptSurface::Kind::Extrusion, 1.0},
      {.towards = Eigen::Vector3d::UnitX(), .eye = {}});
  EXPECT_EQ(side.limitAt(MarkKind::ApparentRidge, 0.495, {}), BridgeLimit::FacesAway);
  EXPECT_EQ(side.limitAt(MarkKind::ApparentRidge, 0.505, {}), BridgeLimit::SilhouetteNear);
  EXPECT_EQ(side.limitAt(MarkKind::ApparentRidge, 0.525, {}), BridgeLimit::None);
}

TEST(BridgePrediction, WhatIsNearIsKnownFromTheCurveAndNotGuessedFromItsCurvature) {
  // y = x - 100 x^3 / 3 turns back at x = 0.1 and -0.1, and is straight at 0 where it is looked at.
  const auto seen = [](const Eigen::Vector3d& w) {
    return BridgePrediction({BezierChain(3, false,
                                         {{-0.2, 1.0 / 15.0},
                                          {-0.2 / 3.0, -1.0 / 3.0},
                                          {0.2 / 3.0, 1.0 / 3.0},
                                          {0.2, -1.0 / 15.0}}),
                             SweptSurface::Kind::Extrusion, 1.0},
                            {.towards = w, .eye = {}});
  };
  const auto limit = [](const BridgePrediction& prediction, double edge) {
    return prediction.limitAt(MarkKind::ApparentRidge, 0.5, {.edge = edge, .size = 0.0});
  };
  // The places are 0.12 away: within four edges of 0.04, not of 0.02.
  const BridgePrediction side = seen(-Eigen::Vector3d::UnitX());
  EXPECT_EQ(limit(side, 0.02), BridgeLimit::None);
  EXPECT_EQ(limit(side, 0.04), BridgeLimit::SilhouetteNear);
  const BridgePrediction above = seen(Eigen::Vector3d::UnitY());
  EXPECT_EQ(limit(above, 0.02), BridgeLimit::None);
  EXPECT_EQ(limit(above, 0.04), BridgeLimit::SharpBend);
}

TEST(BridgePrediction, SilhouettesWithoutAMarkAreNearToo) {
  // A straight piece seen end-on, which two others meet with k = 0: all of it is a silhouette.
  std::vector<Vec2> points = {{-1, 0}};
  for (int i = 0; i <= 7; ++i) points.emplace_back(0.0, 0.5 * i);
  points.emplace_back(1, 3.5);
  const BridgePrediction seen({BezierChain(3, false, points), SweptSurface::Kind::Extrusion, 1.0},
                              {.towards = Eigen::Vector3d::UnitY(), .eye = {}});
  const auto limit = [&](double edge) {
    return seen.limitAt(MarkKind::ApparentRidge, 0.8, {.edge = edge, .size = 0.0});
  };
  // 0.3 before it.
  EXPECT_EQ(limit(0.07), BridgeLimit::None);
  EXPECT_EQ(limit(0.08), BridgeLimit::SilhouetteNear);
}

TEST(Bridge, PiecesAreJudgedByTheirPlaceOnTheCurve) {
  // Near a circle, from above: it faces away beyond t = 2, up to the seam.
  std::vector<Vec2> points;
  for (int i = 0; i < 12; ++i) {
    const double angle = std::acos(-1.0) / 6.0 * i, radius = i % 3 == 0 ? 1.0 : 1.14;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const BridgePrediction prediction(
      {BezierChain(3, true, points), SweptSurface::Kind::Extrusion, 2.0},
      {.towards = Eigen::Vector3d(0.15, 1.0, 0.0).normalized(), .eye = {}});
  const SweptMesh swept = sweptMesh(prediction.surface(), 12);
  const TriangleMesh mesh = buildMesh(swept.soup).mesh;
  FeatureLines found;
  double away = 0.0, total = 0.0;
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f) {
    const auto& corners = mesh.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const double shares[] = {0.7, 0.2, 0.1};
      Eigen::Vector3f at = Eigen::Vector3f::Zero();
      double t = 0.0, highest = 0.0;
      for (const std::uint32_t v : corners)
        highest = std::max(highest, swept.parameters[mesh.fileVertex[v]]);
      for (std::size_t j = 0; j < 3; ++j) {
        const std::uint32_t v = corners[(k + j) % 3];
        const double own = swept.parameters[mesh.fileVertex[v]];
        at += static_cast<float>(shares[j]) * mesh.position(v);
        t += shares[j] * (highest - own > 2.0 ? own + 4.0 : own);
      }
      const Eigen::Vector3f way(0.0f, 0.0f, 1e-3f);
      found.of(LineFamily::ApparentRidges)
          .push_back({{at - way, 1.0f, {}}, {at + way, 1.0f, {}}, f});
      total += 1.0;
      const BridgeLimit limit =
          prediction.limitAt(MarkKind::ApparentRidge, t > 4.0 ? t - 4.0 : t, {});
      if (limit == BridgeLimit::FacesAway) away += 1.0;
    }
  }
  const BridgeRow row = compareLines(prediction, swept, mesh, 1.0, found);
  double all = 0.0;
  for (const double length : row.ridges.lengthBy) all += length;
  EXPECT_NEAR(row.ridges.lengthBy[static_cast<std::size_t>(BridgeLimit::FacesAway)] / all,
              away / total, 1e-4);
}

TEST(Bridge, ComesNearerWithFinerMeshes) {
  const Curve curve = BezierChain(4, false, {{-2, 0}, {-1, 0.2}, {0, 2}, {1, 0.3}, {2, 0}});
  const BridgePrediction prediction(
      {curve, SweptSurface::Kind::Extrusion, 1.0},
      {.towards = Eigen::Vector3d(0.2, 1, 0.6).normalized(), .eye = {}});
  const auto all = measureBridge(
      prediction, {.cells = {32, 64, 128}, .derivatives = {RidgeDerivative::ClosedForm}});
  ASSERT_EQ(all.size(), 2u);
  ASSERT_EQ(all[0].rows.size(), 3u);
  const LineAgreement& finest = all[0].rows[2].ridges;
  EXPECT_GE(finest.lines, 1u);
  EXPECT_LT(finest.medianEdges, 0.1);
  EXPECT_LT(finest.backMedianEdges, 0.1);
  EXPECT_GT(finest.coverage, 0.99);
  ASSERT_TRUE(all[0].order);
  EXPECT_GT(*all[0].order, 1.5);
}

TEST(Bridge, FindsContoursOfRevolutionsAtTheProfilesSilhouettes) {
  const Curve curve = BezierChain(3, false, {{1, -1}, {2.5, -0.5}, {2.5, 0.8}, {1, 1}});
  const BridgePrediction prediction({curve, SweptSurface::Kind::Revolution, 0.0},
                                    {.towards = Eigen::Vector3d::UnitY(), .eye = {}});
  const auto all = measureBridge(prediction, {.cells = {64},
                                              .estimators = {FieldEstimator::JetFit},
                                              .derivatives = {RidgeDerivative::ClosedForm}});
  const LineAgreement& contours = all.at(0).rows.at(0).contours;
  EXPECT_EQ(contours.lines, 1u);
  EXPECT_LT(contours.medianEdges, 0.05);
  EXPECT_GT(contours.coverage, 0.99);
}

void expectNear(const BridgeTrials& trials, int count) {
  ASSERT_EQ(trials.trials.size(), static_cast<std::size_t>(count));
  EXPECT_LT(trials.medianEdges, 0.1);
  EXPECT_LT(trials.backMedianEdges, 0.1);
  EXPECT_GT(trials.coverage, 0.9);
  EXPECT_GT(trials.belowTenth, trials.trials.size() / 2);
  // Every predicted line is held or counted by what is in its way.
  std::size_t lines = 0;
  for (const BridgeTrial& trial : trials.trials) lines += trial.row.ridges.lines;
  EXPECT_EQ(lines, trials.linesBy[0]);
  // Every one that is not near has its cause: a limit close by, or a bend that is hardly one.
  constexpr double kGentleEdges = 40.0;
  for (const BridgeTrial& trial : trials.trials) {
    if (trial.row.ridges.medianEdges < BridgeTrials::kNearEdges) continue;
    EXPECT_TRUE(trial.ahead.limit != BridgeLimit::None || trial.gentlestEdges > kGentleEdges);
    EXPECT_NE(trial.ahead.coarser, 1.0);
  }
  EXPECT_GT(trials.linesBy[static_cast<std::size_t>(BridgeLimit::SilhouetteNear)], 0u);
}

TEST(Bridge, RandomExtrusionsFromRandomDirections) {
  const std::uint64_t seed = announcedSeed("bridges", 1);
  expectNear(measureRandomBridges({.count = 8, .seed = seed}), 8);
}

// One of a hundred; label slow.
TEST(ManyBridges, AHundredRandomExtrusionsFromRandomDirections) {
  const std::uint64_t seed = announcedSeed("hundred bridges", 1);
  expectNear(measureRandomBridges({.count = 100, .seed = seed}), 100);
}

}  // namespace
}  // namespace flatland::test
