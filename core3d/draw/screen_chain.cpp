// SPDX-License-Identifier: MIT
#include "core3d/draw/screen_chain.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Lines are cut off so far outside the picture, as a share of its diagonal: far more than what
// lines are judged by (minWeightPx, kJudgedPx), little enough that a large zoom costs no more.
constexpr double kCutShare = 0.5;
constexpr double kPlacePx = 1.0 / 32.0;  // far below what an antialiased line shows

// See ScreenChain::judged. Single segments fail and pass by accident where a scan is rough; along a
// clear line they seldom fail for long.
constexpr double kJudgedPx = 12.0;
constexpr double kEnoughStandsOut = 0.3;

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

ScreenChain measured(LineChain chain, std::vector<Vector2d> places) {
  ScreenChain result;
  result.chain = std::move(chain);
  result.screen = std::move(places);
  double along = 0.0;
  for (std::size_t i = 0; i < result.screen.size(); ++i) {
    if (i > 0) along += (result.screen[i] - result.screen[i - 1]).norm();
    result.along.push_back(along);
  }
  if (result.chain.closed) {
    result.along.push_back(along + (result.screen.front() - result.screen.back()).norm());
  }
  judge(result);
  return result;
}

// The part of a piece that is kept: between two shares of it, with their places on the screen.
struct Kept {
  double from = 0.0, to = 0.0;
  Vector2d start = Vector2d::Zero(), end = Vector2d::Zero();

  bool any() const { return from < to; }
};

// What is kept of a piece that is seen from a to b, as shares on the screen: Liang and Barsky's
// clipping by the four sides of the picture with its margin.
Kept keptOf(const Vector2d& a, const Vector2d& b, double width, double height) {
  const double margin = kCutShare * std::hypot(width, height);
  const Vector2d step = b - a, size(width, height);
  Kept kept{0.0, 1.0, a, b};
  for (Eigen::Index k = 0; k < 2; ++k) {
    for (const double side : {-1.0, 1.0}) {
      // Inside where rise * share <= room.
      const double rise = side * step[k];
      const double room = margin + (side > 0.0 ? size[k] - a[k] : a[k]);
      if (rise > 0.0) {
        kept.to = std::min(kept.to, room / rise);
      } else if (rise < 0.0) {
        kept.from = std::max(kept.from, room / rise);
      } else if (room < 0.0) {
        return {};
      }
    }
  }
  if (kept.from > 0.0) kept.start = a + kept.from * step;
  if (kept.to < 1.0) kept.end = a + kept.to * step;
  return kept;
}

// The share of a piece in space that is seen at a share of its picture.
double inSpace(double share, const Vector3d& a, const Vector3d& b, const Projection& projection) {
  if (!projection.distance || share <= 0.0 || share >= 1.0) return share;
  const auto depth = [&](const Vector3d& p) {
    return *projection.distance - projection.axes.row(2).dot(p - projection.centre);
  };
  const double nearA = share * depth(a), nearB = (1.0 - share) * depth(b);
  return nearA / (nearA + nearB);
}

// The pieces from `first` to `last`, which may run past the end of a closed chain, the first and
// the last of them cut.
ScreenChain part(const LineChain& chain, const std::vector<Kept>& kept, std::size_t first,
                 std::size_t last, const Projection& projection) {
  LineChain result;
  result.family = chain.family;
  result.level = chain.level;
  std::vector<Vector2d> places;
  const std::size_t n = chain.points.size(), pieces = kept.size();
  const auto add = [&](std::size_t piece, bool atStart) {
    const std::size_t i = piece % pieces, k = (i + 1) % n;
    const Kept& cut = kept[i];
    const auto share =
        static_cast<float>(inSpace(atStart ? cut.from : cut.to, chain.points[i].cast<double>(),
                                   chain.points[k].cast<double>(), projection));
    const auto between = [share](const auto& a, const auto& b) {
      return share <= 0.0f ? a : share >= 1.0f ? b : (1.0f - share) * a + share * b;
    };
    const Eigen::Vector3f &a = chain.points[i], &b = chain.points[k];
    result.points.push_back({between(a.x(), b.x()), between(a.y(), b.y()), between(a.z(), b.z())});
    result.strength.push_back(between(chain.strength[i], chain.strength[k]));
    places.push_back(atStart ? cut.start : cut.end);
  };
  add(first, true);
  for (std::size_t piece = first; piece <= last; ++piece) {
    add(piece, false);
    result.triangles.push_back(chain.triangles[piece % pieces]);
    if (!chain.standsOut.empty()) result.standsOut.push_back(chain.standsOut[piece % pieces]);
    result.others.push_back(chain.otherOf(piece % pieces));
  }
  return measured(std::move(result), std::move(places));
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
  const std::size_t n = chain.points.size(), pieces = chain.pieceCount();
  std::vector<std::optional<Vector2d>> places;
  places.reserve(n);
  for (const Eigen::Vector3f& p : chain.points) {
    places.push_back(projection.toScreen(p.cast<double>()));
    if (places.back() && !places.back()->allFinite()) places.back().reset();
  }
  std::vector<Kept> kept(pieces);
  for (std::size_t i = 0; i < pieces; ++i) {
    const auto &a = places[i], &b = places[(i + 1) % n];
    if (a && b) kept[i] = keptOf(*a, *b, projection.width, projection.height);
  }
  // Whether the line goes on from a piece to the one after it.
  const auto goesOn = [&](std::size_t piece) {
    const Kept &here = kept[piece % pieces], &next = kept[(piece + 1) % pieces];
    return here.any() && next.any() && here.to == 1.0 && next.from == 0.0;
  };
  const auto isWhole = [](const Kept& k) { return k.any() && k.from == 0.0 && k.to == 1.0; };

  std::vector<ScreenChain> result;
  const auto add = [&result](ScreenChain part) {
    if (part.length() > 0.0) result.push_back(std::move(part));
  };
  if (std::all_of(kept.begin(), kept.end(), isWhole)) {
    std::vector<Vector2d> all;
    all.reserve(n);
    for (const auto& place : places) all.push_back(*place);
    add(measured(std::move(chain), std::move(all)));
    return result;
  }
  // Once round from a cut, or from end to end; runs of pieces that go on become parts.
  std::size_t start = 0;
  if (chain.closed) {
    while (goesOn(start)) ++start;
    ++start;
  }
  for (std::size_t i = start; i < start + pieces;) {
    if (!kept[i % pieces].any()) {
      ++i;
      continue;
    }
    std::size_t last = i;
    while (last + 1 < start + pieces && goesOn(last)) ++last;
    add(part(chain, kept, i, last, projection));
    i = last + 1;
  }
  return result;
}

std::vector<Stretch> stretchesOf(const ScreenChain& chain, double smallestGapPx,
                                 const std::function<Seen(const ScreenChain::Point&)>& seenAt,
                                 double samplePx) {
  const double length = chain.length();
  const auto samples = std::max<std::size_t>(1, static_cast<std::size_t>(length / samplePx));
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
  smoothStretches(stretches, chain, smallestGapPx);
  return stretches;
}

void smoothStretches(std::vector<Stretch>& stretches, const ScreenChain& chain,
                     double smallestGapPx) {
  const bool closed = chain.chain.closed;
  const double length = chain.length();
  mergeEqual(stretches, closed, length);
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
    const auto isHidden = [](const Stretch* s) { return s != nullptr && s->seen == Seen::Hidden; };
    // Where a line goes behind another the part beside that one's outline is hidden like the rest.
    const bool goesBehind =
        stretches[i].seen == Seen::Covered && (isHidden(before) || isHidden(after));
    stretches[i].seen = goesBehind ? Seen::Hidden : (takeBefore ? before : after)->seen;
    mergeEqual(stretches, closed, length);
  }
}

}  // namespace flatland
