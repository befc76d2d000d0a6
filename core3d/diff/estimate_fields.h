// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core3d/diff/surface_fields.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// How normals, K and C are estimated from the vertices around.
enum class FieldEstimator : std::uint8_t {
  JetFit,  ///< local polynomial of degree 3 or 4 (cazals2005), on a neighbourhood chosen per vertex
  OneRing,  ///< least squares over the triangles of the one-ring (rusinkiewicz2004): fast, rough
};
std::string_view nameOf(FieldEstimator estimator);  ///< "jet", "one-ring"

/// OneRing smooths scale^2 - 1 times: 99 passes.
inline constexpr double kMostOneRingScale = 10.0;

struct FieldOptions {
  FieldEstimator estimator = FieldEstimator::JetFit;
  /// How much larger than needed the neighbourhoods are, >= 1: smooths noise, and features of that
  /// width with it. Acts on JetFit; on OneRing as smoothing passes over K and C, up to
  /// kMostOneRingScale.
  double scale = 1.0;
  int threads = 0;  ///< 0: all cores. The result does not depend on it
  std::function<void(double)> progress =
      {};  ///< called with the share done, in [0, 1], never falling, by one thread at a time
  std::stop_token stop = {};  ///< asked often; a stopped estimate returns early
};

/// Why there are no fields for these options, for a person: the scale is no number >= 1, or too
/// large for OneRing. Empty if there are.
std::string whyNotFields(const FieldOptions& options);

/// The fields of a mesh; empty (no vertices) if stopped. Vertices without a normal have 0
/// throughout; nothing is ever infinite or NaN. About 4 microseconds of processor time a vertex
/// (JetFit, up to twice that on noisy meshes) or 2 (OneRing). docs/math/surface_fields.md has the
/// accuracy. Throws InputError with what whyNotFields says.
SurfaceFields estimateFields(const TriangleMesh& mesh, const FieldOptions& options = {});

}  // namespace flatland
