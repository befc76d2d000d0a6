// SPDX-License-Identifier: GPL-3.0-or-later
// Every example mesh beside the checkout, held against what the folder's index says.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core3d/io/read_mesh.h"
#include "flatland/io/input_error.h"
#include "tests/core3d/example_meshes.h"
#include "tests/core3d/mesh_check.h"

namespace flatland::test {
namespace {

namespace fs = std::filesystem;
using MeshData = ExampleMeshes;

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

constexpr double kSeconds = 1.0;  // of processor time, for a small file
constexpr long kMegabytes = 200;  // of memory at most

// The rows of an index's table, by file name.
std::map<std::string, std::vector<std::string>> indexOf(const fs::path& folder) {
  std::map<std::string, std::vector<std::string>> rows;
  std::ifstream in(folder / "INDEX.md");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| file ", 0) == 0) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 1; at < line.size();) {
      const std::size_t end = std::min(line.find('|', at), line.size());
      const std::string cell = line.substr(at, end - at);
      const std::size_t first = cell.find_first_not_of(' ');
      cells.push_back(first == std::string::npos
                          ? ""
                          : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
      at = end + 1;
    }
    rows[cells[0]] = cells;
  }
  return rows;
}

// "b=12 nme=3" -> 12 for "b"; 0 if it does not occur.
std::size_t valueOf(const std::string& text, const std::string& key) {
  std::smatch match;
  const std::regex pattern("(^| )" + key + "=([0-9]+)");
  return std::regex_search(text, match, pattern) ? std::stoul(match[2]) : 0;
}

// Connected over vertices of the file.
std::size_t componentsOf(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> root(mesh.meshVertex.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t r = find(mesh.fileVertex[a]);
    root[find(mesh.fileVertex[b])] = r;
    root[find(mesh.fileVertex[c])] = find(r);
  }
  std::set<std::uint32_t> roots;
  for (const std::uint32_t v : mesh.fileVertex) roots.insert(find(v));
  return roots.size();
}

TEST_F(MeshData, RealMeshesHaveTheTopologyOfTheirIndex) {
  const fs::path folder = dataFolder() / "meshes";
  const auto rows = indexOf(folder);
  ASSERT_GE(rows.size(), 21u);
  for (const auto& [name, row] : rows) {
    SCOPED_TRACE(name);
    const BuiltMesh built = loadMesh(folder / name);
    const MeshReport& report = built.report;
    expectSound(built.mesh);
    if (HasFatalFailure()) return;
    // Columns: file, format, V, T, polys, topology, comps, chi, dup, oddities.
    const std::size_t degenerate = valueOf(row[9], "degidx");
    EXPECT_EQ(built.mesh.triangleCount() + degenerate, std::stoul(row[3]));
    EXPECT_EQ(report.collapsedTriangles, degenerate);
    EXPECT_EQ(report.nonManifoldEdges, valueOf(row[5], "nme"));
    EXPECT_EQ(componentsOf(built.mesh), std::stoul(row[6]));
    const long chi =
        static_cast<long>(report.fileVertices - report.isolatedVertices - report.weldedVertices) -
        static_cast<long>(report.edges) + static_cast<long>(built.mesh.triangleCount());
    EXPECT_EQ(chi, std::stol(row[7]));
    if (name == "featuretype.stl") {
      // The index welds equal numbers. This file writes some vertices with different last digits
      // (float, one part in 10^7 of its size), which normalising makes equal: its 288 slits close.
      EXPECT_EQ(report.borderEdges, 0u);
      EXPECT_EQ(report.weldedVertices, std::stoul(row[8]) + 288);
    } else {
      EXPECT_EQ(report.borderEdges, valueOf(row[5], "b"));
      EXPECT_EQ(report.weldedVertices, std::stoul(row[8]));
    }
    if (report.borderEdges == 0 && report.nonManifoldEdges == 0) {
      EXPECT_GT(sixfoldVolume(built.mesh), 0.0);
    }
  }
}

enum class Outcome { Loads, Error };

struct Expectation {
  Outcome outcome;
  std::optional<std::size_t> triangles{};
  const char* message = "";  // of an error: what must occur in it
};

// The index's wishes, decided where it leaves a choice.
const std::map<std::string, Expectation> kMessy = {
    {"geo_all_coincident.obj", {Outcome::Error, {}, "all faces lie at one point"}},
    {"geo_bowtie_vertex.obj", {Outcome::Loads, 2}},
    {"geo_duplicate_faces.obj", {Outcome::Loads, 320}},
    {"geo_flat_plane.obj", {Outcome::Loads, {}}},
    {"geo_flipped.off", {Outcome::Loads, 320}},
    {"geo_huge_scale.ply", {Outcome::Loads, 320}},
    {"geo_isolated_vertices.ply", {Outcome::Loads, 320}},
    {"geo_mixed_winding.off", {Outcome::Loads, 320}},
    {"geo_mobius.obj", {Outcome::Loads, {}}},
    {"geo_nonmanifold_edge.obj", {Outcome::Loads, 4}},
    {"geo_nonmanifold_vertex.obj", {Outcome::Loads, 640}},
    {"geo_soup_unwelded.ply", {Outcome::Loads, 320}},
    {"geo_tiny_scale.obj", {Outcome::Loads, 320}},
    {"geo_zero_area.obj", {Outcome::Loads, 320}},
    {"glb_huge_chunk.glb", {Outcome::Error, {}, "byte 12"}},
    {"obj_binary_garbage.obj", {Outcome::Error, {}, "line 1"}},
    {"obj_crlf_tabs_continuation.obj", {Outcome::Loads, 1}},
    {"obj_garbage_numbers.obj", {Outcome::Error, {}, "line 1"}},
    {"obj_index_out_of_range.obj", {Outcome::Error, {}, "line"}},
    {"obj_lines_points.obj", {Outcome::Loads, 1}},
    {"obj_long_line.obj", {Outcome::Loads, 1}},
    {"obj_negative_indices.obj", {Outcome::Loads, 2}},
    {"obj_ngon_5000.obj", {Outcome::Loads, 4998}},
    {"obj_only_comments.obj", {Outcome::Error, {}, "no faces"}},
    {"obj_quads_ngons_concave.obj", {Outcome::Loads, 9}},
    {"obj_two_vertex_face.obj", {Outcome::Loads, 1}},
    {"obj_utf8_bom.obj", {Outcome::Loads, 1}},
    {"off_coff.off", {Outcome::Loads, 1}},
    {"off_comments_header_line.off", {Outcome::Loads, 1}},
    {"off_index_range.off", {Outcome::Error, {}, "line"}},
    {"off_no_magic.off", {Outcome::Loads, 320}},
    {"ply_ascii_int_out_of_range.ply", {Outcome::Error, {}, "99999"}},
    {"ply_ascii_nan_word.ply", {Outcome::Error, {}, "line 10"}},
    {"ply_bin_truncated_faces.ply", {Outcome::Error, {}, "byte"}},
    {"ply_bin_truncated_vertices.ply", {Outcome::Error, {}, "byte"}},
    {"ply_extra_props_reordered.ply", {Outcome::Loads, 1}},
    {"ply_header_only_no_end.ply", {Outcome::Error, {}, "end_header"}},
    {"ply_huge_face_list.ply", {Outcome::Error, {}, "4294967295"}},
    {"ply_named_obj.obj", {Outcome::Loads, 1}},
    {"ply_negative_count.ply", {Outcome::Error, {}, "line 3"}},
    {"ply_negative_index.ply", {Outcome::Error, {}, "-1"}},
    {"ply_no_z.ply", {Outcome::Error, {}, "no z"}},
    {"ply_overflow_count.ply", {Outcome::Error, {}, "line 3"}},
    {"ply_unknown_format.ply", {Outcome::Error, {}, "line 2"}},
    {"stl_ascii_bad_vertex.stl", {Outcome::Error, {}, "line 5"}},
    {"stl_ascii_no_endsolid.stl", {Outcome::Loads, 320}},
    {"stl_bin_count_too_big.stl", {Outcome::Error, {}, "4294967295"}},
    {"stl_bin_starts_with_solid.stl", {Outcome::Loads, 320}},
    {"stl_bin_truncated.stl", {Outcome::Error, {}, "319"}},
    {"stl_empty.stl", {Outcome::Error, {}, "empty"}},
    {"stl_gzip.stl", {Outcome::Error, {}, "gzip"}},
    {"stl_two_solids.stl", {Outcome::Loads, 2}},
};

TEST_F(MeshData, MessyMeshesBehaveAsTheirIndexSays) {
  const fs::path folder = dataFolder() / "messy";
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name == "INDEX.md") continue;
    SCOPED_TRACE(name);
    ++files;
    const auto found = kMessy.find(name);
    ASSERT_NE(found, kMessy.end()) << "no expectation";
    const Expectation& expected = found->second;
    const std::clock_t start = std::clock();
    try {
      const BuiltMesh built = loadMesh(entry.path());
      EXPECT_EQ(expected.outcome, Outcome::Loads);
      expectSound(built.mesh);
      if (HasFatalFailure()) return;
      if (expected.triangles) {
        EXPECT_EQ(built.mesh.triangleCount(), *expected.triangles);
      }
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(expected.outcome, Outcome::Error) << message;
      EXPECT_NE(message.find(expected.message), std::string::npos) << message;
      EXPECT_EQ(message.rfind(entry.path().string() + ": ", 0), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      for (const char c : message) EXPECT_TRUE(c >= ' ' && c <= '~') << message;
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kSanitized ? 10.0 * kSeconds : kSeconds);
  }
  EXPECT_EQ(files, 52u);
  EXPECT_EQ(kMessy.size(), 52u);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  if (!kSanitized) {
    EXPECT_LT(usage.ru_maxrss / 1024, kMegabytes);
  }
}

TEST_F(MeshData, SpheresAreOneSphereWhateverIsWrongWithTheFile) {
  for (const char* name : {"geo_flipped.off", "geo_huge_scale.ply", "geo_isolated_vertices.ply",
                           "geo_mixed_winding.off", "geo_soup_unwelded.ply", "geo_tiny_scale.obj",
                           "geo_duplicate_faces.obj", "stl_bin_starts_with_solid.stl",
                           "stl_ascii_no_endsolid.stl", "geo_zero_area.obj"}) {
    SCOPED_TRACE(name);
    const auto [mesh, report] = loadMesh(dataFolder() / "messy" / name);
    EXPECT_EQ(mesh.vertexCount(), 162u);
    EXPECT_EQ(mesh.triangleCount(), 320u);
    EXPECT_EQ(report.borderEdges, 0u);
    EXPECT_EQ(report.pieces, 1u);
    double low = 10.0, high = 0.0;
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      low = std::min(low, mesh.position(v).cast<double>().norm());
      high = std::max(high, mesh.position(v).cast<double>().norm());
    }
    EXPECT_NEAR(low, high, 1e-6);  // the file's digits
    // Of the inscribed polyhedron: a little less than 4 pi / 3 R^3.
    const double sphere = 8.0 * 3.14159265 * high * high * high;
    EXPECT_GT(sixfoldVolume(mesh), 0.95 * sphere);
    EXPECT_LT(sixfoldVolume(mesh), sphere);
  }
}

TEST_F(MeshData, MessyMeshesAreReportedInWords) {
  const auto report = [](const char* name) {
    return loadMesh(dataFolder() / "messy" / name).report;
  };
  EXPECT_EQ(report("geo_flipped.off").invertedPieces, 1u);
  EXPECT_EQ(report("geo_duplicate_faces.obj").duplicateTriangles, 60u);
  EXPECT_EQ(report("geo_isolated_vertices.ply").isolatedVertices, 6u);
  EXPECT_EQ(report("geo_soup_unwelded.ply").weldedVertices, 960u - 162u);
  EXPECT_GT(report("geo_mixed_winding.off").turnedTriangles, 100u);
  EXPECT_GT(report("geo_mobius.obj").unorientableEdges, 0u);
  EXPECT_EQ(report("geo_nonmanifold_edge.obj").nonManifoldEdges, 1u);
  EXPECT_EQ(report("geo_bowtie_vertex.obj").nonManifoldVertices, 1u);
  const MeshReport zero = report("geo_zero_area.obj");
  EXPECT_EQ(zero.collapsedTriangles + zero.strayTriangles, 4u);
  EXPECT_EQ(report("obj_two_vertex_face.obj").sentences().size(), 1u);
  EXPECT_TRUE(report("obj_negative_indices.obj").sentences().empty());
}

TEST_F(MeshData, ConcavePolygonsKeepTheirArea) {
  const auto [mesh, report] = loadMesh(dataFolder() / "messy" / "obj_quads_ngons_concave.obj");
  EXPECT_NEAR(areaInFile(mesh), 17.75, 1e-5);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f p = mesh.position(a);
    EXPECT_GT((mesh.position(b) - p).cross(mesh.position(c) - p).z(), 0.0f);
  }
  EXPECT_TRUE(report.sentences().empty());
}

}  // namespace
}  // namespace flatland::test
