// SPDX-License-Identifier: MIT
#include "core3d/draw/bridges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDirectionPx = 6.0;  // an end points as its last pixels do
constexpr double kLeastCosine = 0.7;
// Gaps shorter than this say nothing about a direction.
constexpr double kNoGapPx = 0.5;
// How much longer a gap may be on the surface than it looks: what stands before something else is
// not joined with it.
constexpr double kMostSlant = 4.0;

using End = std::size_t;  // 2 * line for its first point, 2 * line + 1 for its last
constexpr End kNoEnd = static_cast<End>(-1);

struct Tip {
  Vector2d screen, outward;
  Vector3d at;
  double length;  // of the chain
};

Tip tipOf(const ScreenChain& line, bool last) {
  const double length = line.length();
  const double back = std::min(kDirectionPx, length);
  const std::size_t tip = last ? line.screen.size() - 1 : 0;
  const ScreenChain::Point inner = line.at(last ? length - back : back);
  // Between the picture's points; exact enough for a direction.
  const std::size_t i = inner.piece;
  const double size = line.along[i + 1] - line.along[i];
  const double place = last ? length - back : back;
  const double share = size > 0.0 ? (place - line.along[i]) / size : 0.0;
  const Vector2d from = line.screen[i] + share * (line.screen[i + 1] - line.screen[i]);
  return {line.screen[tip], (line.screen[tip] - from).stableNormalized(),
          line.chain.points[tip].cast<double>(), length};
}

class Bridges {
 public:
  Bridges(const std::vector<ScreenChain>& lines, double pxPerUnit, double largestGapPx)
      : lines_(lines),
        pxPerUnit_(pxPerUnit),
        gap_(largestGapPx),
        partner_(2 * lines.size(), kNoEnd) {
    for (const ScreenChain& line : lines) {
      for (const bool last : {false, true}) {
        tips_.push_back(line.chain.closed ? Tip{} : tipOf(line, last));
        if (!line.chain.closed) cells_[cellOf(tips_.back().screen)].push_back(tips_.size() - 1);
      }
    }
    std::vector<std::tuple<double, End, End>> candidates;
    for (const auto& [cell, ends] : cells_) {
      for (const End e : ends) addCandidates(e, cell, candidates);
    }
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [cost, e, f] : candidates) {
      if (partner_[e] != kNoEnd || partner_[f] != kNoEnd) continue;
      partner_[e] = f;
      partner_[f] = e;
    }
  }

  std::vector<LineChain> joined() const {
    std::vector<LineChain> result;
    std::vector<bool> used(lines_.size(), false);
    for (End e = 0; e < partner_.size(); ++e) {
      if (!used[e / 2] && partner_[e] == kNoEnd) result.push_back(walk(e, used));
    }
    for (End e = 0; e < partner_.size(); e += 2) {  // what is left is round
      if (!used[e / 2]) result.push_back(walk(e, used));
    }
    return result;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  Cell cellOf(const Vector2d& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / gap_)),
            static_cast<std::int64_t>(std::floor(p.y() / gap_))};
  }

  void addCandidates(End e, const Cell& cell,
                     std::vector<std::tuple<double, End, End>>& candidates) const {
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find({cell.first + dx, cell.second + dy});
        if (found == cells_.end()) continue;
        for (const End f : found->second) {
          if (f <= e) continue;
          const double cost = costOf(e, f);
          if (cost >= 0.0) candidates.emplace_back(cost, e, f);
        }
      }
    }
  }

  // Negative if the ends do not belong together.
  double costOf(End e, End f) const {
    const Tip &a = tips_[e], &b = tips_[f];
    const Vector2d gap = b.screen - a.screen;
    const double size = gap.norm();
    if (size > std::min({gap_, a.length, b.length})) return -1.0;
    if (lines_[e / 2].chain.level != lines_[f / 2].chain.level) return -1.0;
    // Its own ends: only if that makes a loop and not a hairpin.
    if (e / 2 == f / 2 && (lines_[e / 2].screen.size() < 3 || a.length < 4.0 * gap_)) return -1.0;
    if ((b.at - a.at).norm() * pxPerUnit_ > kMostSlant * std::max(size, kNoGapPx)) return -1.0;
    const double turn = -a.outward.dot(b.outward);
    if (turn < kLeastCosine) return -1.0;
    if (size > kNoGapPx &&
        (a.outward.dot(gap) < kLeastCosine * size || -b.outward.dot(gap) < kLeastCosine * size)) {
      return -1.0;
    }
    return size * (2.0 - turn);
  }

  LineChain walk(End start, std::vector<bool>& used) const {
    LineChain chain;
    chain.family = lines_[start / 2].chain.family;
    chain.level = lines_[start / 2].chain.level;
    End e = start;
    while (true) {
      const LineChain& next = lines_[e / 2].chain;
      used[e / 2] = true;
      append(chain, next, e % 2 == 1);
      if (next.closed) {
        chain.closed = true;
        return chain;
      }
      e = partner_[e ^ 1u];
      if (e == kNoEnd) return chain;
      chain.triangles.push_back(chain.triangles.back());
      chain.standsOut.push_back(chain.standsOut.back());
      if (used[e / 2]) {
        chain.closed = true;
        return chain;
      }
    }
  }

  static void append(LineChain& chain, const LineChain& next, bool backwards) {
    const auto add = [backwards](auto& to, const auto& from) {
      if (backwards) {
        to.insert(to.end(), from.rbegin(), from.rend());
      } else {
        to.insert(to.end(), from.begin(), from.end());
      }
    };
    add(chain.points, next.points);
    add(chain.strength, next.strength);
    add(chain.triangles, next.triangles);
    add(chain.standsOut, next.standsOut);
  }

  const std::vector<ScreenChain>& lines_;
  double pxPerUnit_, gap_;
  std::vector<Tip> tips_;
  std::vector<End> partner_;
  std::map<Cell, std::vector<End>> cells_;
};

}  // namespace

bool isBridged(LineFamily family) {
  switch (family) {
    case LineFamily::ApparentRidges:
    case LineFamily::Ridges:
    case LineFamily::Valleys:
    case LineFamily::SuggestiveContours:
    case LineFamily::SuggestiveHighlights:
    case LineFamily::PrincipalHighlights:
      return true;
    default:
      return false;
  }
}

std::vector<ScreenChain> bridged(std::vector<ScreenChain> lines, const Projection& projection,
                                 double largestGapPx) {
  if (lines.empty() || !(largestGapPx > 0.0)) return lines;
  std::vector<ScreenChain> result;
  for (LineChain& chain : Bridges(lines, projection.pxPerUnit, largestGapPx).joined()) {
    for (ScreenChain& line : onScreen(std::move(chain), projection)) {
      result.push_back(std::move(line));
    }
  }
  return result;
}

}  // namespace flatland
