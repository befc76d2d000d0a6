// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/diff/estimate_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core3d/diff/exact_fields.h"
#include "core3d/mesh/build_mesh.h"

namespace flatland::test {
namespace {

// Neither estimator may lose anything on a sphere: all derivatives are known by symmetry.
TEST(EstimateFields, SphereOfBothEstimators) {
  const Solid sphere{SolidKind::Sphere, 1.0};
  const SolidMesh made = meshOf(sphere, {20, true});
  const TriangleMesh mesh = buildMesh(made.soup).mesh;
  const SurfaceFields exact = exactFields(sphere, made.places, mesh);
  for (const auto estimator : {FieldEstimator::JetFit, FieldEstimator::OneRing}) {
    FieldOptions options;
    options.estimator = estimator;
    const SurfaceFields fields = estimateFields(mesh, options);
    ASSERT_EQ(fields.vertexCount(), mesh.vertexCount());
    for (std::uint32_t v = 0; v < fields.vertexCount(); ++v) {
      EXPECT_NEAR((fields.normal(v) - exact.normal(v)).norm(), 0.0, 1e-3);
      EXPECT_NEAR(fields.k1[v], exact.k1[v], 2e-3);
      EXPECT_NEAR(fields.k2[v], exact.k2[v], 2e-3);
      for (const auto* c : {&fields.c111, &fields.c112, &fields.c122, &fields.c222})
        EXPECT_NEAR((*c)[v], 0.0, 0.05);
    }
  }
}

}  // namespace
}  // namespace flatland::test
