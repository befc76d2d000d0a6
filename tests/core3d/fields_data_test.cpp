// SPDX-License-Identifier: GPL-3.0-or-later
// Both estimators on every example mesh beside the checkout.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <iomanip>
#include <iostream>

#include "core3d/diff/estimate_fields.h"
#include "core3d/io/read_mesh.h"
#include "tests/core3d/example_meshes.h"

namespace flatland::test {
namespace {

using FieldsData = ExampleMeshes;

TEST_F(FieldsData, AreFiniteOnEveryMesh) {
  std::size_t meshes = 0;
  for (const char* folder : {"meshes", "messy"}) {
    for (const auto& entry : std::filesystem::directory_iterator(dataFolder() / folder)) {
      const std::string name = entry.path().filename().string();
      if (name == "INDEX.md" || name == "preview.png") continue;
      SCOPED_TRACE(name);
      TriangleMesh mesh;
      try {
        mesh = loadMesh(entry.path()).mesh;
      } catch (const std::exception&) {
        continue;  // what must load is mesh_data_test's matter
      }
      ++meshes;
      for (const auto estimator : {FieldEstimator::JetFit, FieldEstimator::OneRing}) {
        FieldOptions options;
        options.estimator = estimator;
        options.threads = 2;
        const std::clock_t start = std::clock();
        const SurfaceFields fields = estimateFields(mesh, options);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        std::cout << std::left << std::setw(34) << name << std::right << std::setw(9)
                  << mesh.triangleCount() << " triangles, "
                  << (estimator == FieldEstimator::JetFit ? "jet fit " : "one-ring ") << std::fixed
                  << std::setprecision(3) << seconds << " s of processor time\n";
        ASSERT_EQ(fields.vertexCount(), mesh.vertexCount());
        EXPECT_TRUE(fields.size > 0.0 && fields.size < 2.0);
        std::size_t bad = 0, without = 0;
        for (std::uint32_t v = 0; v < fields.vertexCount(); ++v) {
          const SurfacePoint p = fields.at(mesh, v);
          const auto& c = p.C.coefficients;
          if (!p.n.allFinite() || !p.frame.allFinite() || !p.K.allFinite() ||
              !std::isfinite(c[0] + c[1] + c[2] + c[3]) || p.K(0, 0) < p.K(1, 1)) {
            ++bad;
          }
          const double length = p.n.norm();
          if (length == 0.0) {
            ++without;
          } else if (std::abs(length - 1.0) > 1e-5 ||
                     std::abs(p.frame.col(0).norm() - 1.0) > 1e-5 ||
                     std::abs(p.frame.col(0).dot(p.n)) > 1e-5) {
            ++bad;
          }
        }
        EXPECT_EQ(bad, 0u);
        EXPECT_LE(without, 1 + mesh.vertexCount() / 100);
      }
    }
  }
  EXPECT_GE(meshes, 21u);
}

}  // namespace
}  // namespace flatland::test
