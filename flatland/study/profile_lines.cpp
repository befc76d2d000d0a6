// SPDX-License-Identifier: MIT
#include "flatland/study/profile_lines.h"

#include <algorithm>
#include <cmath>

namespace flatland {

namespace {

constexpr double kSameValue = 1e-9;

// Whether the quantity is infinite or undefined somewhere between neighbouring samples: only where
// a mark could not be isolated is it not a sample.
bool breaksBetween(const ProfileSample& a, const ProfileSample& b, ProfileQuantity quantity) {
  const bool folds = a.nw * b.nw < 0.0;
  if (quantity == ProfileQuantity::Lambda) return folds;
  if (quantity == ProfileQuantity::Ratio) return folds || a.kPrime * b.kPrime < 0.0;
  return false;
}

// Whether the quantity goes on from the end of a segment to the start of the next.
bool joins(const ProfileSample& a, const ProfileSample& b, ProfileQuantity quantity) {
  const auto x = valueOf(a, quantity), y = valueOf(b, quantity);
  if (a.t != b.t || !x || !y) return false;
  return std::abs(*x - *y) <= kSameValue * (std::abs(*x) + std::abs(*y));
}

}  // namespace

std::optional<double> valueOf(const ProfileSample& sample, ProfileQuantity quantity) {
  switch (quantity) {
    case ProfileQuantity::Curvature:
      return sample.k;
    case ProfileQuantity::Lambda:
      return sample.lambda;
    case ProfileQuantity::Feature:
      return sample.feature;
    case ProfileQuantity::Offset:
      return sample.offset;
    case ProfileQuantity::Perspective:
      return sample.perspective;
    case ProfileQuantity::Sum:
      return sample.sum();
    case ProfileQuantity::Ratio:
      break;
  }
  return sample.ratio;
}

std::optional<double> abscissaOf(const ProfileSample& sample, Abscissa abscissa) {
  if (abscissa == Abscissa::ArcLength) return sample.u;
  return sample.screen;
}

std::vector<std::vector<Vec2>> linesOf(const Profile& profile, ProfileQuantity quantity,
                                       Abscissa abscissa, bool positiveOnly) {
  std::vector<std::vector<Vec2>> lines;
  const ProfileSample* last = nullptr;  // the sample the current line ends at
  for (const ProfileSegment& segment : profile.segments) {
    bool first = true;
    for (const ProfileSample& sample : segment.samples) {
      const auto x = abscissaOf(sample, abscissa);
      const auto y = valueOf(sample, quantity);
      const bool shown = x && y && std::isfinite(*y) && (!positiveOnly || *y > 0.0);
      const bool goesOn =
          shown && last &&
          (first ? joins(*last, sample, quantity) : !breaksBetween(*last, sample, quantity));
      if (shown) {
        if (!goesOn) lines.emplace_back();
        lines.back().emplace_back(*x, *y);
      }
      last = shown ? &sample : nullptr;
      first = false;
    }
  }
  std::erase_if(lines, [](const std::vector<Vec2>& line) { return line.size() < 2; });
  return lines;
}

std::vector<double> parametersAt(const Profile& profile, Abscissa abscissa, double x) {
  std::vector<double> found;
  const auto add = [&found](double t) {
    if (found.empty() || found.back() != t) found.push_back(t);
  };
  for (const ProfileSegment& segment : profile.segments) {
    for (std::size_t i = 1; i < segment.samples.size(); ++i) {
      const ProfileSample &a = segment.samples[i - 1], &b = segment.samples[i];
      const auto xa = abscissaOf(a, abscissa), xb = abscissaOf(b, abscissa);
      if (!xa || !xb || x < std::min(*xa, *xb) || x > std::max(*xa, *xb)) continue;
      add(*xa == *xb ? a.t : a.t + (x - *xa) / (*xb - *xa) * (b.t - a.t));
    }
  }
  return found;
}

std::optional<std::pair<double, double>> extentOf(const Profile& profile, Abscissa abscissa) {
  std::optional<std::pair<double, double>> extent;
  for (const ProfileSegment& segment : profile.segments) {
    for (const ProfileSample& sample : segment.samples) {
      const auto x = abscissaOf(sample, abscissa);
      if (!x) continue;
      if (!extent) extent.emplace(*x, *x);
      extent->first = std::min(extent->first, *x);
      extent->second = std::max(extent->second, *x);
    }
  }
  return extent;
}

ProfileSpread::ProfileSpread(const Profile& profile, ProfileQuantity quantity, Abscissa abscissa,
                             double low, double high, bool magnitudes) {
  for (const ProfileSegment& segment : profile.segments) {
    const auto& samples = segment.samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto x = abscissaOf(samples[i], abscissa);
      const auto y = valueOf(samples[i], quantity);
      if (!x || *x < low || *x > high || !y || !std::isfinite(*y)) continue;
      const double before = samples[i > 0 ? i - 1 : i].u;
      const double after = samples[std::min(i + 1, samples.size() - 1)].u;
      values_.emplace_back(magnitudes ? std::abs(*y) : *y, 0.5 * (after - before));
    }
  }
  std::sort(values_.begin(), values_.end());
  double total = 0.0;
  for (auto& [value, weight] : values_) weight = total += weight;
}

double ProfileSpread::quantile(double share) const {
  const double wanted = share * values_.back().second;
  const auto at = std::lower_bound(values_.begin(), values_.end(), wanted,
                                   [](const auto& entry, double w) { return entry.second < w; });
  return at == values_.end() ? values_.back().first : at->first;
}

}  // namespace flatland
