// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flatland/curve/taylor.h"

namespace flatland {

/// A number that shapes a curve of a family.
struct FamilyParameter {
  std::string id;       ///< as in scene files: "a"
  std::string meaning;  ///< for people: "half axis along x"
  double initial;
  double low, high;    ///< a sensible range, for a slider
  double least, most;  ///< what is admissible
  bool whole = false;  ///< only whole numbers
};

/// Curves given by the same formula. Closed ones are walked counter-clockwise, open ones from left
/// to right; all stand around the origin.
struct Family {
  enum class Id { Circle, Ellipse, Parabola, Sine, Gaussian, Superellipse, Lissajous, Cycloid };
  Id id;
  std::string name;     ///< as in scene files: "ellipse"
  std::string title;    ///< for people: "Ellipse"
  std::string formula;  ///< for people: "x = a cos t, y = b sin t"
  bool closed;
  std::vector<FamilyParameter> parameters;
};

/// All families, in menu order.
const std::vector<Family>& families();
const Family* familyNamed(const std::string& name);

/// One curve of a family: a value for each of its parameters, in their order.
struct FamilyCurve {
  Family::Id family;
  std::vector<double> parameters;

  bool operator==(const FamilyCurve&) const = default;
};

const Family& familyOf(const FamilyCurve& curve);

/// The curve with the initial values.
FamilyCurve initialCurve(const Family& family);

/// Why there is no such curve, in words for a person; nullopt if there is.
std::optional<std::string> whyInvalid(const FamilyCurve& curve);

/// Pieces that are smooth inside: a superellipse has 4, a cycloid one for each arch.
int pieceCount(const FamilyCurve& curve);

/// Position on a piece, t in [0, 1] given as a series. Derivatives that do not exist (at the ends
/// of a superellipse's pieces) are not finite. Precondition: a valid curve.
template <int N>
void evaluate(const FamilyCurve& curve, int piece, const Taylor<N>& t, Taylor<N>& x, Taylor<N>& y);

extern template void evaluate(const FamilyCurve&, int, const Taylor<0>&, Taylor<0>&, Taylor<0>&);
extern template void evaluate(const FamilyCurve&, int, const Taylor<4>&, Taylor<4>&, Taylor<4>&);

}  // namespace flatland
