// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of chapter 4 at points of solids. What they claim of D lambda is held against
// difference quotients on the solids themselves, whose formulas know nothing of K and C.
#include "core3d/study/surface_derivation.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "core3d/lines/vertex_terms.h"
#include "core3d/mesh/solids.h"
#include "tests/core3d/lines_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Step = SurfaceStep;

// Residuals are relative to what was added up, so a few roundings.
constexpr double kRounding = 2e-15;

std::vector<Step> allSteps() {
  std::vector<Step> steps;
  for (int i = 0; i < kSurfaceStepCount; ++i) steps.push_back(static_cast<Step>(i));
  return steps;
}

/// A place of a solid and two directions in which places near it lie.
struct SolidPlace {
  Solid solid;
  Vector3d place, first, second;

  SurfacePoint at(const Vector2d& q) const {
    return pointAt(solid, place + q.x() * first + q.y() * second);
  }
};

SolidPlace randomPlace(Random& random) {
  static const std::vector<Solid> kSolids{
      {SolidKind::Torus, 1.0, 0.4},          {SolidKind::Ellipsoid, 1.0, 0.8, 0.6},
      {SolidKind::SineSheet, 0.5, 2.0, 3.0}, {SolidKind::GaussianBump, 2.0, 4.0},
      {SolidKind::RoundedCube, 1.0},         {SolidKind::BumpySphere, 1.0, 0.1, 5.0}};
  const Solid& solid = kSolids[static_cast<std::size_t>(uniformInt(random, 0, 5))];
  const bool globe = solid.kind == SolidKind::Ellipsoid || solid.kind == SolidKind::RoundedCube ||
                     solid.kind == SolidKind::BumpySphere;
  if (!globe) {
    return {solid,
            {uniform(random, -2.0, 2.0), uniform(random, -2.0, 2.0), 0.0},
            Vector3d::UnitX(),
            Vector3d::UnitY()};
  }
  const Vector3d d = Vector3d(normal(random), normal(random), normal(random)).normalized();
  return {solid, d, d.unitOrthogonal(), d.cross(d.unitOrthogonal())};
}

/// In principal directions, larger curvature first: by a solver that is not the program's.
SurfacePoint principal(const SurfacePoint& point) {
  const Eigen::SelfAdjointEigenSolver<Matrix2d> solver(point.K);
  Matrix2d turn;
  turn.col(0) = solver.eigenvectors().col(1);
  turn.col(1) = Vector2d(-turn(1, 0), turn(0, 0));
  SurfacePoint turned = point;
  turned.frame = point.frame * turn;
  turned.K = Vector2d(solver.eigenvalues()[1], solver.eigenvalues()[0]).asDiagonal();
  const Vector2d a = turn.col(0), b = turn.col(1);
  turned.C.coefficients = {point.C(a, a, a), point.C(a, a, b), point.C(a, b, b), point.C(b, b, b)};
  return turned;
}

struct Viewer {
  Vector3d w;
  std::optional<double> distance;
};

SurfacePlace seenFrom(const SurfacePoint& point, const Viewer& viewer) {
  SurfacePlace place{principal(point), viewer.w, viewer.w.unitOrthogonal(), {}, viewer.distance};
  place.uy = place.w.cross(place.ux);
  return place;
}

/// A viewer before whom the place is not too near a silhouette.
Viewer randomViewer(Random& random, const Vector3d& n, bool perspective) {
  Viewer viewer;
  do {
    viewer.w = Vector3d(normal(random), normal(random), normal(random)).normalized();
  } while (std::abs(viewer.w.dot(n)) < 0.2);
  if (perspective) viewer.distance = uniform(random, 1.0, 4.0);
  return viewer;
}

/// lambda by its definition: the largest singular value of K P^-1, squared.
double lambdaOf(const SurfacePoint& point, const Vector3d& w) {
  const Vector3d ux = w.unitOrthogonal(), uy = w.cross(ux);
  Matrix2d p;
  p << ux.transpose() * point.frame, uy.transpose() * point.frame;
  const Matrix2d q = point.K * p.inverse();
  const double largest = Eigen::JacobiSVD<Matrix2d>(q).singularValues()[0];
  return largest * largest;
}

/// D_r lambda over the solid, by Richardson's extrapolation of symmetric differences. `fromEye`:
/// the lines of sight meet in the viewer.
double differenceQuotient(const SolidPlace& at, const Viewer& viewer, bool fromEye,
                          const Vector3d& r) {
  constexpr double kSlopeStep = 1e-6;
  Eigen::Matrix<double, 3, 2> j;
  for (int c = 0; c < 2; ++c) {
    const Vector2d step = kSlopeStep * Vector2d::Unit(c);
    j.col(c) = (at.at(step).p - at.at(-step).p) / (2.0 * kSlopeStep);
  }
  const Vector2d rate = j.colPivHouseholderQr().solve(r);
  const Vector3d eye = at.at({0, 0}).p + viewer.distance.value_or(0.0) * viewer.w;
  const auto lambdaAt = [&](double s) {
    const SurfacePoint point = at.at(s * rate);
    return lambdaOf(point, fromEye ? Vector3d((eye - point.p).normalized()) : viewer.w);
  };
  double table[4];
  double h = 4e-3 / std::max(rate.norm(), 1.0);
  for (int i = 0; i < 4; ++i, h *= 0.5) table[i] = (lambdaAt(h) - lambdaAt(-h)) / (2.0 * h);
  double power = 4.0;
  for (int level = 3; level > 0; --level, power *= 4.0) {
    for (int i = 0; i < level; ++i) table[i] = (power * table[i + 1] - table[i]) / (power - 1.0);
  }
  return table[0];
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

TEST(SurfaceDerivation, EveryStepHoldsAndEveryMisprintDoesNot) {
  Random random(announcedSeed("SurfaceDerivation.Steps", 31));
  std::map<Step, std::vector<double>> printed;
  for (int n = 0; n < 500; ++n) {
    const SolidPlace at = randomPlace(random);
    const SurfacePoint point = at.at({0, 0});
    const SurfacePlace place = seenFrom(point, randomViewer(random, point.n, n % 2 == 1));
    for (const Step step : allSteps()) {
      SCOPED_TRACE(textOf(step).id);
      const StepReading reading = readStep(step, place);
      ASSERT_EQ(reading.answer, StepAnswer::Evaluated);
      ASSERT_TRUE(reading.corrected);
      EXPECT_LT(reading.corrected->residual, kRounding) << at.solid.name();
      EXPECT_EQ(reading.printed.has_value(), textOf(step).isMisprinted());
      if (reading.printed) printed[step].push_back(reading.printed->apart);
    }
  }
  ASSERT_EQ(printed.size(), 3u);
  for (const auto& [step, apart] : printed) EXPECT_GT(medianOf(apart), 0.1) << textOf(step).id;
}

// Both sides of a step come from one K and C. That these are those of the surface, and that the
// graph stands for it, only the surface can tell.
TEST(SurfaceDerivation, TheSolidItselfAgrees) {
  Random random(announcedSeed("SurfaceDerivation.Solid", 32));
  std::vector<double> misprinted;
  int compared = 0;
  for (int n = 0; n < 400; ++n) {
    const SolidPlace at = randomPlace(random);
    const SurfacePoint point = at.at({0, 0});
    const Viewer viewer = randomViewer(random, point.n, true);
    const SurfacePlace place = seenFrom(point, viewer);
    const SurfaceMatrices m = surfaceMatrices(place);
    ASSERT_TRUE(m.seen);
    if (m.seen->relativeGap < 0.05) continue;  // the two eigenvalues meet within the step
    ++compared;
    EXPECT_NEAR(m.seen->lambda, lambdaOf(point, viewer.w), 1e-11 * m.seen->lambda);
    const Vector3d r = place.point.frame * m.seen->r;
    for (const bool fromEye : {false, true}) {
      SCOPED_TRACE(at.solid.name() + (fromEye ? ", perspective" : ""));
      const StepReading reading = readStep(fromEye ? Step::Perspective : Step::Terms, place);
      const double claimed = 2.0 * reading.corrected->right.entries[0];
      // What D lambda is made of gives the scale: it is small near an apparent ridge.
      const double scale = std::abs(m.seen->feature) + std::abs(m.seen->offset) + m.seen->lambda;
      EXPECT_NEAR(differenceQuotient(at, viewer, fromEye, r), claimed, 2e-6 * scale);
    }
    const StepReading thesis = readStep(Step::Eq4_8, place);
    const double found = differenceQuotient(at, viewer, false, r);
    const double scale = std::abs(found) + std::abs(thesis.printed->right.entries[0]);
    misprinted.push_back(std::abs(thesis.printed->right.entries[0] - found) / scale);
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(medianOf(misprinted), 0.1);
}

TEST(SurfaceDerivation, TheMatricesAreThoseOfTheDefinitions) {
  Random random(announcedSeed("SurfaceDerivation.Matrices", 33));
  for (int n = 0; n < 100; ++n) {
    const SurfacePoint point = randomPlace(random).at({0, 0});
    const SurfacePlace place = seenFrom(point, randomViewer(random, point.n, false));
    const SurfaceMatrices m = surfaceMatrices(place);
    ASSERT_TRUE(m.seen);
    EXPECT_NEAR(m.P.determinant(), m.nw, 1e-14);
    EXPECT_LT((m.inverseP * m.P - Matrix2d::Identity()).norm(), 1e-13);
    EXPECT_LT((m.QtQ * m.tA - m.seen->lambda * m.tA).norm(), 1e-12 * m.seen->lambda);
    EXPECT_NEAR(m.tA.norm(), 1.0, 1e-13);
    EXPECT_NEAR(m.QtQ.trace(), m.seen->lambda + m.otherLambda, 1e-12 * m.seen->lambda);
    EXPECT_NEAR(m.QtQ.determinant(), m.seen->lambda * m.otherLambda,
                1e-12 * m.seen->lambda * m.seen->lambda);
    EXPECT_NEAR(m.wT.squaredNorm() + m.nw * m.nw, 1.0, 1e-14);
  }
}

TEST(SurfaceDerivation, DifferenceQuotientsAreOfSecondOrder) {
  Random random(announcedSeed("SurfaceDerivation.Quotients", 34));
  for (const Step step : {Step::Eq4_5, Step::Eq4_6, Step::Footnote, Step::Eq4_7, Step::Eq4_8,
                          Step::Terms, Step::Perspective}) {
    SCOPED_TRACE(textOf(step).id);
    std::vector<double> best, orders, bestPrinted;
    for (int n = 0; n < 60; ++n) {
      const SurfacePoint point = randomPlace(random).at({0, 0});
      const SurfacePlace place = seenFrom(point, randomViewer(random, point.n, true));
      const auto sweep = stepSizeSweep(step, place);
      ASSERT_EQ(sweep.size(), 37u);
      const auto least = std::min_element(sweep.begin(), sweep.end(),
                                          [](const StepDifference& a, const StepDifference& b) {
                                            return a.corrected < b.corrected;
                                          });
      best.push_back(least->corrected);
      // A decade of steps, well before rounding.
      orders.push_back(std::log10(sweep[4].corrected / sweep[7].corrected));
      if (least->printed) bestPrinted.push_back(*least->printed);
    }
    EXPECT_LT(medianOf(best), 1e-9);
    EXPECT_NEAR(medianOf(orders), 2.0, 0.15);
    EXPECT_EQ(bestPrinted.empty(), !textOf(step).isMisprinted());
    if (!bestPrinted.empty()) {
      EXPECT_GT(medianOf(bestPrinted), 0.02);
    }
  }
  for (const Step step : {Step::View, Step::Lambda, Step::Eq4_4}) {
    const SurfacePoint point = randomPlace(random).at({0, 0});
    EXPECT_TRUE(stepSizeSweep(step, seenFrom(point, {point.n, {}})).empty());
  }
}

TEST(SurfaceDerivation, WhereThereIsNoAnswerItSaysSo) {
  const SurfacePoint tip = pointAt({SolidKind::Ellipsoid, 1.0, 0.8, 0.6}, {0.0, 0.6, 0.8});
  // Grazed: only what does not divide by n.w.
  const SurfacePlace grazed = seenFrom(tip, {tip.frame.col(0), {}});
  for (const Step step : allSteps()) {
    const StepReading reading = readStep(step, grazed);
    const bool needs = step >= Step::Inverse;
    EXPECT_EQ(reading.answer, needs ? StepAnswer::Silhouette : StepAnswer::Evaluated);
    EXPECT_EQ(reading.corrected.has_value(), !needs) << textOf(step).id;
  }
  EXPECT_FALSE(surfaceMatrices(grazed).seen);
  // A sphere seen head-on bends alike in all directions; seen from the side it does not, but it has
  // no principal directions, so that (4.7) and (4.8) cannot be evaluated as printed.
  const SurfacePoint ball = pointAt({SolidKind::Sphere, 1.0}, {0.0, 0.6, 0.8});
  for (const Step step : allSteps()) {
    const StepReading headOn = readStep(step, seenFrom(ball, {ball.n, {}}));
    EXPECT_EQ(headOn.answer, step > Step::Lambda ? StepAnswer::NoDirection : StepAnswer::Evaluated)
        << textOf(step).id;
    SurfacePlace oblique = seenFrom(ball, {Vector3d(0.3, 0.1, 1.0).normalized(), {}});
    oblique.point.K = Matrix2d::Identity();
    oblique.point.C = {};
    const StepReading side = readStep(step, oblique);
    EXPECT_EQ(side.answer, StepAnswer::Evaluated);
    EXPECT_LT(side.corrected->residual, kRounding) << textOf(step).id;
    EXPECT_EQ(side.printed.has_value(), step == Step::Footnote);
  }
  // A plane: lambda is 0 and has no direction.
  SurfacePlace plane = grazed;
  plane.w = (plane.point.n + plane.ux).normalized();
  plane.ux = plane.w.unitOrthogonal();
  plane.uy = plane.w.cross(plane.ux);
  plane.point.K.setZero();
  plane.point.C = {};
  const StepReading flat = readStep(Step::Lambda, plane);
  ASSERT_TRUE(flat.corrected);
  EXPECT_EQ(flat.corrected->left.entries[0], 0.0);
  EXPECT_EQ(flat.corrected->right.entries[0], 0.0);
  EXPECT_EQ(readStep(Step::Terms, plane).answer, StepAnswer::NoDirection);
}

// The vertex of a mesh is that place: its terms are the numbers of the probe.
TEST(SurfaceDerivation, AtAVertexItAgreesWithTheProbe) {
  const SolidModel model = modelOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {.cells = 30});
  SurfaceView view{.towards = Vector3d(0.3, -0.2, 1.0).normalized(), .eye = {}};
  for (const bool perspective : {false, true}) {
    if (perspective) view.eye = 3.0 * view.towards;
    int compared = 0;
    for (std::uint32_t v = 0; v < model.mesh.vertexCount(); v += 29) {
      const auto terms = termsAt(model.mesh, model.fields, view, v);
      const auto place = surfacePlaceAt(model.mesh, model.fields, view, Vector3d::UnitX(), v);
      ASSERT_TRUE(terms && place);
      if (std::abs(terms->nw) < 0.2) continue;
      ++compared;
      const SurfaceMatrices m = surfaceMatrices(*place);
      // The frame here is orthonormal to rounding, there to that of float.
      const double scale = std::abs(terms->feature) + std::abs(terms->offset) + *terms->lambda;
      EXPECT_NEAR(m.seen->lambda, *terms->lambda, 1e-5 * *terms->lambda);
      EXPECT_NEAR(std::abs(m.seen->feature), std::abs(terms->feature), 1e-4 * scale);
      EXPECT_NEAR(std::abs(m.seen->sum()),
                  std::abs(terms->feature + terms->offset + terms->perspective), 1e-4 * scale);
      EXPECT_EQ(place->distance.has_value(), perspective);
      EXPECT_LT((place->point.frame.transpose() * place->point.frame - Matrix2d::Identity()).norm(),
                1e-14);
      EXPECT_NEAR(place->ux.dot(place->w), 0.0, 1e-15);
      EXPECT_LT((place->ux.cross(place->uy) - place->w).norm(), 1e-14);
    }
    EXPECT_GT(compared, 100);
  }
}

TEST(SurfaceDerivation, StepsHaveTheirNames) {
  for (const Step step : allSteps()) {
    EXPECT_EQ(surfaceStepNamed(textOf(step).id), step);
    EXPECT_FALSE(textOf(step).title.empty());
  }
  EXPECT_FALSE(surfaceStepNamed("3.13"));
}

}  // namespace
}  // namespace flatland::test
