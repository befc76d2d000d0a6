// SPDX-License-Identifier: MIT
#include "core3d/draw/strokes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector2d;

double distanceToPiece(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double sq = d.squaredNorm();
  const double share = sq > 0.0 ? std::clamp((p - a).dot(d) / sq, 0.0, 1.0) : 0.0;
  return (p - (a + share * d)).norm();
}

// Marks what is kept between two kept points. A stack instead of recursion: a stroke may have
// hundreds of thousands of points.
void simplifyBetween(std::span<const Vector2d> screen, std::size_t first, std::size_t last,
                     double tolerance, std::vector<bool>& kept) {
  const std::size_t n = screen.size();
  std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance = distanceToPiece(screen[i], screen[from], screen[to % n]);
      if (distance > worst) {
        worst = distance;
        at = i;
      }
    }
    if (at == from) continue;
    kept[at] = true;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

// A walk along a chain by the places of its points; on a closed one once more round.
struct Places {
  const ScreenChain& chain;
  std::size_t pieces() const { return chain.chain.pieceCount(); }
  std::size_t count() const {
    return chain.chain.closed ? 2 * pieces() + 1 : chain.chain.points.size();
  }
  double place(std::size_t i) const {
    return i <= pieces() ? chain.along[i] : chain.along[i - pieces()] + chain.length();
  }
  std::size_t point(std::size_t i) const { return i % chain.chain.points.size(); }
  // The first place after one that lies before the length; there is always one at the end.
  std::size_t firstAfter(double place) const {
    const auto after = std::upper_bound(chain.along.begin(), chain.along.end(), place);
    return static_cast<std::size_t>(after - chain.along.begin());
  }
};

// How many times the threshold counts at most when strokes are weighed: a stroke of a third of the
// weight asked for is kept if it is clear enough.
constexpr double kMostTimes = 3.0;

// Scans are full of holes a few triangles wide, which are faults and no borders of what was
// scanned.
bool isPinhole(const SeenChain& chain, double minHolePx) {
  const ScreenChain& line = chain.line;
  return line.chain.family == LineFamily::Boundaries && line.chain.closed &&
         line.length() < minHolePx &&
         std::none_of(chain.stretches.begin(), chain.stretches.end(),
                      [](const Stretch& s) { return s.seen == Seen::Outline; });
}

// The mean over a step from one strength to another of its share of `most`, from 0 to 1. With a
// `most` of 0 every strength above it is as strong as can be.
double meanShare(double a, double b, double most) {
  const double low = std::min(a, b), high = std::max(a, b);
  if (high <= 0.0) return 0.0;
  if (low >= most && low > 0.0) return 1.0;
  if (high == low) return low / most;
  const double full = std::max(high - std::max(low, most), 0.0);
  const double from = std::max(low, 0.0), to = std::min(high, most);
  const double part = most > 0.0 ? (to - from) * (from + to) / (2.0 * most) : 0.0;
  return (full + part) / (high - low);
}

// The length between two places, each part times its strength over the unit.
double weightOf(const ScreenChain& chain, double from, double to, double unit) {
  const Places places{chain};
  const auto strength = [&](std::size_t i) {
    return static_cast<double>(chain.judged[places.point(i)]);
  };
  double weight = 0.0;
  for (std::size_t i = std::max<std::size_t>(places.firstAfter(from), 1) - 1;
       i + 1 < places.count() && places.place(i) < to; ++i) {
    const double a = places.place(i), b = places.place(i + 1);
    const double first = std::max(a, from), last = std::min(b, to);
    if (!(last > first)) continue;
    const auto at = [&](double place) {
      return strength(i) + (place - a) / (b - a) * (strength(i + 1) - strength(i));
    };
    weight += (last - first) * kMostTimes * meanShare(at(first), at(last), kMostTimes * unit);
  }
  return weight;
}

// Visible parts that follow one another, outline or not, are as long as they are together. `round`:
// the last part is followed by the first.
void dropCrumbs(std::vector<StrokePart>& parts, bool round, double minLengthPx) {
  std::sort(parts.begin(), parts.end(),
            [](const StrokePart& a, const StrokePart& b) { return a.from < b.from; });
  std::vector<double> lengths;
  std::vector<std::size_t> group;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool together = i > 0 && parts[i].from == parts[i - 1].to &&
                          parts[i].seen != Seen::Hidden && parts[i - 1].seen != Seen::Hidden;
    if (!together) lengths.push_back(0.0);
    lengths.back() += parts[i].to - parts[i].from;
    group.push_back(lengths.size() - 1);
  }
  if (round && lengths.size() > 1 && parts.front().seen != Seen::Hidden &&
      parts.back().seen != Seen::Hidden) {
    lengths.front() = lengths.back() = lengths.front() + lengths.back();
  }
  std::vector<StrokePart> kept;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (lengths[group[i]] >= minLengthPx) kept.push_back(parts[i]);
  }
  parts = std::move(kept);
}

}  // namespace

std::vector<std::pair<double, double>> strongStretches(const ScreenChain& chain, double threshold,
                                                       double hysteresis) {
  const double length = chain.length();
  if (!(threshold > 0.0)) return {{0.0, length}};
  const Places places{chain};
  const auto strength = [&](std::size_t i) {
    return static_cast<double>(chain.judged[places.point(i)]);
  };
  const double low = hysteresis * threshold;
  // A closed chain is walked once round from a weak point, so that no stretch is cut at the start.
  std::size_t start = 0;
  const std::size_t pieces = places.pieces();
  if (chain.chain.closed) {
    while (start < pieces && strength(start) >= low) ++start;
    if (start == pieces) {
      const auto& all = chain.judged;
      if (*std::max_element(all.begin(), all.end()) < threshold) return {};
      return {{0.0, length}};
    }
  }
  std::vector<std::pair<double, double>> result;
  bool inside = false, seeded = false;
  double from = 0.0;
  const auto crossing = [&](std::size_t i) {  // of `low` on the piece from i
    const double a = strength(i), b = strength(i + 1);
    return places.place(i) + (low - a) / (b - a) * (places.place(i + 1) - places.place(i));
  };
  const auto enter = [&](double place) {
    inside = true;
    seeded = false;
    from = place;
  };
  const auto leave = [&](double place) {
    if (inside && seeded && place > from) {
      const double back = from >= length ? length : 0.0;
      result.emplace_back(from - back, place - back);
    }
    inside = false;
  };
  if (strength(start) >= low) enter(places.place(start));
  for (std::size_t i = start; i < start + pieces; ++i) {
    if (inside) seeded = seeded || strength(i) >= threshold;
    const bool next = strength(i + 1) >= low;
    if (next && !inside) enter(crossing(i));
    if (!next && inside) leave(crossing(i));
  }
  if (inside) seeded = seeded || strength(start + pieces) >= threshold;
  leave(places.place(start + pieces));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<StrokePart> strokeParts(const SeenChain& chain, std::size_t index,
                                    const StrokeFilter& filter, double hysteresis) {
  const ScreenChain& line = chain.line;
  const double length = line.length();
  const bool closed = line.chain.closed;
  std::vector<StrokePart> parts;
  if (isPinhole(chain, filter.minHolePx)) return parts;
  for (const auto& [from, to] : strongStretches(line, filter.threshold, hysteresis)) {
    if (filter.minWeightPx > 0.0 &&
        weightOf(line, from, to, filter.unitStrength) < filter.minWeightPx) {
      continue;
    }
    const bool whole = closed && to - from >= length;
    if (whole && chain.stretches.size() == 1) {
      const Seen seen = chain.stretches.front().seen;
      const bool kept =
          length >= filter.minLengthPx || (chain.outlineOfPart && seen != Seen::Hidden);
      if (kept) parts.push_back({index, 0.0, length, seen, true});
      continue;
    }
    if (to - from < filter.minLengthPx) continue;
    std::vector<StrokePart> cut;
    for (const Stretch& s : chain.stretches) {
      if (whole) {
        cut.push_back({index, s.from, s.to, s.seen, false});
        continue;
      }
      // Both may run past the end of a closed chain: their overlap may lie a round apart.
      for (const double shift : {-length, 0.0, length}) {
        if (shift != 0.0 && !closed) continue;
        const double a = std::max(from, s.from + shift), b = std::min(to, s.to + shift);
        if (b > a) cut.push_back({index, a, b, s.seen, false});
      }
    }
    dropCrumbs(cut, whole, filter.minLengthPx);
    for (StrokePart& part : cut) {
      const double back = part.from >= length ? length : 0.0;
      part.from -= back;
      part.to -= back;
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<std::size_t> simplified(std::span<const Vector2d> screen, bool closed,
                                    double tolerancePx) {
  const std::size_t n = screen.size();
  if (n == 0) return {};
  std::vector<bool> kept(n, false);
  kept.front() = true;
  if (closed) {
    std::size_t far = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if ((screen[i] - screen[0]).squaredNorm() > (screen[far] - screen[0]).squaredNorm()) far = i;
    }
    kept[far] = true;
    simplifyBetween(screen, 0, far, tolerancePx, kept);
    simplifyBetween(screen, far, n, tolerancePx, kept);
  } else {
    kept.back() = true;
    simplifyBetween(screen, 0, n - 1, tolerancePx, kept);
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < n; ++i) {
    if (kept[i]) result.push_back(i);
  }
  return result;
}

std::vector<Vector2d> screenOf(const ScreenChain& line, const StrokePart& part) {
  if (part.closed) return line.screen;
  const Places places{line};
  const auto at = [&](double place) {
    const std::size_t i = line.at(place).piece;
    const double back = line.chain.closed && place > line.length() ? line.length() : 0.0;
    const double size = line.along[i + 1] - line.along[i];
    const double share =
        size > 0.0 ? std::clamp((place - back - line.along[i]) / size, 0.0, 1.0) : 0.0;
    const Vector2d& a = line.screen[i];
    return Vector2d(a + share * (line.screen[(i + 1) % line.screen.size()] - a));
  };
  std::vector<Vector2d> result = {at(part.from)};
  for (std::size_t i = places.firstAfter(part.from);
       i < places.count() && places.place(i) < part.to; ++i) {
    result.push_back(line.screen[places.point(i)]);
  }
  result.push_back(at(part.to));
  return result;
}

Polyline polylineOf(const SeenChain& chain, const StrokePart& part, const Projection& projection,
                    double tolerancePx) {
  const ScreenChain& line = chain.line;
  Polyline all;
  all.family = line.chain.family;
  all.level = line.chain.level;
  all.visible = part.seen != Seen::Hidden;
  all.closed = part.closed;
  const auto add = [&](const Eigen::Vector3f& at, const Vector2d& screen, float strength) {
    all.points.push_back(at);
    all.screen.push_back(screen);
    all.strength.push_back(strength);
  };
  const auto addPlace = [&](double place) {
    const ScreenChain::Point p = line.at(place);
    if (const auto screen = projection.toScreen(p.at)) {
      add(p.at.cast<float>(), *screen, p.strength);
    }
  };
  const Places places{line};
  if (!part.closed) addPlace(part.from);
  const double end = part.closed ? line.length() : part.to;
  for (std::size_t i = part.closed ? 0 : places.firstAfter(part.from);
       i < places.count() && places.place(i) < end; ++i) {
    const std::size_t k = places.point(i);
    add(line.chain.points[k], line.screen[k], line.chain.strength[k]);
  }
  if (!part.closed) addPlace(part.to);

  Polyline result = all;
  result.points.clear();
  result.screen.clear();
  result.strength.clear();
  for (const std::size_t i : simplified(all.screen, part.closed, tolerancePx)) {
    result.points.push_back(all.points[i]);
    result.screen.push_back(all.screen[i]);
    result.strength.push_back(all.strength[i]);
  }
  return result;
}

void appendSegments(const ScreenChain& line, const StrokePart& part, std::uint64_t& node,
                    std::vector<LineSegment>& segments) {
  const LineChain& chain = line.chain;
  const Places places{line};
  const auto endAt = [&](double place) {
    const ScreenChain::Point p = line.at(place);
    return LineEnd{p.at.cast<float>(), p.strength, freeNode(node++)};
  };
  const LineNode first = freeNode(node);
  LineEnd before = endAt(part.from);
  std::size_t i = places.firstAfter(part.from);
  const auto add = [&](const LineEnd& next) {
    const std::size_t piece = (i - 1) % chain.triangles.size();
    segments.push_back(
        {before, next, chain.triangles[piece], chain.level, true, chain.otherOf(piece)});
    before = next;
  };
  for (; i < places.count() && places.place(i) < part.to; ++i) {
    const std::size_t k = places.point(i);
    add({chain.points[k], chain.strength[k], freeNode(node++)});
  }
  LineEnd last = endAt(part.to);
  if (part.closed) last.node = first;
  i = std::min(i, places.count() - 1);
  add(last);
}

}  // namespace flatland
