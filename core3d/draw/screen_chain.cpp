// SPDX-License-Identifier: MIT
#include "core3d/draw/screen_chain.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector2d;

constexpr double kSamplePx = 1.0;
constexpr double kPlacePx = 1.0 / 32.0;  // far below what an antialiased line shows

// See ScreenChain::judged. Single segments fail and pass by accident where a scan is rough; along a
// clear line they seldom fail for long.
constexpr double kJudgedPx = 12.0;
constexpr double kEnoughStandsOut = 0.3;

// A part of a chain, from point to point; `to` may run past the end of a closed one.
LineChain part(const LineChain& chain, std::size_t from, std::size_t to) {
  LineChain result;
  result.family = chain.family;
  result.level = chain.level;
  const std::size_t n = chain.points.size();
  for (std::size_t i = from; i <= to; ++i) {
    result.points.push_back(chain.points[i % n]);
    result.strength.push_back(chain.strength[i % n]);
    if (i == to) continue;
    result.triangles.push_back(chain.triangles[i % n]);
    if (!chain.standsOut.empty()) result.standsOut.push_back(chain.standsOut[i % n]);
  }
  return result;
}

void judge(ScreenChain& line) {
  const LineChain& chain = line.chain;
  line.judged = chain.strength;
  if (std::find(chain.standsOut.begin(), chain.standsOut.end(), false) == chain.standsOut.end()) {
    return;
  }
  // Length that stands out, from the first point to each.
  std::vector<double> clear = {0.0};
  for (std::size_t i = 0; i < chain.standsOut.size(); ++i) {
    clear.push_back(clear.back() + (chain.standsOut[i] ? line.along[i + 1] - line.along[i] : 0.0));
  }
  const double length = line.length();
  const auto clearTo = [&](double place) {
    const auto after = std::upper_bound(line.along.begin(), line.along.end() - 1, place);
    const auto next = static_cast<std::size_t>(after - line.along.begin());
    if (next == 0) return 0.0;
    const bool clearPiece = chain.standsOut[next - 1];
    return clear[next - 1] + (clearPiece ? place - line.along[next - 1] : 0.0);
  };
  const double half = std::min(kJudgedPx, length / 2.0);
  for (std::size_t i = 0; i < line.judged.size(); ++i) {
    double from = line.along[i] - half, to = line.along[i] + half, sum = 0.0, size = 2.0 * half;
    if (chain.closed) {
      if (from < 0.0) sum += clear.back() - clearTo(from + length);
      if (to > length) sum += clearTo(to - length);
    } else {
      size = std::min(to, length) - std::max(from, 0.0);
    }
    sum += clearTo(std::min(to, length)) - clearTo(std::max(from, 0.0));
    const double share = size > 0.0 ? sum / size : 0.0;
    line.judged[i] *= static_cast<float>(std::min(1.0, share / kEnoughStandsOut));
  }
}

ScreenChain measured(LineChain chain, const std::vector<std::optional<Vector2d>>& places) {
  ScreenChain result;
  result.chain = std::move(chain);
  double along = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0) along += (*places[i] - *places[i - 1]).norm();
    result.screen.push_back(*places[i]);
    result.along.push_back(along);
  }
  if (result.chain.closed) {
    result.along.push_back(along + (result.screen.front() - result.screen.back()).norm());
  }
  judge(result);
  return result;
}

// Adjacent stretches of the same kind become one. On a closed chain the last and the first are
// adjacent, and the last takes the first in.
void mergeEqual(std::vector<Stretch>& stretches, bool closed, double length) {
  std::vector<Stretch> merged;
  for (const Stretch& s : stretches) {
    if (!merged.empty() && merged.back().seen == s.seen) {
      merged.back().to = s.to;
    } else {
      merged.push_back(s);
    }
  }
  if (closed && merged.size() > 1 && merged.front().seen == merged.back().seen) {
    merged.back().to = merged.front().to + length;
    merged.erase(merged.begin());
  }
  if (merged.size() == 1) merged.front() = {0.0, length, merged.front().seen};
  stretches = std::move(merged);
}

void smooth(std::vector<Stretch>& stretches, bool closed, double length, double smallestGapPx) {
  const auto size = [](const Stretch& s) { return s.to - s.from; };
  while (stretches.size() > 1) {
    const auto shortest =
        std::min_element(stretches.begin(), stretches.end(),
                         [&size](const Stretch& a, const Stretch& b) { return size(a) < size(b); });
    if (!(size(*shortest) < smallestGapPx)) return;
    const auto i = static_cast<std::size_t>(shortest - stretches.begin());
    const std::size_t n = stretches.size();
    const Stretch* before = i > 0 || closed ? &stretches[(i + n - 1) % n] : nullptr;
    const Stretch* after = i + 1 < n || closed ? &stretches[(i + 1) % n] : nullptr;
    const bool takeBefore =
        after == nullptr || (before != nullptr && size(*before) >= size(*after));
    stretches[i].seen = (takeBefore ? before : after)->seen;
    mergeEqual(stretches, closed, length);
  }
}

}  // namespace

ScreenChain::Point ScreenChain::at(double place) const {
  const std::size_t pieces = chain.pieceCount();
  if (chain.closed && place > length()) place -= length();
  const auto after = std::upper_bound(along.begin(), along.end(), place);
  const auto next = static_cast<std::size_t>(after - along.begin());
  const std::size_t i = std::min(next > 0 ? next - 1 : 0, pieces - 1);
  const std::size_t k = (i + 1) % chain.points.size();
  const double size = along[i + 1] - along[i];
  const double share = size > 0.0 ? std::clamp((place - along[i]) / size, 0.0, 1.0) : 0.0;
  const Eigen::Vector3d a = chain.points[i].cast<double>(), b = chain.points[k].cast<double>();
  const auto weight = static_cast<float>(share);
  return {a + share * (b - a), chain.strength[i] + weight * (chain.strength[k] - chain.strength[i]),
          i};
}

std::vector<ScreenChain> onScreen(LineChain chain, const Projection& projection) {
  std::vector<std::optional<Vector2d>> places;
  const std::size_t n = chain.points.size();
  std::size_t firstBehind = n;
  for (std::size_t i = 0; i < n; ++i) {
    places.push_back(projection.toScreen(chain.points[i].cast<double>()));
    if (!places.back()) firstBehind = std::min(firstBehind, i);
  }
  std::vector<ScreenChain> result;
  const auto add = [&result](ScreenChain part) {
    if (part.length() > 0.0) result.push_back(std::move(part));
  };
  if (firstBehind == n) {
    add(measured(std::move(chain), places));
    return result;
  }
  // Once round from a point behind, or from end to end; runs of points in front become parts.
  const std::size_t start = chain.closed ? firstBehind : 0;
  const std::size_t end = start + n + (chain.closed ? 1 : 0);
  for (std::size_t i = start; i < end;) {
    std::size_t k = i;
    std::vector<std::optional<Vector2d>> run;
    for (; k < end && places[k % n]; ++k) run.push_back(places[k % n]);
    if (run.size() > 1) add(measured(part(chain, i, k - 1), run));
    i = k + 1;
  }
  return result;
}

std::vector<Stretch> stretchesOf(const ScreenChain& chain, double smallestGapPx,
                                 const std::function<Seen(const ScreenChain::Point&)>& seenAt) {
  const double length = chain.length();
  const auto samples = std::max<std::size_t>(1, static_cast<std::size_t>(length / kSamplePx));
  const double step = length / static_cast<double>(samples);
  const auto seenAtPlace = [&](double place) { return seenAt(chain.at(place)); };
  const auto middleOf = [step](std::size_t k) { return (static_cast<double>(k) + 0.5) * step; };

  std::vector<Seen> seen;
  for (std::size_t k = 0; k < samples; ++k) seen.push_back(seenAtPlace(middleOf(k)));
  // Where the answer changes between sample k and the next, and to what.
  std::vector<std::pair<double, Seen>> changes;
  for (std::size_t k = 0; k + (chain.chain.closed ? 0 : 1) < samples; ++k) {
    const Seen next = seen[(k + 1) % samples];
    if (seen[k] == next) continue;
    double low = middleOf(k), high = low + step;
    while (high - low > kPlacePx) {
      const double middle = (low + high) / 2.0;
      (seenAtPlace(middle) == seen[k] ? low : high) = middle;
    }
    changes.emplace_back((low + high) / 2.0, next);
  }
  if (changes.empty()) return {{0.0, length, seen.front()}};

  std::vector<Stretch> stretches;
  if (!chain.chain.closed) stretches.push_back({0.0, changes.front().first, seen.front()});
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const bool last = i + 1 == changes.size();
    const double end = !last                ? changes[i + 1].first
                       : chain.chain.closed ? changes.front().first + length
                                            : length;
    stretches.push_back({changes[i].first, end, changes[i].second});
  }
  smooth(stretches, chain.chain.closed, length, smallestGapPx);
  return stretches;
}

}  // namespace flatland
