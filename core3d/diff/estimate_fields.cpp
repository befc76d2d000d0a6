// SPDX-License-Identifier: MIT
#include "core3d/diff/estimate_fields.h"

#include <cmath>

#include "core3d/diff/jet_fields.h"
#include "core3d/diff/one_ring.h"
#include "flatland/io/input_error.h"
#include "flatland/io/number_text.h"

namespace flatland {

std::string_view nameOf(FieldEstimator estimator) {
  return estimator == FieldEstimator::JetFit ? "jet" : "one-ring";
}

std::string whyNotFields(const FieldOptions& options) {
  if (!(options.scale >= 1.0) || std::isinf(options.scale)) {
    return "a scale of " + numberText(options.scale) + " is none; it is 1 or more";
  }
  if (options.estimator == FieldEstimator::OneRing && options.scale > kMostOneRingScale) {
    return "a scale of " + numberText(options.scale) +
           " is too large for the one-ring estimator; " + numberText(kMostOneRingScale) +
           " at most";
  }
  return {};
}

SurfaceFields estimateFields(const TriangleMesh& mesh, const FieldOptions& options) {
  const std::string whyNot = whyNotFields(options);
  if (!whyNot.empty()) throw InputError("curvature", "", whyNot);
  return options.estimator == FieldEstimator::OneRing ? oneRingFields(mesh, options)
                                                      : jetFields(mesh, options);
}

}  // namespace flatland
