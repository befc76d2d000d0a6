// SPDX-License-Identifier: MIT
#include "flatland/study/probe_geometry.h"

#include <algorithm>
#include <cmath>

namespace flatland {

namespace {

// What divides by a number this much smaller than its natural size divides by rounding.
constexpr double kZero = 1e-9;

constexpr int kPieceSteps = 256;  // to measure a piece by
constexpr int kMostTeeth = 2000;

std::optional<CombTooth> toothAt(const Curve& curve, int piece, double t, double scale,
                                 double longest) {
  const Jet jet = jetAt(curve, piece, t);
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  const Frame frame = frameOf(jet);
  // The product does not depend on the side of the normal.
  const double length = std::clamp(scale * frame.k, -longest, longest);
  if (!std::isfinite(length)) return std::nullopt;
  return CombTooth{jet.p, jet.p + length * frame.normal};
}

}  // namespace

std::optional<double> lambdaAt(const Terms& terms) {
  return std::abs(terms.nw) > kSilhouetteNw ? terms.lambda : std::nullopt;
}

std::optional<double> screenTurnAt(const Terms& terms) {
  if (!(std::abs(terms.nw) > kSilhouetteNw)) return std::nullopt;
  return terms.k / std::abs(terms.nw);
}

std::optional<double> termRatioAt(const Terms& terms, double size) {
  const double natural = terms.k * terms.k + 1.0 / (size * size);  // of k'
  if (!(std::abs(terms.nw) > kSilhouetteNw)) return std::nullopt;
  if (!(std::abs(terms.kPrime) > kZero * natural)) return std::nullopt;
  // k cancels, so an inflection is no 0 / 0.
  const double ratio = terms.k * terms.k * std::abs(terms.tw) / std::abs(terms.nw * terms.kPrime);
  return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

std::optional<OsculatingCircle> osculatingCircle(const Jet& jet, double largest) {
  const Frame frame = frameOf(jet);
  if (!(std::abs(frame.k) * largest >= 1.0)) return std::nullopt;
  return OsculatingCircle{jet.p - frame.normal / frame.k, 1.0 / std::abs(frame.k)};
}

std::vector<std::vector<CombTooth>> curvatureComb(const Curve& curve, double spacing, double scale,
                                                  double longest) {
  std::vector<std::vector<CombTooth>> combs;
  for (int piece = 0; piece < pieceCount(curve); ++piece) {
    // Chords measure the piece well enough to spread teeth evenly.
    std::vector<double> lengths{0.0};
    Vec2 last = jetAt(curve, piece, 0.0).p;
    for (int i = 1; i <= kPieceSteps; ++i) {
      const Vec2 p = jetAt(curve, piece, static_cast<double>(i) / kPieceSteps).p;
      lengths.push_back(lengths.back() + (p - last).norm());
      last = p;
    }
    const double length = lengths.back();
    if (!(length > 0.0)) continue;
    const int count =
        static_cast<int>(std::clamp(std::round(length / spacing), 1.0, 1.0 * kMostTeeth));
    std::vector<CombTooth>& comb = combs.emplace_back();
    std::size_t step = 1;
    for (int i = 0; i <= count; ++i) {
      const double wanted = length * i / count;
      while (step + 1 < lengths.size() && lengths[step] < wanted) ++step;
      const double width = lengths[step] - lengths[step - 1];
      const double share = width > 0.0 ? (wanted - lengths[step - 1]) / width : 0.0;
      const double t =
          std::clamp((static_cast<double>(step) - 1.0 + share) / kPieceSteps, 0.0, 1.0);
      if (const auto tooth = toothAt(curve, piece, t, scale, longest)) comb.push_back(*tooth);
    }
  }
  return combs;
}

}  // namespace flatland
