// SPDX-License-Identifier: MIT
#include "core3d/diff/estimate_fields.h"

#include "core3d/diff/jet_fields.h"
#include "core3d/diff/one_ring.h"

namespace flatland {

SurfaceFields estimateFields(const TriangleMesh& mesh, const FieldOptions& options) {
  return options.estimator == FieldEstimator::OneRing ? oneRingFields(mesh, options)
                                                      : jetFields(mesh, options);
}

}  // namespace flatland
