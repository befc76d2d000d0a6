// SPDX-License-Identifier: MIT
#pragma once

#include "core3d/diff/estimate_fields.h"

namespace flatland {

/// The estimate from local polynomials (bibliography: cazals2005), each over as many rings of
/// neighbours as are needed and fit (docs/math/surface_fields.md).
SurfaceFields jetFields(const TriangleMesh& mesh, const FieldOptions& options);

}  // namespace flatland
