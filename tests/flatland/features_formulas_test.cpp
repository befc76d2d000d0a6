// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of curves given by formulas, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flatland/curve/curve_editing.h"
#include "flatland/features/features.h"
#include "flatland/features/terms.h"
#include "flatland/screen/sweep.h"
#include "flatland/screen/visibility.h"
#include "tests/support/found_marks.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

// Roots are good to the last bits of t; the closed forms are given to 12 or 13 digits.
constexpr double kPlace = 2e-12;

Curve family(const std::string& name, const std::vector<double>& parameters) {
  FormulaCurve::Result made = FormulaCurve::make(FamilyCurve{familyNamed(name)->id, parameters});
  EXPECT_TRUE(made.curve) << made.error.reason;
  return *made.curve;
}

Curve typed(const std::string& x, const std::string& y, const std::string& from,
            const std::string& to) {
  FormulaCurve::Result made = FormulaCurve::make(TypedFormula{x, y, from, to, {}});
  EXPECT_TRUE(made.curve) << made.error.reason;
  return *made.curve;
}

TEST(FormulaMarks, CircleHasNoRidgesButAStatedConstantCurvature) {
  for (const double radius : {1.0, 2.5}) {
    for (const double angle : {90.0, 0.0, 37.0, -120.0}) {
      const FeatureSet found = findFeatures(sceneOf(family("circle", {radius}), angle));
      EXPECT_TRUE(found.complete()) << said(found);
      EXPECT_FALSE(found.certified());
      EXPECT_GT(found.errorBound(), 0.0);
      EXPECT_LT(found.errorBound(), 1e-12);
      ASSERT_EQ(found.degenerate.size(), 1u);
      EXPECT_EQ(found.degenerate[0].what, Degenerate::What::ConstantCurvature);
      EXPECT_TRUE(marksOf(found, {MarkKind::Ridge, MarkKind::Valley, MarkKind::Flat,
                                  MarkKind::ApparentRidge, MarkKind::Inflection, MarkKind::Corner})
                      .empty())
          << said(found);
      const auto silhouettes = marksOf(found, {MarkKind::Silhouette});
      ASSERT_EQ(silhouettes.size(), 2u) << angle << said(found);
      const Vec2 w = frameOf(View{.angleDeg = angle, .distance = {}}).towards;
      for (const Mark& mark : silhouettes) EXPECT_NEAR(mark.point.dot(w), 0.0, 1e-14 * radius);
      // One minimum facing the viewer, one behind.
      const auto minima = marksOf(found, {MarkKind::ApparentMinimum});
      ASSERT_EQ(minima.size(), 2u) << angle << said(found);
      for (const Mark& mark : minima) {
        EXPECT_NEAR(std::abs(mark.point.dot(w)), radius, 1e-13);
        EXPECT_NEAR(*mark.lambda, 1 / (radius * radius), 1e-12);
        EXPECT_EQ(mark.visible, mark.point.dot(w) > 0.0);
      }
    }
  }
}

TEST(FormulaMarks, EllipseTipIsAnApparentRidgeBeyondItsBifurcation) {
  const double critical = std::sqrt(1.5);
  for (const double ratio :
       {0.6, critical * 0.99, critical * 0.9999, critical * 1.0001, critical * 1.01, 1.5, 2.4}) {
    const FeatureSet found = findFeatures(sceneOf(family("ellipse", {1.0, ratio}), 90.0));
    EXPECT_TRUE(found.complete()) << ratio << " " << said(found);
    const auto ridges = marksOf(found, {MarkKind::ApparentRidge});
    const auto minima = marksOf(found, {MarkKind::ApparentMinimum});
    EXPECT_EQ(marksOf(found, {MarkKind::Silhouette}).size(), 2u);
    EXPECT_EQ(marksOf(found, {MarkKind::Ridge}).size(), 2u);
    EXPECT_EQ(marksOf(found, {MarkKind::Flat}).size(), 2u);
    if (ratio < critical) {
      EXPECT_EQ(ridges.size(), 0u) << ratio;
      ASSERT_EQ(minima.size(), 2u) << ratio << said(found);
      for (const Mark& minimum : minima) {
        EXPECT_NEAR(minimum.point.x(), 0.0, 1e-14 / (critical - ratio));
      }
    } else {
      ASSERT_EQ(ridges.size(), 2u) << ratio << said(found);
      for (const Mark& ridge : ridges) EXPECT_NEAR(ridge.point.x(), 0.0, 1e-13);
      ASSERT_EQ(minima.size(), 4u) << ratio << said(found);
      const double sinSq = ratio * ratio / (3.0 * (ratio * ratio - 1.0));
      for (const Mark& minimum : minima) {
        EXPECT_NEAR(std::abs(minimum.point.x()), std::sqrt(1.0 - sinSq), kPlace) << ratio;
      }
    }
  }
}

TEST(FormulaMarks, GaussianBump) {
  const double places[][3] = {{1.0, 1.8294353933636, 1.8738477201948},
                              {2.0, 2.004241986613, 2.0977024939058},
                              {0.5, 1.7595430126626, 1.7730636181997}};
  for (const auto& [height, apparent, ridge] : places) {
    // Out to where the bump is 2e-22 high.
    const FeatureSet found = findFeatures(sceneOf(family("gaussian", {height, 1.0, 10.0}), 90.0));
    EXPECT_TRUE(found.complete()) << said(found);
    std::vector<double> outer;
    for (const Mark& mark : marksOf(found, {MarkKind::ApparentRidge})) {
      if (mark.point.x() > 1.0) outer.push_back(mark.point.x());
    }
    ASSERT_EQ(outer.size(), 1u) << said(found);
    EXPECT_NEAR(outer[0], apparent, kPlace);
    std::vector<double> valleys;
    for (const Mark& mark : marksOf(found, {MarkKind::Valley})) {
      if (mark.point.x() > 1.0) valleys.push_back(mark.point.x());
    }
    ASSERT_EQ(valleys.size(), 1u) << said(found);
    EXPECT_NEAR(valleys[0], ridge, kPlace);
    const auto inflections = marksOf(found, {MarkKind::Inflection});
    ASSERT_EQ(inflections.size(), 2u) << said(found);
    EXPECT_NEAR(std::abs(inflections[0].point.x()), 1.0, 1e-14);
    EXPECT_NEAR(std::abs(inflections[1].point.x()), 1.0, 1e-14);
  }
}

TEST(FormulaMarks, SineSeenObliquely) {
  const double places[][2] = {{15, 0.739422981666}, {30, 0.67229729362}, {40, 0.534538108401}};
  for (const auto& [obliqueDeg, x] : places) {
    const FeatureSet found =
        findFeatures(sceneOf(family("sine", {0.5, 2.0, 3.0}), 90.0 - obliqueDeg));
    EXPECT_TRUE(found.complete()) << said(found);
    std::vector<double> near;
    for (const Mark& mark : marksOf(found, {MarkKind::ApparentRidge})) {
      if (std::abs(mark.point.x() - kPi / 4) < 0.4) near.push_back(mark.point.x());
    }
    ASSERT_EQ(near.size(), 1u) << obliqueDeg << said(found);
    EXPECT_NEAR(near[0], x, kPlace);
    // Crests and troughs do not move: cos 2x = 0.
    for (const Mark& mark : marksOf(found, {MarkKind::Ridge, MarkKind::Valley})) {
      EXPECT_NEAR(std::cos(2.0 * mark.point.x()), 0.0, 1e-13);
    }
  }
}

TEST(FormulaMarks, ParabolaLosesItsApparentRidgeAt30Degrees) {
  for (const double lean : {0.0, 20.0, 29.9, 30.1, 45.0}) {
    const FeatureSet found = findFeatures(sceneOf(family("parabola", {1.0, 4.0}), 90.0 - lean));
    EXPECT_TRUE(found.complete()) << said(found);
    EXPECT_EQ(marksOf(found, {MarkKind::ApparentRidge}).size(), lean < 30.0 ? 1u : 0u)
        << lean << said(found);
    const auto extrema = marksOf(found, {MarkKind::Ridge, MarkKind::Valley});
    ASSERT_EQ(extrema.size(), 1u);
    EXPECT_NEAR(extrema[0].point.x(), 0.0, 1e-15);
  }
}

// Any graph, any view: (f''' W - 3 f' f''^2)(w_y - f' w_x) + f''^2 (w_x + f' w_y) = 0.
TEST(FormulaMarks, GraphsObeyTheObliqueEquation) {
  std::size_t total = 0;
  for (const double lean : {-50.0, -20.0, 0.0, 35.0}) {
    const FeatureSet found =
        findFeatures(sceneOf(typed("t", "sin(3*t)*exp(-t/3)", "-1", "2"), 90.0 - lean));
    EXPECT_TRUE(found.complete()) << said(found);
    const auto marks = marksOf(found, {MarkKind::ApparentRidge, MarkKind::ApparentMinimum});
    total += marks.size();
    const double p = lean * kPi / 180.0, wx = std::sin(p), wy = std::cos(p);
    for (const Mark& mark : marks) {
      const double x = mark.point.x(), e = std::exp(-x / 3), s = std::sin(3 * x),
                   c = std::cos(3 * x);
      // Derivatives of e^(a x) sin 3x, a = -1/3, by the complex number a + 3i.
      const double f1 = e * (-s / 3 + 3 * c), f2 = e * ((1.0 / 9 - 9) * s - 2 * c),
                   f3 = e * ((-1.0 / 27 + 9) * s + (1 - 27) * c);
      const double w = 1 + f1 * f1;
      const double a = (f3 * w - 3 * f1 * f2 * f2) * (wy - f1 * wx), b = f2 * f2 * (wx + f1 * wy);
      EXPECT_NEAR(a + b, 0.0, 1e-10 * (std::abs(a) + std::abs(b) + 1.0)) << x << " " << lean;
    }
  }
  EXPECT_GE(total, 8u);
}

TEST(FormulaMarks, CycloidHasCuspsAndOneFlatTopPerArch) {
  // x = r (t - sin t), y = r (1 - cos t): k = -1/(4 r |sin(t/2)|), infinite at the cusps.
  const FeatureSet found = findFeatures(sceneOf(family("cycloid", {0.5, 0.5, 3.0}), 90.0));
  EXPECT_TRUE(found.complete()) << said(found);
  const auto corners = marksOf(found, {MarkKind::Corner});
  ASSERT_EQ(corners.size(), 2u) << said(found);
  for (const Mark& corner : corners) {
    EXPECT_NEAR(std::abs(corner.turnDeg), 180.0, 1e-9);
    EXPECT_NEAR(corner.point.y(), 0.0, 1e-12);
  }
  const auto flats = marksOf(found, {MarkKind::Flat});
  ASSERT_EQ(flats.size(), 3u) << said(found);
  for (const Mark& flat : flats) EXPECT_NEAR(flat.t - std::floor(flat.t), 0.5, 1e-14);
  EXPECT_TRUE(marksOf(found, {MarkKind::Inflection, MarkKind::Ridge, MarkKind::Valley}).empty())
      << said(found);
  // Seen from above: lambda = (4 r sin^2(t/2))^-2, a minimum at each top. The cusps point at the
  // viewer's line of sight: silhouettes, and so do the two open ends.
  EXPECT_EQ(marksOf(found, {MarkKind::ApparentMinimum}).size(), 3u) << said(found);
  EXPECT_EQ(marksOf(found, {MarkKind::ApparentRidge}).size(), 0u) << said(found);
  EXPECT_EQ(marksOf(found, {MarkKind::Silhouette}).size(), 4u) << said(found);
  // From the side the image folds at the cusps, at the tops, and not at the open ends.
  const FeatureSet side = findFeatures(sceneOf(family("cycloid", {0.5, 0.5, 3.0}), 0.0));
  EXPECT_TRUE(side.complete()) << said(side);
  EXPECT_EQ(marksOf(side, {MarkKind::Silhouette}).size(), 5u) << said(side);
}

TEST(FormulaMarks, CuspInsideAPieceIsACorner) {
  const FeatureSet found = findFeatures(sceneOf(typed("t^2", "t^3", "-1", "1.5"), 25.0));
  EXPECT_TRUE(found.complete()) << said(found);
  const auto corners = marksOf(found, {MarkKind::Corner});
  ASSERT_EQ(corners.size(), 1u) << said(found);
  EXPECT_NEAR(corners[0].t, 0.4, 1e-13);
  EXPECT_NEAR(std::abs(corners[0].turnDeg), 180.0, 1e-6);
}

TEST(FormulaMarks, StraightLineAndPointAreStated) {
  const FeatureSet line = findFeatures(sceneOf(typed("t", "2*t + 1", "0", "3"), 90.0));
  EXPECT_TRUE(line.complete()) << said(line);
  EXPECT_TRUE(line.marks.empty());
  ASSERT_EQ(line.degenerate.size(), 1u);
  EXPECT_EQ(line.degenerate[0].what, Degenerate::What::Straight);
  const FeatureSet endOn = findFeatures(sceneOf(typed("t", "t", "0", "3"), 45.0));
  ASSERT_EQ(endOn.degenerate.size(), 1u);
  EXPECT_EQ(endOn.degenerate[0].what, Degenerate::What::StraightEndOn);
  EXPECT_TRUE(endOn.marks.empty()) << said(endOn);
  EXPECT_TRUE(endOn.complete()) << said(endOn);
}

TEST(FormulaMarks, SuperellipseIsSmoothAcrossItsJoints) {
  const FeatureSet found = findFeatures(sceneOf(family("superellipse", {1.0, 1.2, 4.0}), 80.0));
  EXPECT_TRUE(found.complete()) << said(found);
  EXPECT_TRUE(marksOf(found, {MarkKind::Corner, MarkKind::Inflection}).empty()) << said(found);
  EXPECT_EQ(marksOf(found, {MarkKind::Silhouette}).size(), 2u) << said(found);
  EXPECT_EQ(marksOf(found, {MarkKind::Ridge}).size(), 4u) << said(found);
  EXPECT_EQ(marksOf(found, {MarkKind::Flat}).size(), 4u) << said(found);
}

TEST(FormulaMarks, EverySortHasAStatedAnswerInEveryView) {
  for (const Family& each : families()) {
    for (const double angle : {0.0, 90.0, 44.0, 17.3}) {
      for (const bool perspective : {false, true}) {
        FormulaCurve::Result made = FormulaCurve::make(initialCurve(each));
        Scene scene = sceneOf(*made.curve, angle);
        if (perspective) scene.view.distance = 9.0;
        const FeatureSet found = findFeatures(scene);
        EXPECT_TRUE(found.complete()) << each.name << " " << angle << " " << said(found);
        EXPECT_FALSE(found.marks.empty());
        for (const Mark& mark : found.marks) {
          EXPECT_LT(mark.residual, 1e-9) << each.name << " " << nameOf(mark.kind);
        }
      }
    }
  }
}

// Turning curve and view together, scaling and walking backwards keep kinds and places.
TEST(FormulaMarks, InvariantUnderScaleRotationAndReversal) {
  const Scene plain = sceneOf(typed("2*cos(t) + 0.3*cos(3*t)", "sin(t)", "0", "2*pi"), 70.0);
  const FeatureSet base = findFeatures(plain);
  EXPECT_TRUE(base.complete()) << said(base);
  EXPECT_GE(base.marks.size(), 8u);
  const auto expectSame = [&](const FeatureSet& other, double scale, bool reversed) {
    EXPECT_TRUE(other.complete()) << said(other);
    ASSERT_EQ(other.marks.size(), base.marks.size()) << said(base) << " | " << said(other);
    std::vector<Mark> marks = other.marks;
    if (reversed) {
      for (Mark& mark : marks) mark.t = mark.t == 0.0 ? 0.0 : 1.0 - mark.t;
    }
    std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
      return std::abs(a.t - b.t) > 1e-9 ? a.t < b.t : a.kind < b.kind;
    });
    for (std::size_t i = 0; i < marks.size(); ++i) {
      EXPECT_EQ(marks[i].kind, base.marks[i].kind) << i << said(base) << " | " << said(other);
      EXPECT_NEAR(marks[i].t, base.marks[i].t, 1e-11);
      if (marks[i].lambda) {
        EXPECT_NEAR(*marks[i].lambda * scale * scale, *base.marks[i].lambda,
                    1e-9 * *base.marks[i].lambda + 1e-20);
      }
    }
  };
  expectSame(findFeatures(
                 sceneOf(typed("1e6*(2*cos(t) + 0.3*cos(3*t))", "1e6*sin(t)", "0", "2*pi"), 70.0)),
             1e6, false);
  expectSame(findFeatures(sceneOf(
                 typed("1e-6*(2*cos(t) + 0.3*cos(3*t))", "1e-6*sin(t)", "0", "2*pi"), 70.0)),
             1e-6, false);
  expectSame(findFeatures(sceneOf(typed("0.8*(2*cos(t) + 0.3*cos(3*t)) - 0.6*sin(t)",
                                        "0.6*(2*cos(t) + 0.3*cos(3*t)) + 0.8*sin(t)", "0", "2*pi"),
                                  70.0 + std::atan2(0.6, 0.8) * 180 / kPi)),
             1.0, false);
  expectSame(findFeatures(sceneOf(typed("2*cos(t) + 0.3*cos(3*t)", "-sin(t)", "0", "2*pi"), 70.0)),
             1.0, true);
}

TEST(FormulaSweep, EllipseFoldsAgreeWithTheClosedForm) {
  // From the axis, the tip is an apparent ridge if b/a > sqrt(3/2); the fold of the sweep must part
  // those views. Events: 4 head-on ones, at the tips and flanks.
  const Sweep slim = sweepOf(sceneOf(family("ellipse", {1.0, 1.5}), 90.0));
  EXPECT_TRUE(slim.complete);
  const auto count = [](const Sweep& sweep, SweepEvent::What what) {
    return std::count_if(sweep.events.begin(), sweep.events.end(),
                         [what](const SweepEvent& event) { return event.what == what; });
  };
  // The two at t = 0 fall on the joint of the closed piece.
  EXPECT_EQ(count(slim, SweepEvent::What::HeadOn), 3);
  EXPECT_EQ(count(slim, SweepEvent::What::Fold), 4);
  const Sweep round = sweepOf(sceneOf(family("ellipse", {1.0, 1.2}), 90.0));
  EXPECT_EQ(count(round, SweepEvent::What::Fold), 0);
  // The parabola's fold: 30 degrees from the axis, at slope 1/sqrt 3.
  const Sweep parabola = sweepOf(sceneOf(family("parabola", {1.0, 2.0}), 90.0));
  ASSERT_EQ(count(parabola, SweepEvent::What::Fold), 2);
  for (const SweepEvent& event : parabola.events) {
    if (event.what != SweepEvent::What::Fold) continue;
    EXPECT_NEAR(std::abs(event.angleDeg), 60.0, 1e-9);
    EXPECT_NEAR(std::abs(4.0 * event.t - 2.0), 0.5 / std::sqrt(3.0), 1e-12);
  }
}

TEST(FormulaVisibility, CircleIsHiddenBehindItself) {
  const Scene scene = sceneOf(family("circle", {1.0}), 90.0);
  const Visibility visibility(scene);
  const auto& seen = visibility.visibleIntervals(0);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_NEAR(seen[0].tLow, 0.0, 1e-8);
  EXPECT_NEAR(seen[0].tHigh, 0.5, 1e-8);
}

TEST(FormulaMarks, KinkOfAFormulaIsACorner) {
  const struct {
    const char* y;
    double t;
  } cases[] = {{"abs(t)", 0.5}, {"abs(t-0.3)", 0.65}, {"sqrt(t^2)", 0.5}, {"abs(t)+0.1*t^2", 0.5}};
  for (const auto& [y, t] : cases) {
    const FeatureSet found = findFeatures(sceneOf(typed("t", y, "-1", "1"), 80.0));
    const std::vector<Mark> corners = marksOf(found, {MarkKind::Corner});
    ASSERT_EQ(corners.size(), 1u) << y << ": " << said(found);
    EXPECT_NEAR(corners[0].t, t, 1e-12) << y;
  }
}

TEST(FormulaMarks, JumpOfCurvatureThroughZeroIsAnInflection) {
  const FeatureSet found = findFeatures(sceneOf(typed("t", "abs(t)*t+t^3", "-1", "1"), 80.0));
  const std::vector<Mark> marks = marksOf(found, {MarkKind::Inflection});
  ASSERT_EQ(marks.size(), 1u) << said(found);
  EXPECT_NEAR(marks[0].t, 0.5, 1e-12);
}

TEST(FormulaMarks, InflectionBesideAKinkIsExact) {
  const FeatureSet found =
      findFeatures(sceneOf(typed("abs(t)+t", "(abs(t)+t)^3-3*(abs(t)+t)^2", "-1", "1"), 80.0));
  const std::vector<Mark> marks = marksOf(found, {MarkKind::Inflection});
  ASSERT_EQ(marks.size(), 1u) << said(found);
  EXPECT_NEAR(marks[0].t, 0.75, 1e-12);
}

TEST(FormulaMarks, NarrowBumpIsNotCalledStraightOrEmpty) {
  for (const char* y : {"exp(-1e6*(t-0.3141)^2)", "exp(-1e8*(t-0.3141)^2)"}) {
    const FeatureSet found = findFeatures(sceneOf(typed("t", y, "0", "1"), 80.0));
    EXPECT_TRUE(found.degenerate.empty()) << y;
    EXPECT_TRUE(!found.complete() || !marksOf(found, {MarkKind::Inflection}).empty()) << y;
  }
}

TEST(FormulaMarks, UnderflowIsStatedAndBoundsAreNumbers) {
  const FeatureSet found = findFeatures(sceneOf(family("gaussian", {1.0, 0.2, 6.0}), 80.0));
  EXPECT_TRUE(std::isfinite(found.errorBound()));
  for (const CurveSearch& search : found.searches) EXPECT_LT(search.pieces, 2000);
}

TEST(FormulaMarks, PoleInsideTheDomainIsRefused) {
  const struct {
    const char *x, *y;
  } cases[] = {{"1/t", "t"}, {"t", "1/(t-0.3)"}, {"t", "tan(2*t)"}};
  for (const auto& [x, y] : cases) {
    const auto made = FormulaCurve::make(TypedFormula{x, y, "-1", "1", {}});
    EXPECT_FALSE(made.curve) << x << ", " << y;
  }
  EXPECT_TRUE(FormulaCurve::make(TypedFormula{"t", "tan(t)", "-1", "1", {}}).curve);
  EXPECT_TRUE(FormulaCurve::make(TypedFormula{"t", "t^3", "-1", "1", {}}).curve);
}

TEST(FormulaMarks, CurveThatTurnsTooOftenIsRefused) {
  EXPECT_FALSE(FormulaCurve::make(TypedFormula{"t", "sin(1e6*t)", "0", "1", {}}).curve);
  EXPECT_TRUE(FormulaCurve::make(TypedFormula{"t", "sin(100*t)", "0", "1", {}}).curve);
}

}  // namespace
}  // namespace flatland::test
