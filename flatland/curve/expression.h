// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flatland/curve/taylor.h"

namespace flatland {

/// Where a typed text is wrong, and why, in words for a person.
struct ExpressionError {
  int column;  ///< of the character, from 1; one past the end if something is missing there
  std::string reason;
};

/// A formula in one variable, t, read from a text and compiled to a flat program that also yields
/// exact derivatives (taylor.h). A plain value; evaluation is thread safe.
///
/// Numbers, t, pi, e and the constants given; + - * / ^ and parentheses; a sign binds less than ^
/// and more than *, so -2^2 is -4; ^ groups to the right. Functions: sin cos tan asin acos atan
/// sinh cosh tanh asinh acosh atanh exp log ln log10 sqrt abs pow(a, b) atan2(y, x) hypot(x, y).
/// log is the natural logarithm, angles are in radians.
class Expression {
 public:
  using Constants = std::map<std::string, double>;

  struct Result;

  /// Reads a text; nothing in it can do harm: its length, nesting and size are bounded. Without
  /// `variable`, t is refused.
  static Result parse(const std::string& text, const Constants& constants, bool variable = true);

  /// Why a constant cannot be called so; nullopt if it can.
  static std::optional<std::string> whyNotAName(const std::string& name);

  /// The value with its derivatives, for t given likewise. Not finite where the formula has no
  /// value.
  template <int N>
  Taylor<N> at(const Taylor<N>& t) const;

  static constexpr std::size_t kLongestText = 4000;

 private:
  friend class ExpressionParser;
  enum class Op {
    Constant,
    Variable,
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Exp,
    Log,
    Log10,
    Sqrt,
    Abs,
    Atan2,
    Hypot,
  };
  struct Step {
    Op op;
    double constant;
  };
  static constexpr std::size_t kDeepestStack = 40;

  std::vector<Step> program_;  ///< postfix
};

struct Expression::Result {
  std::optional<Expression> expression;
  ExpressionError error{0, {}};  ///< if there is no expression
};

extern template Taylor<0> Expression::at(const Taylor<0>& t) const;
extern template Taylor<4> Expression::at(const Taylor<4>& t) const;

}  // namespace flatland
