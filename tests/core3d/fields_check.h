// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core3d/diff/estimate_fields.h"

namespace flatland::test {

inline constexpr FieldEstimator kBoth[] = {FieldEstimator::JetFit, FieldEstimator::OneRing};

inline FieldOptions with(FieldEstimator estimator, double scale = 1.0, int threads = 1) {
  FieldOptions options;
  options.estimator = estimator;
  options.scale = scale;
  options.threads = threads;
  return options;
}

inline std::array<const std::vector<float>*, 12> arraysOf(const SurfaceFields& f) {
  return {&f.nx, &f.ny, &f.nz,   &f.e1x,  &f.e1y,  &f.e1z,
          &f.k1, &f.k2, &f.c111, &f.c112, &f.c122, &f.c222};
}

}  // namespace flatland::test
