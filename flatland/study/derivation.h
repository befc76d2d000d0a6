// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "flatland/curve/curve.h"
#include "flatland/view/view.h"

namespace flatland {

/// The steps of the derivation of the apparent-ridge equation (bibliography: judd2007thesis,
/// chapters 3 and 4), in its order and by its numbers; then the form without dimension
/// (docs/math/derivation.md). Footnote to SheetForm are evaluated on a sheet through the curve.
enum class DerivationStep {
  Eq3_1,      ///< n as a function of the place i on the screen
  Eq3_2,      ///< u = g^-1(i)
  Eq3_3,      ///< extrema of the length of a vector
  Eq3_4,      ///< chain rule
  Eq3_5,      ///< dn/du = k
  Eq3_6,      ///< foreshortening
  Eq3_7,      ///< view-dependent curvature
  Eq3_8,      ///< its derivative, wanted
  Eq3_9,      ///< derivative of the numerator
  Eq3_10,     ///< derivative of the denominator; misprinted
  Eq3_11,     ///< second derivative; misprinted
  Eq3_12,     ///< product of both; follows from the misprint
  Eq3_13,     ///< the apparent-ridge equation; misprinted
  Footnote,   ///< derivative of P^-1; misprinted
  Eq4_7,      ///< derivative of P; misprinted
  Eq4_8,      ///< derivative of lambda; misprinted
  SheetForm,  ///< feature plus offset, for a surface
  CurveForm,  ///< the same with D = 1: (3.13) again
};
inline constexpr int kDerivationStepCount = 18;

/// What a step is called and what its sides are, in plain text.
struct DerivationStepText {
  std::string_view id;     ///< "3.10", "footnote", "sheet": in files and on the command line
  std::string_view title;  ///< in words
  std::string_view left;   ///< the side found from its definition
  std::string_view right;  ///< the side the derivation gives
  std::string_view printedLeft, printedRight;  ///< as printed in the thesis; empty: as above
  std::string_view step;  ///< what the step size of the difference quotient is; empty: has none

  bool isMisprinted() const { return !printedRight.empty(); }
};
const DerivationStepText& textOf(DerivationStep step);
std::optional<DerivationStep> derivationStepNamed(std::string_view id);

/// A place on a curve and from where it is seen. `side` is that of normalSide().
struct DerivationPlace {
  const Curve& curve;
  double t;
  ViewFrame view;
  int side;
};

/// A number (1 x 1), a vector (rows x 1) or a 2 x 2 matrix, row by row.
struct StepValue {
  int rows = 1, columns = 1;
  std::array<double, 4> entries{};

  int count() const { return rows * columns; }
};

/// Both sides of a step. `residual` is the largest |left - right| of their entries over the sum of
/// the absolute values of the products both were computed from: about 1e-16 where the equation
/// holds; 0 where both are exactly 0. `apart` is the plain relative distance, over the largest
/// |left| + |right|: 0 where they agree, 1 where one is the other with the wrong sign; it says
/// nothing where both are small differences of large numbers.
struct StepSides {
  StepValue left, right;
  double residual;
  double apart;
};

enum class StepAnswer {
  Evaluated,
  NoTangent,    ///< a cusp: there is no normal
  Silhouette,   ///< n.j = 0 to rounding: nothing by i exists, lambda has no finite value
  NoNormal,     ///< of a surface: unknown at this vertex
  NoDirection,  ///< of a surface: it bends alike in all directions as seen, or not at all, so that
                ///< there is no t_A
};

/// A step at a place. The sides are empty where `answer` says why; `printed` also where the thesis
/// prints what is right or, on a surface, has no principal directions to speak of. At an inflection
/// k = 0: both sides vanish, printed and corrected alike.
struct StepReading {
  StepAnswer answer = StepAnswer::Evaluated;
  std::optional<StepSides> corrected;
  std::optional<StepSides> printed;
};

/// Evaluates a step. The left side is differentiated from its definition (study/series.h), not by
/// the formula it is held against. The curve is walked so that its normal lies to the right of the
/// tangent, as the signs of (3.6) require; in perspective j is the line of sight through the place,
/// kept fixed, but for CurveForm, which has the perspective term. Precondition: t in the domain.
StepReading readStep(DerivationStep step, const DerivationPlace& place);

/// A difference quotient of the left side's definition, the curve evaluated anew at both ends.
struct StepDifference {
  double h;                       ///< the step size, see DerivationStepText::step
  double corrected;               ///< relative distance from the right side
  std::optional<double> printed;  ///< the same for the side as printed
};

/// Quotients for falling step sizes, three a decade: symmetric, or one-sided where the piece of the
/// curve ends; both of order 2. Truncation falls with slope 2 until rounding rises with slope -1.
/// Empty where readStep() has no answer, and for Eq3_2.
std::vector<StepDifference> stepSizeSweep(DerivationStep step, const DerivationPlace& place);

}  // namespace flatland
