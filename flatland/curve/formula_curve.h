// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flatland/curve/expression.h"
#include "flatland/curve/families.h"
#include "flatland/curve/vec2.h"

namespace flatland {

/// What a person types: x(t) and y(t) for t from `from` to `to`, which are formulas without t.
struct TypedFormula {
  std::string x, y;
  std::string from, to;
  Expression::Constants constants;

  bool operator==(const TypedFormula&) const = default;
};

/// Which part of a formula is wrong, where and why.
struct FormulaError {
  enum class Field { X, Y, From, To, Constants, Family };
  Field field;
  int column;          ///< from 1; 0 if the field as a whole is meant
  std::string reason;  ///< for a person
};

/// A curve given by formulas: one of a family or typed, put at a place. A plain value; copies share
/// what was compiled. Derivatives are exact (taylor.h), not difference quotients.
class FormulaCurve {
 public:
  struct Result;

  /// The curve, or why there is none: the text is wrong, or somewhere in the domain there is no
  /// finite value within kLargestCoordinate (found on a fine grid, not proved).
  static Result make(const TypedFormula& formula, const Vec2& at = Vec2::Zero());
  static Result make(const FamilyCurve& curve, const Vec2& at = Vec2::Zero());

  static constexpr double kLargestCoordinate = 1e50;

  /// What the curve was made from; nullptr if it is of the other sort.
  const FamilyCurve* family() const { return std::get_if<FamilyCurve>(&shared_->source); }
  const TypedFormula* typed() const { return std::get_if<TypedFormula>(&shared_->source); }

  /// Where the origin of the formula lies in the scene.
  const Vec2& at() const { return at_; }
  FormulaCurve movedTo(const Vec2& at) const;

  int pieceCount() const { return shared_->pieceCount; }
  /// Of a typed one: if its ends meet, to 1e-12 of its size.
  bool closed() const { return shared_->closed; }

  /// t in [0, 1] on a piece; the formula's own parameter grows in proportion to it.
  Vec2 pointAt(int piece, double t) const;
  /// Position and derivatives by t to order 4. Where one does not exist, the derivatives are those
  /// of a place 2^-40 of the piece further inside.
  std::array<Vec2, 5> derivativesAt(int piece, double t) const;

  /// Parameters in order from 0 to pieceCount(), among them every joint, between which the curve is
  /// nearly a cubic (to 1/1000 of its size): for sampling and for coarse searches.
  const std::vector<double>& cuts() const { return shared_->cuts; }

  /// How often formulas have been evaluated by this thread: what the budgets of
  /// docs/decisions/0022-budgets.md are counted in. A place with its derivatives counts once.
  static std::uint64_t evaluations();

  bool operator==(const FormulaCurve& other) const {
    return at_ == other.at_ &&
           (shared_ == other.shared_ || shared_->source == other.shared_->source);
  }

 private:
  struct Compiled {
    std::variant<FamilyCurve, TypedFormula> source;
    Expression x, y;  ///< of a typed one
    double from = 0.0, to = 1.0;
    int pieceCount = 1;
    bool closed = false;
    std::vector<double> cuts;

    template <int N>
    void evaluate(int piece, double t, Taylor<N>& x, Taylor<N>& y) const;
  };

  FormulaCurve(std::shared_ptr<const Compiled> shared, const Vec2& at)
      : shared_(std::move(shared)), at_(at) {}
  static Result finished(std::shared_ptr<Compiled> compiled, const Vec2& at);

  std::shared_ptr<const Compiled> shared_;
  Vec2 at_;
};

struct FormulaCurve::Result {
  std::optional<FormulaCurve> curve;
  FormulaError error{FormulaError::Field::X, 0, {}};  ///< if there is no curve
};

}  // namespace flatland
