// SPDX-License-Identifier: GPL-3.0-or-later
// From strokes to a drawing: simplification, ink, the whole.
#include "core3d/draw/compose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core3d/draw/chains.h"
#include "core3d/draw/ink.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/core3d/screen_lines.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Simplify, StaysWithinTheTolerance) {
  Random random(announcedSeed("StaysWithinTheTolerance", 10));
  for (int trial = 0; trial < 20; ++trial) {
    const bool closed = trial % 2 == 1;
    const double tolerance = std::pow(10.0, uniform(random, -2.0, 1.0));
    std::vector<Vector2d> line;
    for (int i = 0; i < 400; ++i) {
      const double a = 2.0 * std::numbers::pi * i / 400.0;
      const double r = 100.0 + 10.0 * std::sin(7.0 * a) + uniform(random, -1.0, 1.0);
      line.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    const auto kept = simplified(line, closed, tolerance);
    std::vector<Vector2d> result;
    for (const std::size_t i : kept) result.push_back(line[i]);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_EQ(kept.front(), 0u);
    if (!closed) {
      EXPECT_EQ(kept.back(), 399u);
    }
    double worst = 0.0;
    for (const Vector2d& p : line) worst = std::max(worst, distanceTo(p, result, closed));
    EXPECT_LE(worst, tolerance * (1.0 + 1e-12));
    if (tolerance > 3.0) {
      EXPECT_LT(kept.size(), 60u);
    }
    EXPECT_GE(kept.size(), closed ? 3u : 2u);
  }
}

TEST(Simplify, KeepsTheFarthestPointOfALoop) {
  const ScreenChain loop = ring(std::vector<float>(8, 1.0f));
  EXPECT_EQ(simplified(loop.screen, true, 1000.0), (std::vector<std::size_t>{0, 4}));
}

TEST(Simplify, CarriesPointsAndStrengthAlong) {
  SeenChain chain{straight(std::vector<float>(11, 1.0f), 10.0), {}};
  chain.line.chain.points[5].y() = 8.0f;
  chain.line = onScreen(chain.line.chain, flatProjection()).front();
  chain.line.chain.strength[5] = 3.0f;
  const StrokePart part{0, 15.0, chain.line.length() - 4.0, Seen::Visible, false};
  const Polyline line = polylineOf(chain, part, flatProjection(), 0.5);
  ASSERT_EQ(line.points.size(), 5u);  // cut ends, the tip and its feet
  EXPECT_NEAR(line.points[0].x(), 15.0f, 1e-4f);
  EXPECT_EQ(line.points[2], Eigen::Vector3f(50.0f, 8.0f, 0.0f));
  EXPECT_EQ(line.strength[2], 3.0f);
  EXPECT_NEAR(line.screen[0].x(), 415.0, 1e-4);
  EXPECT_NEAR(line.points[4].x(), 96.0f, 1e-4f);
}

TEST(Ink, CountsThePixelsWhoseMiddleIsCovered) {
  Random random(announcedSeed("CountsThePixelsWhoseMiddleIsCovered", 11));
  InkRaster raster(61.0, 47.5);
  const double pixels = 61.0 * 48.0;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vector2d> line;
    const int n = uniformInt(random, 1, 5);
    for (int i = 0; i < n; ++i) {
      line.emplace_back(uniform(random, -20.0, 80.0), uniform(random, -20.0, 70.0));
    }
    if (trial % 5 == 0) line.back() = line.front();
    const double width = uniform(random, 0.3, 12.0);
    const bool closed = trial % 2 == 1;
    raster.clear();
    raster.add(line, closed, width);
    std::size_t expected = 0;
    for (int y = 0; y < 48 && n > 1; ++y) {
      for (int x = 0; x < 61; ++x) {
        expected += distanceTo({x + 0.5, y + 0.5}, line, closed) <= width / 2.0;
      }
    }
    EXPECT_EQ(raster.covered(), expected) << "trial " << trial;
    EXPECT_DOUBLE_EQ(raster.share(), static_cast<double>(expected) / pixels);
    raster.add(line, closed, width);
    EXPECT_EQ(raster.covered(), expected);  // the same ink twice is the same ink
  }
}

// A picture of strokes on a plane: 400 short ones of random strength, 3 creases without threshold.
struct Sheet {
  TriangleMesh mesh;
  FeatureLines found;
  LineOptions lines;

  Sheet() {
    PolygonSoup soup;
    soup.addVertex(-1, -1, 0);
    soup.addVertex(1, -1, 0);
    soup.addVertex(1, 1, 0);
    soup.addVertex(-1, 1, 0);
    soup.addTriangle(0, 1, 2);
    soup.addTriangle(0, 2, 3);
    mesh = buildMesh(soup).mesh;
    Random random(announcedSeed("Sheet", 12));
    std::uint64_t node = 0;
    const auto add = [&](LineFamily family, double length, float strength) {
      const double a = uniform(random, 0.0, 6.3);
      const Vector3d p(uniform(random, -0.9, 0.9), uniform(random, -0.9, 0.9), 0.0);
      const Vector3d q = p + length * Vector3d(std::cos(a), std::sin(a), 0.0);
      found.of(family).push_back({{p.cast<float>(), strength, freeNode(node)},
                                  {q.cast<float>(), strength, freeNode(node + 1)},
                                  0});
      node += 2;
    };
    for (int i = 0; i < 400; ++i) {
      add(LineFamily::ApparentRidges, 0.08, static_cast<float>(std::exp(normal(random))));
    }
    for (int i = 0; i < 400; ++i) {
      add(LineFamily::Ridges, 0.06, static_cast<float>(5.0 * std::exp(normal(random))));
    }
    for (int i = 0; i < 3; ++i) add(LineFamily::Creases, 0.4, 90.0f);
    lines[LineFamily::ApparentRidges] = lines[LineFamily::Ridges] = lines[LineFamily::Creases] =
        true;
    lines.threshold[static_cast<std::size_t>(LineFamily::Ridges)] = 7.0;
  }

  Drawing draw(const StrokeOptions& strokes) const {
    const SurfaceFields none;
    return composeDrawing(found, Sight(mesh, none), projectionOf(Camera(), mesh), lines, strokes);
  }
};

TEST(Ink, IsMetByOneFactorOnTheThresholds) {
  const Sheet sheet;
  for (const double ink : {0.005, 0.01, 0.02, 0.03}) {
    const Drawing drawing = sheet.draw({.minWeightPx = 0.0, .ink = ink});
    EXPECT_NEAR(drawing.stats.ink, ink, 0.01 * ink);
    EXPECT_TRUE(drawing.stats.inkReached);
    // The factor is what it says: drawing with it gives the same strokes, creases all the while.
    Sheet again = sheet;
    for (double& threshold : again.lines.threshold) threshold *= drawing.stats.thresholdFactor;
    const Drawing same = again.draw({.minWeightPx = 0.0});
    EXPECT_EQ(same.polylines.size(), drawing.polylines.size());
    EXPECT_DOUBLE_EQ(same.stats.ink, drawing.stats.ink);
    EXPECT_EQ(std::count_if(drawing.polylines.begin(), drawing.polylines.end(),
                            [](const Polyline& p) { return p.family == LineFamily::Creases; }),
              3);
  }
}

TEST(Ink, OneStrongPointDoesNotMatter) {
  Sheet sheet;
  const Drawing before = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  sheet.found.of(LineFamily::ApparentRidges).front().a.strength = 1e30f;
  const Drawing after = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  EXPECT_TRUE(after.stats.inkReached);
  EXPECT_NEAR(after.stats.thresholdFactor, before.stats.thresholdFactor,
              0.1 * before.stats.thresholdFactor);
}

TEST(Ink, TellsWhatCountsAsWeak) {
  const Sheet sheet;
  const auto weak = [&sheet](LineFamily family, std::optional<double> ink) {
    const Drawing drawing = sheet.draw({.minWeightPx = 0.0, .ink = ink});
    const auto i = static_cast<std::size_t>(family);
    return std::pair(drawing.weak[i] / sheet.lines.threshold[i], drawing.stats.thresholdFactor);
  };
  for (const LineFamily family : {LineFamily::ApparentRidges, LineFamily::Creases}) {
    EXPECT_DOUBLE_EQ(weak(family, std::nullopt).first, 1.0);
  }
  const auto [share, factor] = weak(LineFamily::Ridges, 0.005);
  EXPECT_GT(factor, 1.0);
  EXPECT_DOUBLE_EQ(share, factor);
  const auto [less, lowered] = weak(LineFamily::Ridges, 0.02);
  EXPECT_LT(lowered, 1.0);
  EXPECT_DOUBLE_EQ(less, std::sqrt(lowered));
  EXPECT_DOUBLE_EQ(weak(LineFamily::Ridges, 0.5).first, 0.3);  // all lines: the factor is 0
  EXPECT_DOUBLE_EQ(weak(LineFamily::Creases, 0.005).first, 1.0);
}

TEST(Ink, SaysWhenItCannotBeMet) {
  const Sheet sheet;
  const Drawing all = sheet.draw({.minWeightPx = 0.0, .largestGapPx = 0.0, .ink = 0.5});
  EXPECT_FALSE(all.stats.inkReached);
  EXPECT_EQ(all.polylines.size(), 803u);
  EXPECT_EQ(all.stats.thresholdFactor, 0.0);
  const Drawing creases = sheet.draw({.ink = 1e-4});
  EXPECT_FALSE(creases.stats.inkReached);
  EXPECT_EQ(creases.polylines.size(), 3u);
  EXPECT_GT(creases.stats.ink, 1e-4);
}

TEST(Compose, SaysHowMuchIsNoCrumb) {
  const Sheet sheet;
  // At 280 px a unit: ridges of 17 px are shorter than 2 % of the diagonal of 1000 px, the others
  // of 22 and 112 px longer.
  const Drawing drawing = sheet.draw({.minWeightPx = 0.0, .largestGapPx = 0.0});
  double total = 0.0, inLong = 0.0;
  for (const Polyline& line : drawing.polylines) {
    const double length = (line.screen[1] - line.screen[0]).norm();
    total += length;
    if (line.family != LineFamily::Ridges) inLong += length;
  }
  EXPECT_NEAR(drawing.stats.share, inLong / total, 1e-9);
  EXPECT_GT(drawing.stats.share, 0.3);
  EXPECT_LT(drawing.stats.share, 0.7);
}

TEST(Compose, PicturesOfAllSizesHaveTheSameStrokes) {
  const Sheet sheet;
  const SurfaceFields none;
  const Sight sight(sheet.mesh, none);
  const auto draw = [&](double scale) {
    Camera camera;
    camera.width *= scale;
    camera.height *= scale;
    camera.margin *= scale;
    return composeDrawing(sheet.found, sight, projectionOf(camera, sheet.mesh), sheet.lines,
                          {.minLengthPx = 20.0, .largestGapPx = 12.0, .ink = 0.015});
  };
  const Drawing usual = draw(1.0);
  EXPECT_GT(usual.polylines.size(), 20u);
  EXPECT_LT(usual.polylines.size(), 400u);
  for (const double scale : {0.25, 3.0}) {
    const Drawing other = draw(scale);
    ASSERT_EQ(other.polylines.size(), usual.polylines.size()) << scale;
    EXPECT_NEAR(other.stats.ink, usual.stats.ink, 1e-3 * usual.stats.ink);
    EXPECT_EQ(other.projection.width, 800.0 * scale);
    for (std::size_t i = 0; i < usual.polylines.size(); ++i) {
      const auto &a = usual.polylines[i].screen, &b = other.polylines[i].screen;
      EXPECT_LT((scale * a.front() - b.front()).norm(), 1e-6 * scale);
      EXPECT_LT((scale * a.back() - b.back()).norm(), 1e-6 * scale);
    }
  }
}

TEST(Compose, SegmentsAreThoseOfTheStrokes) {
  const Sheet sheet;
  const SurfaceFields none;
  const Sight sight(sheet.mesh, none);
  const Projection projection = projectionOf(Camera(), sheet.mesh);
  for (const std::optional<double> ink : {std::optional<double>(), std::optional(0.02)}) {
    const StrokeOptions strokes{.tolerancePx = -1.0, .ink = ink};  // no point is left out
    const Drawing drawing = sheet.draw(strokes);
    ASSERT_NE(drawing.stats.thresholdFactor == 1.0, ink.has_value());
    for (const Sight* asked : {&sight, static_cast<const Sight*>(nullptr)}) {
      const StrokeLines lines = strokeLines(sheet.found, asked, projection, sheet.lines, strokes,
                                            drawing.stats.thresholdFactor);
      for (const LineFamily family : allLineFamilies()) {
        std::vector<std::pair<float, float>> expected, found;  // ends by x: none are alike
        for (const Polyline& line : drawing.polylines) {
          if (line.family != family) continue;
          for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            expected.push_back(std::minmax({line.points[i].x(), line.points[i + 1].x()}));
          }
        }
        for (const LineSegment& s : lines.visible.of(family)) {
          found.push_back(std::minmax({s.a.at.x(), s.b.at.x()}));
        }
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << nameOf(family);
        EXPECT_TRUE(lines.hidden.of(family).empty());
      }
      EXPECT_FALSE(lines.visible.of(LineFamily::ApparentRidges).empty());
    }
  }
}

TEST(Compose, SegmentsOfALoopMeet) {
  // A square of contours on a plane, one corner node each.
  Sheet sheet;
  sheet.found = {};
  sheet.lines = {};
  sheet.lines[LineFamily::OccludingContours] = true;
  const Eigen::Vector3f corners[] = {
      {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  for (std::uint64_t i = 0; i < 4; ++i) {
    sheet.found.of(LineFamily::OccludingContours)
        .push_back({{corners[i], 1.0f, freeNode(i)},
                    {corners[(i + 1) % 4], 1.0f, freeNode((i + 1) % 4)},
                    0});
  }
  const StrokeLines lines =
      strokeLines(sheet.found, nullptr, projectionOf(Camera(), sheet.mesh), sheet.lines, {});
  const auto& loop = lines.visible.of(LineFamily::OccludingContours);
  ASSERT_EQ(loop.size(), 4u);
  const std::vector<LineChain> chains = chainSegments(LineFamily::OccludingContours, loop);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[0].points.size(), 4u);
}

TEST(Compose, AsksForLinesDownToWhereTheyAreFollowed) {
  LineOptions lines;
  lines[LineFamily::ExteriorSilhouette] = true;
  const auto ridges = static_cast<std::size_t>(LineFamily::ApparentRidges);
  lines.threshold[ridges] = 10.0;
  const LineOptions asked = linesToFind(lines, {.hysteresis = 0.5});
  EXPECT_DOUBLE_EQ(asked.threshold[ridges], 5.0);
  EXPECT_TRUE(asked[LineFamily::OccludingContours]);
  EXPECT_TRUE(asked[LineFamily::Boundaries]);
  EXPECT_EQ(linesToFind(lines, {.ink = 0.04}).threshold[ridges], 0.0);
}

TEST(Compose, StopsWhenAsked) {
  const Sheet sheet;
  std::stop_source source;
  source.request_stop();
  const Drawing drawing = sheet.draw({.ink = 0.01, .stop = source.get_token()});
  EXPECT_TRUE(drawing.polylines.empty());
}

TEST(Compose, OrderOfSegmentsDoesNotMatter) {
  Sheet sheet;
  const Drawing before = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  Random random(announcedSeed("OrderOfSegmentsDoesNotMatter", 13));
  for (auto& segments : sheet.found.segments)
    std::shuffle(segments.begin(), segments.end(), random);
  const Drawing after = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  ASSERT_EQ(before.polylines.size(), after.polylines.size());
  for (std::size_t i = 0; i < before.polylines.size(); ++i) {
    EXPECT_EQ(before.polylines[i].screen, after.polylines[i].screen);
    EXPECT_EQ(before.polylines[i].strength, after.polylines[i].strength);
  }
}

}  // namespace
}  // namespace flatland::test
