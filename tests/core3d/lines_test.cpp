// SPDX-License-Identifier: GPL-3.0-or-later
// Every family of lines but apparent ridges, against closed forms on solids with exact fields.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/core3d/lines_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;
const Solid kTorus{SolidKind::Torus, 1.0, 0.7};
const Eigen::Vector3d kOblique = Eigen::Vector3d(0.3, -0.6, 0.74).normalized();

FeatureLines linesOf(const SolidModel& model, const LineOptions& options,
                     const SurfaceView& view = {.towards = kOblique, .eye = {}}) {
  const FeatureLines lines = LineFinder(model.mesh, model.fields).find(view, options);
  expectFinite(lines);
  return lines;
}

// The exact point of the torus nearest to p.
SurfacePoint onTorus(const Eigen::Vector3d& p) {
  return pointAt(kTorus,
                 {std::atan2(p.y(), p.x()), std::atan2(p.z(), p.head<2>().norm() - kTorus.a), 0});
}

// K(w_T, w_T), which has the sign of radial curvature but is smooth where w_T = 0.
double radial(const SurfacePoint& point, const Eigen::Vector3d& w) {
  const Eigen::Vector2d wT = point.frame.transpose() * w;
  return wT.dot(point.K * wT);
}

TEST(Lines, ContoursOfATorusAreWhereItTurnsAway) {
  for (const bool perspective : {false, true}) {
    SurfaceView view{.towards = kOblique, .eye = {}};
    const SolidModel model = modelOf(kTorus, {.cells = 120, .irregular = true});
    // In coordinates of the mesh; the torus is centred at 0.
    if (perspective) view.eye = 3.0 * kOblique;
    const auto contours = linesOf(model, only({LineFamily::OccludingContours}), view)
                              .of(LineFamily::OccludingContours);
    ASSERT_GT(contours.size(), 200u);
    const auto off = distancesOf(model.mesh, contours, [&](const Eigen::Vector3d& p) {
      const SurfacePoint point = onTorus(p);
      return std::abs(point.n.dot(view.towardsViewer(point.p / model.mesh.unit)));
    });
    EXPECT_LT(off.back(), 2e-3);
    EXPECT_LT(median(off), 2e-4);
  }
}

void expectSuggestiveLinesOfATorus(const SurfaceView& view) {
  const SolidModel model = modelOf(kTorus, {.cells = 200, .irregular = true});
  LineOptions options = only({LineFamily::SuggestiveContours, LineFamily::SuggestiveHighlights});
  options.threshold.fill(0.01);
  const FeatureLines lines = linesOf(model, options, view);
  const auto towards = [&](const SurfacePoint& point) {
    return view.towardsViewer((point.p - model.mesh.origin) / model.mesh.unit);
  };
  const auto radialAt = [&](const SurfacePoint& point) { return radial(point, towards(point)); };
  for (const auto& [family, sign] : {std::pair(LineFamily::SuggestiveContours, 1.0),
                                     std::pair(LineFamily::SuggestiveHighlights, -1.0)}) {
    SCOPED_TRACE(nameOf(family));
    ASSERT_GT(lines.of(family).size(), 50u);
    int wrong = 0;
    for (const LineSegment& segment : lines.of(family)) {
      const SurfacePoint point = onTorus(middleInFile(model.mesh, segment));
      const Eigen::Vector3d w = towards(point);
      EXPECT_LT(std::abs(radial(point, w)), 3e-3);
      EXPECT_GT(point.n.dot(w), -1e-3) << "on the side turned away";
      // A short step along w on the surface: it grows or falls.
      const Eigen::Vector3d wT = point.frame * (point.frame.transpose() * w);
      const double step = 1e-4;
      const double ahead = radialAt(onTorus(point.p + step * wT));
      const double behind = radialAt(onTorus(point.p - step * wT));
      wrong += sign * (ahead - behind) <= 0.0;
      // And by as much as the strength says, S = D K(w_T, w_T) / |w_T|^2.
      const double size = model.fields.size * model.mesh.unit;
      const double growth = (ahead - behind) / (2 * step * wT.squaredNorm());
      if (wT.norm() < 0.2) continue;  // S has no limit where w_T = 0
      EXPECT_NEAR(0.5 * sign * (segment.a.strength + segment.b.strength), size * size * growth,
                  0.1 * std::abs(size * size * growth) + 0.05);
    }
    EXPECT_LE(wrong, static_cast<int>(lines.of(family).size()) / 100);
  }
}

TEST(Lines, SuggestiveContoursAndHighlightsOfATorus) {
  expectSuggestiveLinesOfATorus({.towards = kOblique, .eye = {}});
  expectSuggestiveLinesOfATorus({.towards = kOblique, .eye = 1.2 * kOblique});
}

TEST(Lines, ParabolicAndZeroMeanCurvatureOfATorus) {
  const SolidModel model = modelOf(kTorus, {.cells = 150, .irregular = true});
  const FeatureLines lines =
      linesOf(model, only({LineFamily::Parabolic, LineFamily::ZeroMeanCurvature}));
  // K = 0 on top and below, H = 0 where cos(tube) = -a / 2b.
  const auto circle = [](double radius) {
    return [radius](const Eigen::Vector3d& p) { return std::abs(p.head<2>().norm() - radius); };
  };
  const double edge = 2 * kPi * 0.7 / 150;
  const auto parabolic = distancesOf(model.mesh, lines.of(LineFamily::Parabolic), circle(1.0));
  const auto zero = distancesOf(model.mesh, lines.of(LineFamily::ZeroMeanCurvature), circle(0.5));
  EXPECT_LT(parabolic.back(), 0.1 * edge);
  EXPECT_LT(zero.back(), 0.1 * edge);
  EXPECT_NEAR(totalLength(model.mesh, lines.of(LineFamily::Parabolic)), 4 * kPi, 0.02);
  EXPECT_NEAR(totalLength(model.mesh, lines.of(LineFamily::ZeroMeanCurvature)), 2 * kPi, 0.02);
}

TEST(Lines, RidgesOfAnEllipsoidRunRoundItsRim) {
  const Solid ellipsoid{SolidKind::Ellipsoid, 1.0, 0.8, 0.3};
  const SolidModel model = modelOf(ellipsoid, {.cells = 60, .irregular = true});
  LineOptions options = only({LineFamily::Ridges, LineFamily::Valleys});
  options.threshold.fill(1.0);
  const FeatureLines lines = linesOf(model, options);
  EXPECT_TRUE(lines.of(LineFamily::Valleys).empty());
  // The rim z = 0 is an ellipse of circumference 5.672.
  const auto off = distancesOf(model.mesh, lines.of(LineFamily::Ridges),
                               [](const Eigen::Vector3d& p) { return std::abs(p.z()); });
  EXPECT_LT(median(off), 1e-3);
  EXPECT_LT(off.back(), 0.02);
  EXPECT_NEAR(totalLength(model.mesh, lines.of(LineFamily::Ridges)), 5.672, 0.06);
  // Seen from inside out it has the same line as a valley.
  SolidModel turned = model;
  SurfaceFields& f = turned.fields;
  for (std::uint32_t v = 0; v < f.vertexCount(); ++v) {
    // n, K and C change their signs; e1 and e2 change places.
    const Eigen::Vector3f e2 = f.e2(v);
    for (auto* values : {&f.nx, &f.ny, &f.nz}) (*values)[v] = -(*values)[v];
    f.e1x[v] = e2.x(), f.e1y[v] = e2.y(), f.e1z[v] = e2.z();
    const float k1 = f.k1[v], c111 = f.c111[v], c112 = f.c112[v];
    f.k1[v] = -f.k2[v], f.k2[v] = -k1;
    f.c111[v] = -f.c222[v], f.c222[v] = -c111;
    f.c112[v] = -f.c122[v], f.c122[v] = -c112;
  }
  LineFinder finder(turned.mesh, turned.fields);
  EXPECT_TRUE(finder.find({}, options).of(LineFamily::Ridges).empty());
  EXPECT_NEAR(totalLength(model.mesh, finder.find({}, options).of(LineFamily::Valleys)), 5.672,
              0.06);
}

TEST(Lines, PrincipalHighlightOfACylinderFacesTheViewer) {
  const SolidModel model = modelOf({SolidKind::Cylinder, 1.0, 2.0}, {.cells = 64});
  const Eigen::Vector3d towards = Eigen::Vector3d(0.6, 0.5, 0.4).normalized();
  LineOptions options = only({LineFamily::PrincipalHighlights});
  options.threshold.fill(0.5);
  const auto found =
      linesOf(model, options, {.towards = towards, .eye = {}}).of(LineFamily::PrincipalHighlights);
  // It is open, so there is another one on the inner side of its far wall.
  const Eigen::Vector2d facing = towards.head<2>().normalized();
  const auto off = distancesOf(model.mesh, found, [&facing](const Eigen::Vector3d& p) {
    return std::min((p.head<2>() - facing).norm(), (p.head<2>() + facing).norm());
  });
  ASSERT_FALSE(off.empty());
  EXPECT_LT(off.back(), 2e-3);  // the chord's height
  EXPECT_NEAR(totalLength(model.mesh, found), 4.0, 0.02);
}

TEST(Lines, IsophotesOfASphereAndTopographicLinesAreCircles) {
  const SolidModel model = modelOf({SolidKind::Sphere, 1.0}, {.cells = 60, .irregular = true});
  LineOptions options = only({LineFamily::Isophotes, LineFamily::Topographic});
  options.isophoteLevels = 4;
  options.topographicLevels = 3;
  options.topographicUp = Eigen::Vector3d(0, 2, 0);
  const FeatureLines lines = linesOf(model, options);
  std::map<std::uint32_t, double> isophotes, heights;
  for (const LineSegment& s : lines.of(LineFamily::Isophotes)) {
    EXPECT_NEAR(middleInFile(model.mesh, s).dot(kOblique), (s.level + 1) / 5.0, 2e-3);
    isophotes[s.level] += lengthInFile(model.mesh, s);
  }
  for (const LineSegment& s : lines.of(LineFamily::Topographic)) {
    EXPECT_NEAR(middleInFile(model.mesh, s).y(), -0.5 + 0.5 * s.level, 1e-3);
    heights[s.level] += lengthInFile(model.mesh, s);
  }
  ASSERT_EQ(isophotes.size(), 4u);
  ASSERT_EQ(heights.size(), 3u);
  for (const auto& [level, length] : isophotes)
    EXPECT_NEAR(length, 2 * kPi * std::sqrt(1 - std::pow((level + 1) / 5.0, 2)), 0.01);
  for (const auto& [level, length] : heights)
    EXPECT_NEAR(length, 2 * kPi * std::sqrt(1 - std::pow(-0.5 + 0.5 * level, 2)), 0.01);
}

PolygonSoup cube(int sides) {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) soup.addVertex(i & 1, i >> 1 & 1, i >> 2);
  const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int i = 0; i < sides; ++i) {
    soup.addTriangle(faces[i][0], faces[i][1], faces[i][2]);
    soup.addTriangle(faces[i][0], faces[i][2], faces[i][3]);
  }
  return soup;
}

TEST(Lines, CreasesAndBoundariesOfCubes) {
  for (const auto& [sides, creases, boundaries] : {std::tuple(6, 12u, 0u), std::tuple(5, 8u, 4u)}) {
    const TriangleMesh mesh = buildMesh(cube(sides)).mesh;
    SurfaceFields fields;
    fields.resize(mesh.vertexCount());
    LineFinder finder(mesh, fields);
    LineOptions options = only({LineFamily::Creases, LineFamily::Boundaries});
    const FeatureLines lines = finder.find({}, options);
    EXPECT_EQ(lines.of(LineFamily::Creases).size(), creases);
    EXPECT_EQ(lines.of(LineFamily::Boundaries).size(), boundaries);
    for (const LineSegment& s : lines.of(LineFamily::Creases)) EXPECT_NEAR(s.a.strength, 90, 1e-3);
    options.threshold[static_cast<std::size_t>(LineFamily::Creases)] = 91;
    EXPECT_TRUE(finder.find({}, options).of(LineFamily::Creases).empty());
    options.threshold[static_cast<std::size_t>(LineFamily::Creases)] = 45;
    EXPECT_EQ(finder.find({}, options).of(LineFamily::Creases).size(), creases);
  }
}

// The same pieces in the same order, from a finder that culls and has seen another view (it keeps
// old numbers where clusters are passed over), and from one that computes every vertex.
void expectCullingChangesNothing(const TriangleMesh& mesh, const SurfaceFields& fields,
                                 const SurfaceView& view, const LineOptions& options) {
  LineFinder used(mesh, fields);
  used.find({.towards = Eigen::Vector3d::UnitX(), .eye = {}}, options);
  const FeatureLines a = used.find(view, options);
  const FeatureLines b = LineFinder(mesh, fields, false).find(view, options);
  for (const LineFamily family : allLineFamilies()) {
    SCOPED_TRACE(nameOf(family));
    EXPECT_EQ(a.of(family).size(), b.of(family).size());
    for (std::size_t i = 0; i < std::min(a.of(family).size(), b.of(family).size()); ++i) {
      ASSERT_EQ(a.of(family)[i].a.at, b.of(family)[i].a.at);
      ASSERT_EQ(a.of(family)[i].b.node, b.of(family)[i].b.node);
    }
  }
}

TEST(Lines, CulledClustersChangeNothing) {
  const Solid bumpy{SolidKind::BumpySphere, 1.0, 0.1, 5.0};
  SolidModel insideOut = modelOf(bumpy, {.cells = 60});
  for (std::uint32_t v = 0; v < insideOut.fields.vertexCount(); ++v)
    insideOut.fields.set(v, turnedRound(insideOut.fields.at(insideOut.mesh, v)));
  for (const SolidModel& model : {modelOf(bumpy, {.cells = 60}), insideOut}) {
    for (const double threshold : {0.5, 2.0, 8.0}) {
      for (const bool perspective : {false, true}) {
        for (const bool isophotes : {false, true}) {
          SCOPED_TRACE(threshold);
          SurfaceView view{.towards = kOblique, .eye = {}};
          if (perspective) view.eye = 2.5 * kOblique;
          LineOptions options =
              only({LineFamily::ApparentRidges, LineFamily::OccludingContours,
                    LineFamily::SuggestiveContours, LineFamily::SuggestiveHighlights});
          options.threshold[static_cast<std::size_t>(LineFamily::ApparentRidges)] = threshold;
          options[LineFamily::Isophotes] = isophotes;
          expectCullingChangesNothing(model.mesh, model.fields, view, options);
          EXPECT_GT(LineFinder(model.mesh, model.fields)
                        .find(view, options)
                        .of(LineFamily::ApparentRidges)
                        .size(),
                    20u);
        }
      }
    }
  }
}

// Three flat sheets, far from each other, whose fields say: a hollow, a dome that is a saddle in
// the middle, a saddle. Clusters are pure, so the signs of radial curvature of the first two are
// known without computing it, and they follow each other.
TEST(Lines, ClustersOfBothSignsKeepTheirOwn) {
  constexpr std::uint32_t kSide = 32;
  PolygonSoup soup;
  for (const double start : {0.0, 4.0, 20.0}) {
    const auto first = static_cast<std::uint32_t>(soup.vertexCount());
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
      soup.addVertex(start + (i % kSide) / (kSide - 1.0), (i / kSide) / (kSide - 1.0), 0.0);
    for (std::uint32_t i = 0; i + kSide < kSide * kSide; ++i) {
      if (i % kSide + 1 == kSide) continue;
      const std::uint32_t a = first + i;
      soup.addTriangle(a, a + 1, a + kSide);
      soup.addTriangle(a + 1, a + kSide + 1, a + kSide);
    }
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  for (const double sign : {-1.0, 1.0}) {
    SurfaceFields fields;
    fields.resize(mesh.vertexCount());
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      const Eigen::Vector3d p = mesh.origin + mesh.unit * mesh.position(v).cast<double>();
      SurfacePoint point;
      point.n = Eigen::Vector3d::UnitZ();
      point.frame << 1, 0, 0, 1, 0, 0;
      point.K = sign * Eigen::Matrix2d::Identity();
      if (p.x() < 2) point.K = -point.K;
      if (p.x() > 15 || (p - Eigen::Vector3d(4.5, 0.5, 0)).norm() < 0.2)
        point.K = sign * Eigen::Vector2d(1, -1).asDiagonal().toDenseMatrix();
      point.C.coefficients = {4, 0, 0, -4};
      fields.set(v, point);
    }
    LineOptions options = only(
        {LineFamily::SuggestiveContours, LineFamily::SuggestiveHighlights, LineFamily::Isophotes});
    options.threshold.fill(0.0);
    const SurfaceView view{.towards = Eigen::Vector3d(0.2, 0.5, 0.8).normalized(), .eye = {}};
    expectCullingChangesNothing(mesh, fields, view, options);
    options[LineFamily::ApparentRidges] = true;
    expectCullingChangesNothing(mesh, fields, view, options);
    const FeatureLines lines = LineFinder(mesh, fields).find(view, options);
    // Only the saddle in the middle of the dome (or hollow) has a border.
    std::size_t found = 0;
    for (const LineFamily family :
         {LineFamily::SuggestiveContours, LineFamily::SuggestiveHighlights}) {
      for (const LineSegment& segment : lines.of(family)) {
        ++found;
        EXPECT_NEAR((middleInFile(mesh, segment) - Eigen::Vector3d(4.5, 0.5, 0)).norm(), 0.2,
                    2.0 / kSide);
      }
    }
    EXPECT_GT(found, 20u);
  }
}

}  // namespace
}  // namespace flatland::test
