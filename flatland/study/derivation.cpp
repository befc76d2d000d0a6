// SPDX-License-Identifier: MIT
#include "flatland/study/derivation.h"

#include <algorithm>
#include <cassert>

#include "flatland/study/derivation_parts.h"

namespace flatland {

namespace {

using derivation::Evaluation;
using derivation::SizedSides;

constexpr std::string_view kInT = "step in the parameter t";
constexpr std::string_view kOnScreen = "step on the screen";

// In the order of DerivationStep.
constexpr std::array<DerivationStepText, kDerivationStepCount> kTexts{{
    {"3.1", "The normal, seen from the screen", "n·dn/di", "0", "", "", kInT},
    {"3.2", "From the screen back to the curve", "g(g⁻¹(i))", "i", "", "", ""},
    {"3.3", "Where a vector is longest", "d(v·v)/di", "2 v·dv/di", "", "", kInT},
    {"3.4", "The chain rule", "dn/di", "dn/du · du/di", "", "", kInT},
    {"3.5", "Curvature", "dn/du", "k", "", "", kInT},
    {"3.6", "Foreshortening", "du/di", "−1/(n·j)", "", "", kInT},
    {"3.7", "View-dependent curvature", "dn/di", "−k/(n·j)", "", "", kInT},
    {"3.8", "The derivative that is wanted", "d²n/di²", "d/di (−k/(n·j))", "", "", kInT},
    {"3.9", "Its numerator", "−dk/di", "dk/du /(n·j)", "", "", kInT},
    {"3.10", "Its denominator", "d(n·j)/di", "−(k·j)/(n·j)", "d(n·j)/di", "+(k·j)/(n·j)", kInT},
    {"3.11", "The second derivative", "d²n/di²", "[dk/du − k (k·j)/(n·j)]/(n·j)²", "d²n/di²",
     "[dk/du + k² j/(n·j)]/(n·j)²", kInT},
    {"3.12", "First times second", "½ dλ/di", "−[k·dk/du − k² (k·j)/(n·j)]/(n·j)³", "½ dλ/di",
     "−[k·dk/du + k² (k·j)/(n·j)]/(n·j)³", kInT},
    {"3.13", "The apparent-ridge equation", "−½ (n·j)⁴ dλ/di", "(n·j)(k·dk/du) − k² (k·j)",
     "½ (n·j)⁴ dλ/di", "−(n·j)(k·dk/du) − k² (k·j)", kInT},
    {"footnote", "The derivative of an inverse", "D(P⁻¹)", "−P⁻¹ (DP) P⁻¹", "D(P⁻¹)",
     "+P⁻¹ (DP) P⁻¹", kOnScreen},
    {"4.7", "The derivative of the projection", "DP", "−(Uᵀn)(K r)ᵀ", "DP, principal",
     "Uᵀ (t₂, −t₁) C(t₁,t₂,r)/Δλ", kOnScreen},
    {"4.8", "The derivative of λ", "D λ", "2 t_A·Qᵀ[(C r)P⁻¹ − K P⁻¹(DP)P⁻¹] t_A", "D λ",
     "2 t_A·Qᵀ[(C r)P⁻¹ + K P⁻¹(DP)P⁻¹] t_A", kOnScreen},
    {"sheet", "Feature plus offset", "½ D λ", "C(r,r,Kr) − K(r,r) K(Kr,w)/(n·w)", "", "",
     kOnScreen},
    {"curve", "Flatland again", "½ D λ", "C(r,r,Kr) − K(r,r) K(Kr,w)/(n·w)", "", "", kInT},
}};

bool onSheet(DerivationStep step) {
  return step >= DerivationStep::Footnote && step <= DerivationStep::SheetForm;
}

StepValue valueFrom(const SizedSides& sides, const std::vector<Sized>& entries) {
  StepValue value{sides.rows, sides.columns, {}};
  assert(static_cast<int>(entries.size()) == value.count());
  for (std::size_t i = 0; i < entries.size(); ++i) value.entries[i] = entries[i].value;
  return value;
}

StepSides sidesFrom(const SizedSides& sides) {
  double distance = 0.0, size = 0.0, reach = 0.0;
  for (std::size_t i = 0; i < sides.left.size(); ++i) {
    const Sized &left = sides.left[i], &right = sides.right[i];
    distance = std::max(distance, std::abs(left.value - right.value));
    size = std::max(size, left.size + right.size);
    reach = std::max(reach, std::abs(left.value) + std::abs(right.value));
  }
  const auto over = [distance](double scale) { return distance > 0.0 ? distance / scale : 0.0; };
  return {valueFrom(sides, sides.left), valueFrom(sides, sides.right), over(size), over(reach)};
}

}  // namespace

const DerivationStepText& textOf(DerivationStep step) {
  return kTexts[static_cast<std::size_t>(step)];
}

std::optional<DerivationStep> derivationStepNamed(std::string_view id) {
  for (std::size_t i = 0; i < kTexts.size(); ++i) {
    if (kTexts[i].id == id) return static_cast<DerivationStep>(i);
  }
  return std::nullopt;
}

StepReading readStep(DerivationStep step, const DerivationPlace& place) {
  const Evaluation found = onSheet(step) ? derivation::evaluateSheet(step, place)
                                         : derivation::evaluatePlane(step, place);
  return derivation::readingFrom(found);
}

std::vector<StepDifference> stepSizeSweep(DerivationStep step, const DerivationPlace& place) {
  return onSheet(step) ? derivation::sweepSheet(step, place) : derivation::sweepPlane(step, place);
}

namespace derivation {

StepReading readingFrom(const Evaluation& found) {
  StepReading reading{found.answer, std::nullopt, std::nullopt};
  if (found.corrected) reading.corrected = sidesFrom(*found.corrected);
  if (found.printed) reading.printed = sidesFrom(*found.printed);
  return reading;
}

LocalPlace localPlace(const DerivationPlace& place) {
  const int pieces = pieceCount(place.curve);
  const int piece = std::clamp(static_cast<int>(std::floor(place.t)), 0, pieces - 1);
  return {piece, std::clamp(place.t - piece, 0.0, 1.0)};
}

ViewFrame frozenView(const DerivationPlace& place, const Vec2& point) {
  const Vec2 w = towardsViewer(place.view, point);
  return {-rotateCcw(w), w, std::nullopt};
}

Stencil stencilFor(double h, double low, double high) {
  if (h <= std::min(-low, high)) return {{h, -h, 0.0}, {1.0, -1.0, 0.0}, 2};
  const double s = high >= -low ? h : -h;
  return {{0.0, s, 2.0 * s}, {-3.0, 4.0, -1.0}, 3};
}

std::vector<double> stepSizes(double largest, double low, double high) {
  constexpr int kPerDecade = 3, kDecades = 12;
  // Symmetric where there is room enough for a sweep, else one-sided with two steps.
  constexpr double kRoomEnough = 1e-3;
  const double symmetric = std::min(-low, high);
  const double room = symmetric >= kRoomEnough * largest ? symmetric : 0.5 * std::max(-low, high);
  const double first = std::min(largest, room);
  std::vector<double> sizes;
  for (int i = 0; i <= kPerDecade * kDecades; ++i) {
    sizes.push_back(first * std::pow(10.0, -static_cast<double>(i) / kPerDecade));
  }
  return sizes;
}

double distanceFrom(const std::vector<double>& quotient, const SizedSides& sides) {
  double distance = 0.0, size = 0.0, reach = 0.0;
  for (std::size_t i = 0; i < quotient.size(); ++i) {
    distance = std::max(distance, std::abs(quotient[i] - sides.right[i].value));
    size = std::max(size, sides.left[i].size + sides.right[i].size);
    reach = std::max(reach, std::abs(sides.left[i].value) + std::abs(sides.right[i].value));
  }
  // Where both sides vanish, as at an inflection, the products they are made of give the scale.
  constexpr double kNothingLeft = 1e-9;
  const double scale = reach > kNothingLeft * size ? reach : size;
  return scale > 0.0 ? distance / scale : distance;
}

}  // namespace derivation

}  // namespace flatland
