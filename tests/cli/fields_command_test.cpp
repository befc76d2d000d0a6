// SPDX-License-Identifier: GPL-3.0-or-later
// flatland fields and convergence, from the outside.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "core3d/diff/surface_jet.h"
#include "core3d/io/read_mesh.h"
#include "tests/support/flatland_program.h"
#include "tests/support/xml_check.h"

namespace flatland::test {
namespace {

/// The rows of a table of numbers by the names of its columns.
std::vector<std::map<std::string, double>> rowsOf(const std::string& csv) {
  std::istringstream in(csv);
  std::string line;
  const auto fields = [&line] {
    std::vector<std::string> parts;
    std::istringstream fieldsIn(line.substr(0, line.find('\r')));
    for (std::string part; std::getline(fieldsIn, part, ',');) parts.push_back(part);
    return parts;
  };
  std::getline(in, line);
  const std::vector<std::string> names = fields();
  std::vector<std::map<std::string, double>> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = fields();
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
      row[names[i]] = values[i].empty() ? NAN : std::stod(values[i]);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Each row seen again by the template in double precision.
TEST(FieldsCommand, TermsAreThoseOfTheRowsOwnFields) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "fields.csv";
  ASSERT_EQ(run({"fields", "solid:ellipsoid:12", "-o", file, "--view", "1,2,2"}).exitCode, 0);
  const Eigen::Vector3d w = Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0;
  const auto rows = rowsOf(contentsOf(file));
  EXPECT_EQ(rows.size(), 6u * 12 * 12 + 2);
  for (auto row : rows) {
    SurfacePoint point;
    point.p = {row["x"], row["y"], row["z"]};
    point.n = {row["nx"], row["ny"], row["nz"]};
    point.frame.col(0) = Eigen::Vector3d(row["e1x"], row["e1y"], row["e1z"]);
    point.frame.col(1) = Eigen::Vector3d(row["e2x"], row["e2y"], row["e2z"]);
    point.K << row["k1"], 0.0, 0.0, row["k2"];
    point.C.coefficients = {row["c111"], row["c112"], row["c122"], row["c222"]};
    EXPECT_NEAR(point.p.x() * point.p.x() + point.p.y() * point.p.y() / 0.64 +
                    point.p.z() * point.p.z() / 0.36,
                1.0, 1e-5);
    EXPECT_GE(row["k1"], row["k2"]);
    EXPECT_GT(row["k2"], 0.0);
    const auto seen = apparentCurvature(seenFrom(point, w));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(row["nw"], point.n.dot(w), 1e-12);
    EXPECT_NEAR(row["lambda"], seen->lambda, 1e-9 * seen->lambda);
    const double size = std::abs(seen->feature) + std::abs(seen->offset);
    EXPECT_NEAR(row["feature"], seen->feature, 1e-6 * size);
    EXPECT_NEAR(row["offset"], seen->offset, 1e-6 * size);
    EXPECT_EQ(row["perspective"], 0.0);
  }
}

TEST(FieldsCommand, PlyIsAMeshOfItsOwn) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "fields.ply";
  ASSERT_EQ(run({"fields", "solid:torus:16", "-o", file, "--estimator", "one-ring", "--perspective",
                 "40"})
                .exitCode,
            0);
  const BuiltMesh again = loadMesh(file);
  EXPECT_EQ(again.mesh.vertexCount(), 256u);
  EXPECT_EQ(again.mesh.triangleCount(), 512u);
  EXPECT_TRUE(again.report.sentences().empty());
}

TEST(ConvergenceCommand, PrintsATableAndWritesTheDiagram) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "c.svg";
  const ProgramResult result = run({"convergence", "sine-sheet", "--cells", "30,60", "-o", file});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 4 * 3);
  EXPECT_NE(result.out.find("order"), std::string::npos);
  const XmlReading reading = readXml(contentsOf(file));
  EXPECT_EQ(reading.error, std::nullopt);
  std::set<std::string> ids;
  for (const XmlElement& element : reading.elements) {
    if (element.name == "g") ids.insert(element.attributes.at("id"));
    if (element.name == "convergence") {
      const json data = json::parse(element.text);
      EXPECT_EQ(data["case"], "sine-sheet");
      EXPECT_EQ(data["series"].size(), 4u);
      EXPECT_EQ(data["series"][0]["rows"].size(), 2u);
    }
  }
  for (const char* id : {"series-jet-closed-form", "series-one-ring-one-ring", "axis"}) {
    EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(ConvergenceCommand, FindsWeakRidgesAndSaysWhatDoesNotExist) {
  const ProgramResult weak = run({"convergence", "extrusion", "--cells", "50,100"});
  ASSERT_EQ(weak.exitCode, 0) << weak.err;
  EXPECT_EQ(weak.out.find("1.0000\n"), std::string::npos) << weak.out;  // nothing missed whole
  EXPECT_NE(weak.out.find("jet       closed-form   order"), std::string::npos) << weak.out;
  // Half of what the one-ring finds is stray.
  EXPECT_NE(weak.out.find("one-ring  closed-form   no order"), std::string::npos) << weak.out;
  const ProgramResult none =
      run({"convergence", "extrusion", "--cells", "20,30", "--threshold", "1e5"});
  EXPECT_EQ(none.out.find("nan"), std::string::npos) << none.out;
  EXPECT_NE(none.out.find("-         -       -  1.0000"), std::string::npos) << none.out;
}

/// A dome over [-1/2, 1/2]^2, times `size`.
void writeDome(const std::filesystem::path& file, double size) {
  constexpr int kCells = 8;
  std::ofstream out(file);
  out << std::setprecision(17);
  for (int i = 0; i <= kCells; ++i) {
    for (int j = 0; j <= kCells; ++j) {
      const double x = 1.0 * i / kCells - 0.5, y = 1.0 * j / kCells - 0.5;
      out << "v " << size * x << ' ' << size * y << ' '
          << size * 0.3 * std::cos(3.0 * x) * std::cos(2.0 * y) << '\n';
    }
  }
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const int a = i * (kCells + 1) + j + 1, b = a + kCells + 1;
      out << "f " << a << ' ' << b << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
  }
}

// k goes with 1 / size, lambda with its square, terms with its third power: what a double holds of
// all of them is written, and no mesh gives infinities or zeros instead.
TEST(FieldsCommand, SizesScaleTheValuesOrAreRefused) {
  const TemporaryFolder folder;
  const std::string mesh = folder.path() / "dome.obj", file = folder.path() / "dome.csv";
  const auto rowsAt = [&](double size) {
    writeDome(mesh, size);
    EXPECT_EQ(run({"fields", mesh, "-o", file, "--view", "1,2,3"}).exitCode, 0);
    return rowsOf(contentsOf(file));
  };
  const auto unit = rowsAt(1.0);
  for (const double size : {0x1p-247, 0x1p-66, 0x1p100, 0x1p247}) {
    SCOPED_TRACE(size);
    auto rows = rowsAt(size);
    ASSERT_EQ(rows.size(), unit.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto expected = unit[i];
      EXPECT_EQ(rows[i]["k1"] * size, expected["k1"]);
      EXPECT_EQ(rows[i]["lambda"] * size * size, expected["lambda"]);
      EXPECT_EQ(rows[i]["feature"] * size * size * size, expected["feature"]);
      EXPECT_EQ(rows[i]["offset"] * size * size * size, expected["offset"]);
    }
  }
  for (const double size : {1e-300, 1e-100, 1e100, 1e300}) {
    SCOPED_TRACE(size);
    writeDome(mesh, size);
    for (const char* name : {"far.ply", "far.csv"}) {
      const std::string output = folder.path() / name;
      const ProgramResult refused = run({"fields", mesh, "-o", output});
      EXPECT_EQ(refused.exitCode, 1);
      EXPECT_NE(refused.err.find("dome.obj: the longest side is 1e"), std::string::npos)
          << refused.err;
      EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
      EXPECT_FALSE(std::filesystem::exists(output));
    }
    // Its lines are those of every size.
    const std::string drawing = folder.path() / "dome.json";
    ASSERT_EQ(run({"lines", mesh, "-o", drawing, "--lines", "boundaries,ridges"}).exitCode, 0);
    EXPECT_GE(json::parse(contentsOf(drawing))["polylines"].size(), 1u);
  }
}

TEST(FieldsCommand, NeverOverwritesItsMesh) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "self.ply";
  ASSERT_EQ(run({"fields", "solid:sphere:8", "-o", file}).exitCode, 0);
  const std::string before = contentsOf(file);
  const ProgramResult refused =
      run({"fields", file, "-o", (folder.path() / "." / "self.ply").string()});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_NE(refused.err.find("is the mesh itself"), std::string::npos) << refused.err;
  EXPECT_EQ(contentsOf(file), before);
}

TEST(ConvergenceCommand, TablesAgreeAndTheSeedDecides) {
  const TemporaryFolder folder;
  const auto csv = [&](const std::string& name, const std::string& seed) {
    const std::string file = folder.path() / name;
    EXPECT_EQ(
        run({"convergence", "revolution", "--cells", "40", "--seed", seed, "-o", file}).exitCode,
        0);
    return contentsOf(file);
  };
  const std::string first = csv("a.csv", "3");
  EXPECT_EQ(first, csv("b.csv", "3"));
  EXPECT_NE(first, csv("c.csv", "4"));
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 5);
  const json data = json::parse(csv("d.json", "3"));
  EXPECT_EQ(data["seed"], 3);
  EXPECT_EQ(data["series"][0]["order"], nullptr);  // one mesh has no slope
}

}  // namespace
}  // namespace flatland::test
