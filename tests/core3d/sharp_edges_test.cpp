// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of creased surfaces: against the edges of polyhedra and closed forms.
#include "core3d/lines/sharp_edges.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "core3d/diff/estimate_fields.h"
#include "core3d/io/read_mesh.h"
#include "core3d/lines/families.h"
#include "tests/core3d/example_meshes.h"
#include "tests/core3d/lines_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

// A box of n x n cells a side.
TriangleMesh box(const Vector3d& half, int n,
                 const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  PolygonSoup soup;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1.0 : -1.0;
    const auto first = static_cast<std::uint32_t>(soup.vertexCount());
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; k <= n; ++k) {
        Vector3d p;
        p[axis] = sign;
        p[(axis + 1) % 3] = sign * (2.0 * i / n - 1.0);
        p[(axis + 2) % 3] = 2.0 * k / n - 1.0;
        p = turn * p.cwiseProduct(half);
        soup.addVertex(p.x(), p.y(), p.z());
      }
    }
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      for (std::uint32_t k = 0; k + 1 < row; ++k) {
        const std::uint32_t a = first + i * row + k;
        soup.addTriangle(a, a + row, a + row + 1);
        soup.addTriangle(a, a + row + 1, a + 1);
      }
    }
  }
  return buildMesh(soup).mesh;
}

// Radius 1 about z, from -1 to 1, with lids.
TriangleMesh can(int around, int up) {
  PolygonSoup soup;
  for (int i = 0; i <= up; ++i) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * kPi * k / around;
      soup.addVertex(std::cos(angle), std::sin(angle), 2.0 * i / up - 1.0);
    }
  }
  const auto n = static_cast<std::uint32_t>(around), top = static_cast<std::uint32_t>(up) * n;
  soup.addVertex(0, 0, -1);
  soup.addVertex(0, 0, 1);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    for (std::uint32_t i = 0; i < top; i += n) {
      soup.addTriangle(i + k, i + next, i + n + next);
      soup.addTriangle(i + k, i + n + next, i + n + k);
    }
    soup.addTriangle(top + n, next, k);
    soup.addTriangle(top + n + 1, top + k, top + next);
  }
  return buildMesh(soup).mesh;
}

Vector3d faceNormal(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vector3d p = mesh.position(a).cast<double>();
  return (mesh.position(b).cast<double>() - p)
      .cross(mesh.position(c).cast<double>() - p)
      .normalized();
}

void expectClosed(const std::vector<LineSegment>& segments) {
  std::map<LineNode, int> degree;
  std::map<LineNode, Eigen::Vector3f> place;
  for (const LineSegment& s : segments) {
    for (const LineEnd* end : {&s.a, &s.b}) {
      ++degree[end->node];
      const auto [known, added] = place.try_emplace(end->node, end->at);
      EXPECT_LT((known->second - end->at).norm(), 1e-5f) << "one node at two places";
    }
  }
  for (const auto& [node, count] : degree) EXPECT_EQ(count % 2, 0) << "a loose end";
}

TEST(SharpEdges, ContourOfABoxIsMadeOfItsEdges) {
  Random random(announcedSeed("ContourOfABoxIsMadeOfItsEdges", 5));
  const Vector3d half(1.0, 0.7, 0.4);
  for (const int cells : {1, 4}) {
    const TriangleMesh mesh = box(half, cells);
    const SurfaceFields fields = estimateFields(mesh);
    LineFinder finder(mesh, fields);
    for (int trial = 0; trial < 30; ++trial) {
      Vector3d w(normal(random), normal(random), normal(random));
      w.normalize();
      if (trial < 3) w = Vector3d::Unit(trial);  // four faces edge-on
      SurfaceView view{.towards = w, .eye = {}};
      const bool perspective = trial % 2 == 1 && trial > 3;
      if (perspective) view.eye = 6.0 * w;
      const auto facesViewer = [&](const Vector3d& face) {
        if (!perspective) return face.dot(w) > 1e-9;
        return face.dot(*view.eye - face.cwiseProduct(half)) > 0.0;
      };
      double contour = 0.0, inside = 0.0, all = 0.0;
      for (int k = 0; k < 3; ++k) {  // the four edges along each axis
        for (const double s : {-1.0, 1.0}) {
          for (const double t : {-1.0, 1.0}) {
            const bool a = facesViewer(s * Vector3d::Unit((k + 1) % 3));
            const bool b = facesViewer(t * Vector3d::Unit((k + 2) % 3));
            (a != b ? contour : a ? inside : all) += 2.0 * half[k];
          }
        }
      }
      all += contour + inside;
      const FeatureLines lines =
          finder.find(view, only({LineFamily::OccludingContours, LineFamily::ApparentRidges,
                                  LineFamily::SuggestiveContours, LineFamily::SuggestiveHighlights,
                                  LineFamily::PrincipalHighlights, LineFamily::Ridges,
                                  LineFamily::Valleys, LineFamily::Parabolic}));
      const auto length = [&](LineFamily family) { return totalLength(mesh, lines.of(family)); };
      EXPECT_NEAR(length(LineFamily::OccludingContours), contour, 1e-5) << w.transpose();
      EXPECT_NEAR(length(LineFamily::ApparentRidges), inside, 1e-5) << w.transpose();
      EXPECT_NEAR(length(LineFamily::Ridges), all, 1e-5);
      for (const LineFamily none :
           {LineFamily::Valleys, LineFamily::SuggestiveContours, LineFamily::SuggestiveHighlights,
            LineFamily::PrincipalHighlights, LineFamily::Parabolic})
        EXPECT_TRUE(lines.of(none).empty()) << nameOf(none);
      expectClosed(lines.of(LineFamily::OccludingContours));
    }
  }
}

// Strokes are joined by nodes: one node at two places would draw a line across the surface.
TEST(SharpEdges, EndsOfOneNodeLieAtOnePlace) {
  Random random(announcedSeed("EndsOfOneNodeLieAtOnePlace", 6));
  const auto solid = [](const Solid& of, int cells) {
    return buildMesh(meshOf(of, {.cells = cells, .irregular = true}).soup).mesh;
  };
  for (const TriangleMesh& mesh :
       {box({1.0, 0.7, 0.4}, 4), can(48, 12), solid({SolidKind::BumpySphere, 1.0, 0.3, 9.0}, 20),
        solid({SolidKind::RoundedCube, 1.0}, 8)}) {
    const SurfaceFields fields = estimateFields(mesh);
    LineFinder finder(mesh, fields);
    for (int trial = 0; trial < 10; ++trial) {
      LineOptions options;
      for (const LineFamily family : allLineFamilies())
        options[family] = family != LineFamily::Creases;
      options.threshold.fill(0.0);
      options.unfiltered = trial % 3 == 2;
      SurfaceView view{.towards = Vector3d(normal(random), normal(random), normal(random)),
                       .eye = {}};
      view.towards.normalize();
      if (trial % 2 == 1) view.eye = 3.0 * view.towards;
      const FeatureLines lines = finder.find(view, options);
      for (const LineFamily family : allLineFamilies()) {
        SCOPED_TRACE(nameOf(family));
        std::map<std::pair<std::uint32_t, LineNode>, Eigen::Vector3f> place;
        for (const LineSegment& s : lines.of(family)) {
          for (const LineEnd* end : {&s.a, &s.b}) {
            const auto [known, added] = place.try_emplace(std::pair(s.level, end->node), end->at);
            ASSERT_LT((known->second - end->at).norm(), 1e-5f);
          }
        }
      }
    }
    std::set<LineNode> nodes;
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      for (const LineNode node : {innerNode(mesh, t), sideNode(3 * t), sideNode(3 * t + 1),
                                  sideNode(3 * t + 2), edgeNode(mesh, 3 * t)})
        nodes.insert(node);
    }
    std::set<LineNode> edges;
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) edges.insert(edgeNode(mesh, 3 * t));
    EXPECT_EQ(nodes.size(), 4 * mesh.triangleCount() + edges.size());
  }
}

TEST(SharpEdges, WhereCreasesAreDrawnTheyAreNotDrawnAgain) {
  const TriangleMesh mesh = box({1.0, 0.7, 0.4}, 2);
  const SurfaceFields fields = estimateFields(mesh);
  const SurfaceView view{.towards = Vector3d(0.5, 0.6, 0.6).normalized(), .eye = {}};
  const FeatureLines lines =
      LineFinder(mesh, fields)
          .find(view, only({LineFamily::Creases, LineFamily::ApparentRidges, LineFamily::Ridges}));
  EXPECT_EQ(lines.of(LineFamily::Creases).size(), 24u);
  EXPECT_TRUE(lines.of(LineFamily::ApparentRidges).empty());
  EXPECT_TRUE(lines.of(LineFamily::Ridges).empty());
}

TEST(SharpEdges, TheConcaveEdgeOfAnAngleIsAValley) {
  // An L of 2 x 2 with arms 1 wide, 3 long in z.
  constexpr double kOutline[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  PolygonSoup soup;
  for (const double z : {0.0, 3.0}) {
    for (const auto& p : kOutline) soup.addVertex(p[0], p[1], z);
  }
  constexpr std::uint32_t kTop[] = {6, 7, 8, 9, 10, 11}, kBottom[] = {5, 4, 3, 2, 1, 0};
  soup.addPolygon(kTop);
  soup.addPolygon(kBottom);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    const std::uint32_t side[] = {i, next, next + 6, i + 6};
    soup.addPolygon(side);
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const FeatureLines lines = LineFinder(mesh, estimateFields(mesh))
                                 .find({}, only({LineFamily::Ridges, LineFamily::Valleys}));
  EXPECT_NEAR(totalLength(mesh, lines.of(LineFamily::Valleys)), 3.0, 1e-5);
  EXPECT_NEAR(totalLength(mesh, lines.of(LineFamily::Ridges)), 5 * 3.0 + 2 * 8.0, 1e-5);
}

TEST(SharpEdges, ContourOfACylinderWithLids) {
  for (const auto& [around, up] : {std::pair(48, 12), std::pair(64, 1)}) {
    const TriangleMesh mesh = can(around, up);
    const SurfaceFields fields = estimateFields(mesh);
    LineFinder finder(mesh, fields);
    Random random(announcedSeed("ContourOfACylinderWithLids", 11));
    for (int trial = 0; trial < 20; ++trial) {
      const double turn = kPi * uniform(random, 0.0, 2.0), rise = uniform(random, 0.3, 1.2);
      const Vector3d w(std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise),
                       std::sin(rise));
      const FeatureLines lines =
          finder.find({.towards = w, .eye = {}}, only({LineFamily::OccludingContours}));
      const auto& contours = lines.of(LineFamily::OccludingContours);
      // Two lines along the side and half of each rim.
      EXPECT_NEAR(totalLength(mesh, contours), 4.0 + 2.0 * kPi, 0.02) << around;
      expectClosed(contours);
      const Vector3d across = Vector3d::UnitZ().cross(w).normalized();
      for (const LineSegment& s : contours) {
        const Vector3d p = middleInFile(mesh, s);
        EXPECT_NEAR(p.head<2>().norm(), 1.0, 0.01);
        if (std::abs(p.z()) > 0.9999) {
          EXPECT_LT(p.z() * p.head<2>().dot(w.head<2>()), 0.02) << "on the wrong half of the rim";
        } else {
          EXPECT_NEAR(std::abs(p.dot(across)), 1.0, 0.01);
        }
      }
    }
  }
}

// n.w is the same all over a flat face, also where that is a level, up to roundings.
TEST(SharpEdges, ABoxSeenFromAfarHasNoIsophotes) {
  Random random(announcedSeed("ABoxSeenFromAfarHasNoIsophotes", 12));
  for (const int cells : {1, 6}) {
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    const TriangleMesh mesh = box({1.0, 0.7, 0.4}, cells, turn);
    const SurfaceFields fields = estimateFields(mesh);
    LineFinder finder(mesh, fields);
    LineOptions options = only({LineFamily::Isophotes});
    for (int trial = 0; trial < 30; ++trial) {
      SurfaceView view;
      view.towards = Vector3d(normal(random), normal(random), normal(random)).normalized();
      if (trial % 3 == 0) {
        view.towards = turn * Vector3d(0.6, 0.8, 0.0);
        options.isophoteLevels = 4;
      } else {
        options.isophoteLevels = 10;
      }
      EXPECT_TRUE(finder.find(view, options).of(LineFamily::Isophotes).empty()) << cells;
    }
    // Near by the line of sight turns along a face.
    EXPECT_FALSE(
        finder.find({.towards = Vector3d::UnitZ(), .eye = turn * Vector3d(0.6, 0.5, 1.2)}, options)
            .of(LineFamily::Isophotes)
            .empty());
  }
}

TEST(SharpEdges, IsophotesOfACylinderWithLidsAreStraightAndOnItsSide) {
  Random random(announcedSeed("IsophotesOfACylinderWithLids", 13));
  for (const auto& [around, up] : {std::pair(96, 12), std::pair(96, 1)}) {
    const TriangleMesh mesh = can(around, up);
    const SurfaceFields fields = estimateFields(mesh);
    LineFinder finder(mesh, fields);
    const LineOptions options = only({LineFamily::Isophotes});
    const auto levelOf = [&options](std::uint32_t i) {
      return (i + 1.0) / (options.isophoteLevels + 1.0);
    };
    for (int trial = 0; trial < 10; ++trial) {
      const double turn = kPi * uniform(random, 0.0, 2.0), rise = uniform(random, -1.2, 1.2);
      const Vector3d w(std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise),
                       std::sin(rise));
      const auto found = finder.find({.towards = w, .eye = {}}, options).of(LineFamily::Isophotes);
      std::map<std::uint32_t, double> length;
      for (const LineSegment& s : found) {
        length[s.level] += lengthInFile(mesh, s);
        const Vector3d p = middleInFile(mesh, s);
        ASSERT_NEAR(p.head<2>().norm(), 1.0, 1e-3) << "on a lid";
        // On the side n.w = cos(azimuth from the viewer's) cos(rise).
        const double facing = p.head<2>().normalized().dot(w.head<2>());
        EXPECT_NEAR(facing, levelOf(s.level), 1e-3);
        // Straight: no piece goes round.
        const Vector3d along = (s.b.at - s.a.at).cast<double>();
        EXPECT_LT(along.head<2>().norm(), 2e-3);
      }
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(options.isophoteLevels); ++i) {
        const double most = std::cos(rise);
        if (std::abs(levelOf(i) - most) < 0.005) continue;  // near where both lines are one
        EXPECT_NEAR(length[i], levelOf(i) < most ? 4.0 : 0.0, 1e-2) << levelOf(i) << ", " << rise;
      }
    }
  }
}

TEST(SharpEdges, RoundSurfacesHaveNone) {
  const auto count = [](const Solid& solid, const Meshing& meshing) {
    const SolidModel model = modelOf(solid, meshing);
    return SharpEdges(model.mesh, model.fields).edges().size();
  };
  for (const Solid& solid : standardSolids()) {
    for (const bool irregular : {false, true}) {
      EXPECT_EQ(count(solid, {.cells = 48, .irregular = irregular}), 0u) << solid.name();
    }
    // Coarse, but for those with waves, which are polyhedra then: up to 45 degrees an edge.
    const bool waves = solid.kind == SolidKind::SineSheet || solid.kind == SolidKind::BumpySphere ||
                       solid.kind == SolidKind::GaussianBump;
    if (!waves) {
      EXPECT_EQ(count(solid, {.cells = 8}), 0u) << solid.name();
    }
  }
  for (const bool irregular : {false, true})
    EXPECT_EQ(count({SolidKind::Sphere, 1.0}, {.cells = 4, .irregular = irregular}), 0u);
}

// A sheet of 12 x 24 cells, long in y, folded along y: from x = 0 to 1 it falls with the first
// slope of its row, degrees, then with the second.
TriangleMesh foldedSheet(const std::function<std::pair<double, double>(int row)>& slopesDeg) {
  constexpr int kHalf = 6, kRows = 24;
  constexpr double kLong = 200.0;  // so that rows turn little against each other
  PolygonSoup soup;
  for (int k = 0; k <= kRows; ++k) {
    const auto [inner, outer] = slopesDeg(k);
    for (int i = -kHalf; i <= kHalf; ++i) {
      const double beyond = std::max(0, std::abs(i) - 1), first = std::min(1, std::abs(i));
      soup.addVertex(i, kLong * k,
                     -first * std::tan(inner * kPi / 180) - beyond * std::tan(outer * kPi / 180));
    }
  }
  constexpr std::uint32_t kRow = 2 * kHalf + 1;
  for (std::uint32_t k = 0; k < kRows; ++k) {
    for (std::uint32_t i = 0; i + 1 < kRow; ++i) {
      const std::uint32_t a = k * kRow + i;
      soup.addTriangle(a, a + 1, a + kRow + 1);
      soup.addTriangle(a, a + kRow + 1, a + kRow);
    }
  }
  return buildMesh(soup).mesh;
}

std::size_t sharpEdgesOf(const TriangleMesh& mesh) {
  return SharpEdges(mesh, estimateFields(mesh)).edges().size();
}

TEST(SharpEdges, GoOnWhereTheSurfaceIsRounderForAWhile) {
  EXPECT_EQ(sharpEdgesOf(foldedSheet([](int) { return std::pair(17.0, 17.0); })), 24u);
  // Round all along it is not sharp; where a sharp edge leads there and on, it is.
  const std::pair round(17.0, 30.0), sharp(17.0, 17.0);
  EXPECT_EQ(sharpEdgesOf(foldedSheet([&](int) { return round; })), 0u);
  EXPECT_EQ(sharpEdgesOf(foldedSheet([&](int k) { return k > 9 && k < 13 ? round : sharp; })), 24u);
}

TEST(SharpEdges, FewInARowAreNoise) {
  // A fold that is 30 degrees or more on so many edges in the middle.
  const auto folded = [](int edges) {
    return foldedSheet([edges](int k) {
      const bool inside = std::abs(k - 12) <= edges / 2;
      const double slope = inside ? 20.0 : 10.0;
      return std::pair(slope, slope);
    });
  };
  EXPECT_EQ(sharpEdgesOf(folded(2)), 0u);
  EXPECT_GE(sharpEdgesOf(folded(8)), 8u);
}

using SharpEdgesData = ExampleMeshes;

TEST_F(SharpEdgesData, NoContourCrossesAFlatFaceOfMachineParts) {
  // The drive is an assembly whose bodies share edges; where creases end in the middle of a face
  // there, normals are means still.
  for (const auto& [name, share] :
       {std::pair("gearwheel_ascii.stl", 0.001), std::pair("featuretype.stl", 0.001),
        std::pair("cycloidal_drive.ply", 0.04)}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = loadMesh(dataFolder() / "meshes" / name).mesh;
    const SurfaceFields fields = estimateFields(mesh);
    LineFinder finder(mesh, fields);
    for (const Vector3d& towards : {Vector3d(1, 0.8, 0.9), Vector3d(0.4, -1, 0.6),
                                    Vector3d(-0.3, 0.2, 1), Vector3d(1, 0.1, 0.05)}) {
      const Vector3d w = towards.normalized();
      const auto lines =
          finder.find({.towards = w, .eye = {}}, only({LineFamily::OccludingContours}));
      double across = 0.0, all = 0.0;
      for (const LineSegment& s : lines.of(LineFamily::OccludingContours)) {
        const double length = lengthInFile(mesh, s);
        all += length;
        // Along an edge of its triangle?
        bool edge = false;
        const auto& v = mesh.triangles[s.triangle];
        for (std::size_t k = 0; k < 3; ++k) {
          const Vector3d a = mesh.positionInFile(v[k]), d = mesh.positionInFile(v[(k + 1) % 3]) - a;
          const Vector3d off = middleInFile(mesh, s) - a;
          edge = edge || off.cross(d).norm() < 1e-5 * mesh.unit * d.norm();
        }
        // A facet of a round wall turns by less than 30 degrees from the next, and is crossed only
        // where it is within that of edge-on.
        if (!edge && std::abs(faceNormal(mesh, s.triangle).dot(w)) > 0.5) across += length;
      }
      EXPECT_GT(all, 0.0);
      EXPECT_LT(across, share * all) << w.transpose();
    }
  }
}

}  // namespace
}  // namespace flatland::test
