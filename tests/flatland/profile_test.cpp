// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles against closed forms, finite differences and quadrature, and where they break.
#include "flatland/study/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flatland/curve/arc_length.h"
#include "flatland/features/orientation.h"
#include "flatland/study/profile_lines.h"
#include "tests/support/seed.h"

namespace flatland {
namespace {

using test::announcedSeed;
using test::Random;
using test::uniform;

constexpr double kLengthTolerance = 1e-9;  // what profile.h promises, of the length

Profile profileOf(const Scene& scene, double tolerance = 1.0) {
  return flatland::profileOf(scene, findFeatures(scene), 0, {.tolerance = tolerance});
}

Scene sceneOf(std::vector<Vec2> points, View view) {
  return {{{.shape = BezierChain(Bezier{std::move(points)})}}, view};
}

// The graph y = a x^2 over [-1, 2], seen along y.
Scene parabola(double a) {
  return sceneOf({{-1.0, a}, {0.5, -2.0 * a}, {2.0, 4.0 * a}}, View{90.0, std::nullopt});
}

Scene randomScene(Random& random, bool perspective) {
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i) {
    const double x = uniform(random, 0.0, 1.0);
    points.emplace_back(x, uniform(random, 0.0, 1.0));
  }
  View view{uniform(random, -180.0, 180.0), std::nullopt};
  if (perspective) view.distance = 3.0;
  return sceneOf(std::move(points), view);
}

template <class Visit>
void forEachSample(const Profile& profile, Visit visit) {
  for (const ProfileSegment& segment : profile.segments) {
    for (const ProfileSample& sample : segment.samples) visit(sample);
  }
}

TEST(Profile, OfAParabolaIsTheClosedForm) {
  constexpr double a = 0.8;
  constexpr double kTolerance = 1e-12;  // rounding, and a few digits lost in k'
  const Profile profile = profileOf(parabola(a));
  const auto primitive = [](double s) {  // of sqrt(1 + s^2)
    return 0.5 * (s * std::sqrt(1.0 + s * s) + std::asinh(s));
  };
  const auto lengthTo = [&](double x) { return primitive(2.0 * a * x) / (2.0 * a); };
  EXPECT_NEAR(profile.length, lengthTo(2.0) - lengthTo(-1.0), kLengthTolerance * profile.length);
  forEachSample(profile, [&](const ProfileSample& s) {
    const double x = s.point.x();
    const double slope = 2.0 * a * x, q = 1.0 + slope * slope;
    // The normal faces the viewer, above; the curve bulges away, downwards: k < 0.
    const double k = -2.0 * a / std::pow(q, 1.5);
    const double kPrime = 3.0 * 2.0 * a * slope * 2.0 * a / std::pow(q, 3.0);
    EXPECT_NEAR(s.k, k, kTolerance);
    EXPECT_NEAR(s.kPrime, kPrime, 10.0 * kTolerance);
    EXPECT_NEAR(s.nw, 1.0 / std::sqrt(q), kTolerance);
    EXPECT_NEAR(*s.lambda, 4.0 * a * a / (q * q), kTolerance);
    EXPECT_NEAR(s.feature, k * kPrime / std::sqrt(q), 10.0 * kTolerance);
    EXPECT_NEAR(s.offset, -k * k * k * slope / std::sqrt(q), kTolerance);
    EXPECT_NEAR(*s.screen, x, kTolerance);
    EXPECT_NEAR(s.u, lengthTo(x) - lengthTo(-1.0), kLengthTolerance * profile.length);
    if (s.ratio) {
      EXPECT_NEAR(*s.ratio, 1.0 / 3.0, 1e-8);
    } else {
      EXPECT_NEAR(x, 0.0, 1e-6);
    }
  });
}

TEST(Profile, SumIsTheDerivativeOfLambda) {
  // nw^3 / 2 dlambda/du, the derivative by a difference of lambda = k^2 / nw^2 taken apart from the
  // terms. Step and tolerance: away from silhouettes and cusps,
  // truncation stays below 1e-6.
  constexpr double h = 5e-5, kTolerance = 1e-5;
  Random random(announcedSeed("Profile.SumIsTheDerivativeOfLambda", 1));
  int checked = 0;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = randomScene(random, i % 2 == 1);
    const ViewFrame view = frameOf(scene.view);
    const Curve& curve = scene.curves[0].shape;
    const auto lambdaAt = [&](double t) {
      const Jet jet = jetAt(curve, t);
      const Frame f = frameOf(jet);
      const double nw = f.normal.dot(towardsViewer(view, jet.p));
      return f.k * f.k / (nw * nw);
    };
    forEachSample(profileOf(scene), [&](const ProfileSample& s) {
      if (s.t < 3 * h || s.t > 1.0 - 3 * h || std::abs(s.nw) < 0.2) return;
      const double speed = jetAt(curve, s.t).d1.norm();
      if (speed < 0.5) return;  // the difference would not resolve what happens near a cusp
      const double slope = (8.0 * (lambdaAt(s.t + h) - lambdaAt(s.t - h)) - lambdaAt(s.t + 2 * h) +
                            lambdaAt(s.t - 2 * h)) /
                           (12.0 * h * speed);
      const double expected = 0.5 * s.nw * s.nw * s.nw * slope;
      const double size = std::abs(s.feature) + std::abs(s.offset) + 1.0;
      EXPECT_NEAR(s.sum(), expected, kTolerance * size) << "t = " << s.t;
      ++checked;
    });
  }
  EXPECT_GT(checked, 1000);
}

TEST(Profile, LengthGrowsAndIsThatOfQuadrature) {
  Random random(announcedSeed("Profile.LengthGrowsAndIsThatOfQuadrature", 2));
  for (int i = 0; i < 40; ++i) {
    const Scene scene = randomScene(random, false);
    const Curve& curve = scene.curves[0].shape;
    const Profile profile = profileOf(scene);
    double u = 0.0, t = 0.0;
    int n = 0;
    forEachSample(profile, [&](const ProfileSample& s) {
      EXPECT_GE(s.t, t);
      EXPECT_GE(s.u, u);
      if (s.t > t) {
        EXPECT_GT(s.u, u);
      }
      t = s.t;
      u = s.u;
      if (++n % 50 == 0) {
        EXPECT_NEAR(s.u, arcLength(curve, 0.0, s.t, 1e-12).value,
                    kLengthTolerance * profile.length);
      }
    });
    EXPECT_EQ(t, 1.0);
    EXPECT_NEAR(profile.length, arcLength(curve, 0.0, 1.0, 1e-12).value,
                kLengthTolerance * profile.length);
  }
}

TEST(Profile, EveryMarkIsASample) {
  for (const Preset& preset : presets()) {
    const FeatureSet features = findFeatures(preset.scene);
    const Profile profile = profileOf(preset.scene);
    for (const Mark& mark : features.marks) {
      if (mark.curve != 0 || mark.kind == MarkKind::Corner || preset.id == "cusp") continue;
      bool found = false;
      forEachSample(profile, [&](const ProfileSample& s) {
        if (s.t != mark.t) return;
        found = true;
        EXPECT_NEAR(s.u, mark.u, kLengthTolerance * profile.length);
      });
      EXPECT_TRUE(found) << preset.id << ' ' << nameOf(mark.kind) << " at " << mark.t;
    }
  }
}

TEST(Profile, LambdaBreaksExactlyAtSilhouettes) {
  Random random(announcedSeed("Profile.LambdaBreaksExactlyAtSilhouettes", 3));
  int silhouettes = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = i == 0 ? defaultScene() : randomScene(random, i % 3 == 0);
    const FeatureSet features = findFeatures(scene);
    const Profile profile = profileOf(scene);
    const auto lines = linesOf(profile, ProfileQuantity::Lambda, Abscissa::ArcLength);
    std::vector<double> breaks;
    for (const Mark& mark : features.marks) {
      if (mark.kind == MarkKind::Silhouette && mark.t > 0.0 && mark.t < 1.0)
        breaks.push_back(mark.u);
    }
    silhouettes += static_cast<int>(breaks.size());
    ASSERT_EQ(lines.size(), breaks.size() + 1);
    for (std::size_t j = 0; j < breaks.size(); ++j) {
      // Neither passes the silhouette, both come near it, and rise there by decades.
      const double reach = 1e-4 * profile.length;
      EXPECT_LT(lines[j].back().x(), breaks[j]);
      EXPECT_GT(lines[j].back().x(), breaks[j] - reach);
      EXPECT_GT(lines[j + 1].front().x(), breaks[j]);
      EXPECT_LT(lines[j + 1].front().x(), breaks[j] + reach);
      const double natural = 1.0 / (profile.length * profile.length);
      EXPECT_GT(lines[j].back().y(), 1e3 * natural);
      EXPECT_GT(lines[j + 1].front().y(), 1e3 * natural);
    }
    // k and the terms pass a silhouette whole.
    EXPECT_EQ(linesOf(profile, ProfileQuantity::Curvature, Abscissa::ArcLength).size(), 1u);
    EXPECT_EQ(linesOf(profile, ProfileQuantity::Sum, Abscissa::ArcLength).size(), 1u);
  }
  EXPECT_GT(silhouettes, 30);
}

TEST(Profile, RatioBreaksWhereTheFeatureTermIsZeroButNotAtInflections) {
  const Scene& scene = defaultScene();
  const FeatureSet features = findFeatures(scene);
  std::vector<double> breaks;
  for (const Mark& mark : features.marks) {
    const bool zero = mark.kind == MarkKind::Silhouette || mark.kind == MarkKind::Ridge ||
                      mark.kind == MarkKind::Valley || mark.kind == MarkKind::Flat;
    if (zero && mark.t > 0.0 && mark.t < 1.0) breaks.push_back(mark.u);
  }
  const auto lines = linesOf(profileOf(scene), ProfileQuantity::Ratio, Abscissa::ArcLength);
  ASSERT_EQ(lines.size(), breaks.size() + 1);
  for (std::size_t j = 0; j < breaks.size(); ++j) {
    EXPECT_LT(lines[j].back().x(), breaks[j]);
    EXPECT_GT(lines[j + 1].front().x(), breaks[j]);
    EXPECT_GT(lines[j].back().y(), 1e2);
  }
}

// At an extremum k' is 0 but for the rounding of its place, which is to be judged by k^2 where the
// curve is sharp, and by its length where it is flat.
TEST(Profile, RatioBreaksAtExtremaHoweverSharpOrFlat) {
  const auto expectNone = [](const Scene& scene, int expected) {
    const FeatureSet features = findFeatures(scene);
    const Profile profile = flatland::profileOf(scene, features, 0);
    int extrema = 0;
    for (const Mark& mark : features.marks) {
      if (mark.kind != MarkKind::Ridge && mark.kind != MarkKind::Valley &&
          mark.kind != MarkKind::Flat) {
        continue;
      }
      ++extrema;
      forEachSample(profile, [&](const ProfileSample& s) {
        if (s.t == mark.t) {
          EXPECT_FALSE(s.ratio) << *s.ratio;
        }
      });
    }
    EXPECT_EQ(extrema, expected);
  };
  expectNone(parabola(1e5), 1);
  // y = x^4 over [-1, 2]; its flat place, between two ridges, has no exact parameter.
  expectNone(sceneOf({{-1.0, 1.0}, {-0.25, -2.0}, {0.5, 4.0}, {1.25, -8.0}, {2.0, 16.0}},
                     View{70.0, std::nullopt}),
             3);
}

TEST(Profile, CurvatureBreaksAtAJointWhereItJumps) {
  // A straight run into a parabola of curvature 2, tangent to it: k jumps, the tangent does not.
  const BezierChain chain(2, false, {{-2, 0}, {-1, 0}, {0, 0}, {0.5, 0}, {1, 1}});
  const Scene scene{{{.shape = chain}}, View{70.0, std::nullopt}};
  const Profile profile = profileOf(scene);
  const auto k = linesOf(profile, ProfileQuantity::Curvature, Abscissa::ArcLength);
  ASSERT_EQ(k.size(), 2u);
  EXPECT_NEAR(k[0].back().x(), 2.0, kLengthTolerance);
  EXPECT_EQ(k[0].back().x(), k[1].front().x());
  EXPECT_EQ(k[0].back().y(), 0.0);
  EXPECT_NEAR(std::abs(k[1].front().y()), 2.0, 1e-12);
  const ProfileSample& straight = profile.segments.front().samples[3];
  EXPECT_EQ(straight.lambda, 0.0);
  EXPECT_FALSE(straight.ratio);
}

TEST(Profile, StraightAndSeenEndOnHasNoLambda) {
  const Scene scene = sceneOf({{0, 0}, {0.3, 0.6}, {1, 2}},
                              View{std::atan2(2.0, 1.0) * 180.0 / std::numbers::pi, std::nullopt});
  ASSERT_EQ(findFeatures(scene).degenerate.front().what, Degenerate::What::StraightEndOn);
  forEachSample(profileOf(scene), [](const ProfileSample& s) {
    EXPECT_EQ(s.k, 0.0);
    EXPECT_FALSE(s.lambda);
    EXPECT_FALSE(s.ratio);
  });
}

TEST(Profile, SplittingACurveChangesNoLine) {
  Random random(announcedSeed("Profile.SplittingACurveChangesNoLine", 4));
  for (int i = 0; i < 10; ++i) {
    const Scene whole = randomScene(random, false);
    Scene split = whole;
    split.curves[0].shape = splitAt(whole.curves[0].chain(), 0.37);
    for (const auto quantity : {ProfileQuantity::Curvature, ProfileQuantity::Lambda,
                                ProfileQuantity::Sum, ProfileQuantity::Ratio}) {
      EXPECT_EQ(linesOf(profileOf(whole), quantity, Abscissa::ArcLength).size(),
                linesOf(profileOf(split), quantity, Abscissa::ArcLength).size());
    }
    EXPECT_NEAR(profileOf(split).length, profileOf(whole).length, 1e-9);
  }
}

TEST(Profile, KeepsAwayFromACusp) {
  const auto cusp = std::find_if(presets().begin(), presets().end(),
                                 [](const Preset& p) { return p.id == "cusp"; });
  ASSERT_NE(cusp, presets().end());
  const Profile profile = profileOf(cusp->scene);
  double nearest = 1.0;
  forEachSample(profile, [&](const ProfileSample& s) {
    for (const double value : {s.k, s.kPrime, s.feature, s.offset, s.nw, s.u}) {
      EXPECT_TRUE(std::isfinite(value));
    }
    for (const Mark& mark : findFeatures(cusp->scene).marks) {
      if (mark.kind == MarkKind::Corner) nearest = std::min(nearest, std::abs(s.t - mark.t));
    }
  });
  EXPECT_GT(nearest, 0.0);
  EXPECT_LT(nearest, 1e-6);
  EXPECT_EQ(linesOf(profile, ProfileQuantity::Curvature, Abscissa::ArcLength).size(), 2u);
}

TEST(Profile, OfAPointIsEmpty) {
  const Profile profile = profileOf(sceneOf({{1, 1}, {1, 1}, {1, 1}}, {}));
  EXPECT_TRUE(profile.segments.empty());
  EXPECT_EQ(profile.length, 0.0);
  EXPECT_FALSE(extentOf(profile, Abscissa::ArcLength));
  EXPECT_TRUE(linesOf(profile, ProfileQuantity::Sum, Abscissa::Screen).empty());
}

// Largest distance of the finer profile's lambda from the coarser's polyline, in decades.
double worstDecades(const Profile& coarse, const Profile& fine) {
  double worst = 0.0;
  const auto lines = linesOf(coarse, ProfileQuantity::Lambda, Abscissa::ArcLength, true);
  for (const auto& line : linesOf(fine, ProfileQuantity::Lambda, Abscissa::ArcLength, true)) {
    for (const Vec2& p : line) {
      if (std::abs(std::log10(p.y())) > 4.0) continue;
      for (const auto& other : lines) {
        const auto b = std::lower_bound(other.begin(), other.end(), p.x(),
                                        [](const Vec2& q, double x) { return q.x() < x; });
        if (b == other.begin() || b == other.end()) continue;
        const Vec2 &q = *b, &o = *std::prev(b);
        const double share = (p.x() - o.x()) / (q.x() - o.x());
        const double straight = std::log10(o.y()) + share * (std::log10(q.y()) - std::log10(o.y()));
        worst = std::max(worst, std::abs(std::log10(p.y()) - straight));
      }
    }
  }
  return worst;
}

TEST(Profile, FinerSamplingSaysTheSame) {
  const Profile coarse = profileOf(defaultScene(), 16.0);
  const Profile normal = profileOf(defaultScene(), 1.0);
  const Profile fine = profileOf(defaultScene(), 1.0 / 4.0);
  EXPECT_NEAR(fine.length, normal.length, kLengthTolerance * normal.length);
  // 1 % is 0.0043 decades; the criterion looks at the middle of a step, so allow twice.
  EXPECT_LT(worstDecades(normal, fine), 2.0 * 0.0043);
  EXPECT_LT(worstDecades(coarse, fine), 16.0 * 2.0 * 0.0043);
  EXPECT_GT(worstDecades(coarse, fine), 2.0 * 0.0043) << "coarser is coarser";
  // Half the step for a quarter of the tolerance.
  const double growth =
      static_cast<double>(fine.sampleCount()) / static_cast<double>(normal.sampleCount());
  EXPECT_GT(growth, 1.2);  // the samples that lead into a silhouette stay
  EXPECT_LT(growth, 2.5);
}

TEST(Profile, CostIsBounded) {
  Random random(announcedSeed("Profile.CostIsBounded", 5));
  for (int i = 0; i < 200; ++i) {
    EXPECT_LE(profileOf(randomScene(random, i % 2 == 0)).sampleCount(), 4400u);
  }
  // One step from a cusp: everything happens within 1e-6 of the length.
  EXPECT_LE(profileOf(sceneOf({{0, 0}, {1, 1}, {1e-6, 1}, {1, 0}}, {})).sampleCount(), 4400u);
}

TEST(Profile, ScalesWithTheScene) {
  Random random(announcedSeed("Profile.ScalesWithTheScene", 6));
  const Scene scene = randomScene(random, false);
  constexpr double scale = 0x1p20;
  Scene large = scene;
  for (std::size_t i = 0; i < 5; ++i) {
    large.curves[0].chain().setPoint(i, scale * scene.curves[0].chain().points()[i]);
  }
  const Profile a = profileOf(scene), b = profileOf(large);
  ASSERT_EQ(a.sampleCount(), b.sampleCount());
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    for (std::size_t j = 0; j < a.segments[i].samples.size(); ++j) {
      const ProfileSample &s = a.segments[i].samples[j], &r = b.segments[i].samples[j];
      EXPECT_NEAR(r.k * scale, s.k, 1e-9 * std::abs(s.k));
      EXPECT_EQ(s.ratio.has_value(), r.ratio.has_value());
      if (s.ratio) {
        EXPECT_NEAR(*r.ratio, *s.ratio, 1e-9 * *s.ratio);
      }
    }
  }
}

TEST(Profile, LengthAndParameterAreInverse) {
  Random random(announcedSeed("Profile.LengthAndParameterAreInverse", 7));
  for (int i = 0; i < 20; ++i) {
    const Scene scene = randomScene(random, false);
    const Curve& curve = scene.curves[0].shape;
    const Profile profile = profileOf(scene);
    for (int j = 0; j < 10; ++j) {
      const double u = uniform(random, 0.0, profile.length);
      const double t = parameterAtLength(curve, profile, u);
      EXPECT_NEAR(arcLength(curve, 0.0, t, 1e-12).value, u,
                  2.0 * kLengthTolerance * profile.length);
      EXPECT_NEAR(lengthAt(curve, profile, t), u, kLengthTolerance * profile.length);
    }
    EXPECT_EQ(parameterAtLength(curve, profile, -1.0), 0.0);
    EXPECT_EQ(parameterAtLength(curve, profile, 2.0 * profile.length), 1.0);
  }
}

TEST(Profile, FindsEveryPlaceOfAScreenCoordinate) {
  // A graph over y seen along x has one place for each coordinate; the S seen along y has three.
  const Scene s = sceneOf({{0, 0}, {2, 0}, {-1, 1}, {1, 1}}, View{90.0, std::nullopt});
  const Profile profile = profileOf(s);
  const std::vector<double> places = parametersAt(profile, Abscissa::Screen, 0.5);
  ASSERT_EQ(places.size(), 3u);
  for (const double t : places) {
    EXPECT_NEAR(pointAt(s.curves[0].shape, t).x(), 0.5, 1e-4);
  }
  EXPECT_NEAR(places[1], 0.5, 1e-4);
  EXPECT_EQ(parametersAt(profile, Abscissa::ArcLength, 0.3 * profile.length).size(), 1u);
  EXPECT_TRUE(parametersAt(profile, Abscissa::Screen, 5.0).empty());
}

TEST(Profile, SpreadWeighsByLength) {
  const Profile profile = profileOf(parabola(0.8));
  const ProfileSpread spread(profile, ProfileQuantity::Curvature, Abscissa::ArcLength, 0.0,
                             profile.length);
  EXPECT_NEAR(spread.quantile(0.0), -1.6, 1e-6);  // -2 a, at the vertex
  // |k| falls with |x| and the other arm ends at x = -1: 90 % of |k| lie above that at x0 where the
  // arc from x0 to 2 is a tenth of the whole.
  const auto& samples = profile.segments.back().samples;
  const auto at = std::find_if(samples.begin(), samples.end(),
                               [&](const ProfileSample& s) { return s.u >= 0.9 * profile.length; });
  EXPECT_NEAR(spread.quantile(0.9), at->k, 0.01);
  const ProfileSpread window(profile, ProfileQuantity::Curvature, Abscissa::Screen, 1.0, 2.0, true);
  EXPECT_NEAR(window.quantile(1.0), 1.6 / std::pow(1.0 + 1.6 * 1.6, 1.5), 0.01);
  EXPECT_TRUE(ProfileSpread(profile, ProfileQuantity::Sum, Abscissa::Screen, 7.0, 8.0).empty());
}

}  // namespace
}  // namespace flatland
