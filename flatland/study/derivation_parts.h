// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "flatland/study/derivation.h"
#include "flatland/study/series.h"

namespace flatland::derivation {

// What the two halves of the derivation share, the plane curve and the sheet. Not for others.

/// Both sides of a step as numbers that know their size; entries as in StepValue.
struct SizedSides {
  int rows = 1, columns = 1;
  std::vector<Sized> left, right;
};

/// A step, as far as it could be evaluated, in both variants.
struct Evaluation {
  StepAnswer answer = StepAnswer::Evaluated;
  std::optional<SizedSides> corrected, printed;
};

/// What a person gets of it.
StepReading readingFrom(const Evaluation& found);

/// Left and right of a variant as difference quotients for step `h` see it: its left side anew.
struct Quotient {
  std::vector<double> corrected, printed;
};

/// True if so much cancelled that the number cannot be told from 0.
inline bool vanishes(const Sized& a) { return std::abs(a.value) <= 0x1p-49 * a.size; }

/// The piece of a curve and the parameter in it, with the room to both sides.
struct LocalPlace {
  int piece;
  double t;
};
LocalPlace localPlace(const DerivationPlace& place);

/// The line of sight through the place, kept fixed: (i, j).
ViewFrame frozenView(const DerivationPlace& place, const Vec2& point);

/// Offsets of one difference quotient of order 2: value = sum weight f(offset) / (the same of the
/// variable).
struct Stencil {
  std::array<double, 3> offsets, weights;
  int count;
};
/// Symmetric within [low, high] around 0, else towards the roomier side.
Stencil stencilFor(double h, double low, double high);
/// Step sizes, three a decade, that fit.
std::vector<double> stepSizes(double largest, double low, double high);

/// Relative distance of a quotient from a side, see StepDifference.
double distanceFrom(const std::vector<double>& quotient, const SizedSides& sides);

Evaluation evaluatePlane(DerivationStep step, const DerivationPlace& place);
std::vector<StepDifference> sweepPlane(DerivationStep step, const DerivationPlace& place);
Evaluation evaluateSheet(DerivationStep step, const DerivationPlace& place);
std::vector<StepDifference> sweepSheet(DerivationStep step, const DerivationPlace& place);

}  // namespace flatland::derivation
