// SPDX-License-Identifier: MIT
#include "core3d/draw/bridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDirectionPx = 6.0;  // an end points as its last pixels do
// The ends point the same way within 60 degrees, as at a junction, and so does the gap between them
// within 45.
constexpr double kLeastTurnCosine = 0.5;
constexpr double kLeastCosine = 0.7;
// Gaps shorter than this say nothing about a direction.
constexpr double kNoGapPx = 0.5;
// How much longer a gap may be on the surface than it looks: what stands before something else is
// not joined with it.
constexpr double kMostSlant = 4.0;
// Where one line takes over from another they often run side by side for a while, this far apart at
// most: less than two pens are wide.
constexpr double kBesidePx = 2.5;
// For so many times the largest gap.
constexpr double kOverlapTimes = 2.0;

using End = std::size_t;  // 2 * line for its first point, 2 * line + 1 for its last
constexpr End kNoEnd = static_cast<End>(-1);

struct Tip {
  Vector2d screen, outward;
  Vector3d at;
  double length;        // of the chain
  std::uint32_t level;  // likewise
};

// The place on the screen, so far back from an end.
Vector2d seenBehind(const ScreenChain& line, bool last, double back) {
  const double place = last ? line.length() - back : back;
  const std::size_t i = line.at(place).piece;
  const double size = line.along[i + 1] - line.along[i];
  const double share = size > 0.0 ? std::clamp((place - line.along[i]) / size, 0.0, 1.0) : 0.0;
  return line.screen[i] + share * (line.screen[i + 1] - line.screen[i]);
}

Tip tipOf(const ScreenChain& line, bool last) {
  const double length = line.length();
  const std::size_t tip = last ? line.screen.size() - 1 : 0;
  const Vector2d from = seenBehind(line, last, std::min(kDirectionPx, length));
  return {line.screen[tip], (line.screen[tip] - from).stableNormalized(),
          line.chain.points[tip].cast<double>(), length, line.chain.level};
}

// An open line without so much of its ends.
LineChain cutBack(const ScreenChain& line, double front, double back) {
  // Two may take more of a crumb than there is: then one place of it is left.
  const double from = front, to = std::max(from, line.length() - back);
  LineChain result = line.chain;
  if (front <= 0.0 && back <= 0.0) return result;
  const ScreenChain::Point first = line.at(from), last = line.at(to);
  const auto keep = [&](auto& all, std::size_t begin, std::size_t end) {
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(end), all.end());
    all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(begin));
  };
  keep(result.points, first.piece, last.piece + 2);
  keep(result.strength, first.piece, last.piece + 2);
  keep(result.triangles, first.piece, last.piece + 1);
  if (!result.standsOut.empty()) keep(result.standsOut, first.piece, last.piece + 1);
  if (!result.others.empty()) keep(result.others, first.piece, last.piece + 1);
  result.points.front() = first.at.cast<float>();
  result.points.back() = last.at.cast<float>();
  result.strength.front() = first.strength;
  result.strength.back() = last.strength;
  return result;
}

class Bridges {
 public:
  Bridges(std::vector<ScreenChain> lines, const Projection& projection, double largestGapPx)
      : lines_(std::move(lines)),
        projection_(projection),
        pxPerUnit_(projection.pxPerUnit),
        gap_(largestGapPx),
        reach2_(std::pow(std::max(overlap(), kBesidePx), 2) + kBesidePx * kBesidePx),
        partner_(2 * lines_.size(), kNoEnd),
        cut_(2 * lines_.size(), 0.0) {
    for (const ScreenChain& line : lines_) {
      for (const bool last : {false, true}) {
        tips_.push_back(line.chain.closed ? Tip{} : tipOf(line, last));
        if (line.chain.closed) continue;
        const Tip& tip = tips_.back();
        places_.push_back({cellOf(tip.screen), tip.screen, tip.outward, tips_.size() - 1});
      }
    }
    std::sort(places_.begin(), places_.end(), [](const Place& p, const Place& q) {
      return std::tie(p.cell, p.end) < std::tie(q.cell, q.end);
    });
    std::vector<Candidate> candidates = candidatesOf();
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [cost, e, f] : candidates) {
      if (partner_[e] != kNoEnd || partner_[f] != kNoEnd) continue;
      partner_[e] = f;
      partner_[f] = e;
      cut_[e] = cut_[f] = cutFor(e, f);
    }
  }

  // Takes the lines out.
  std::vector<ScreenChain> joined() {
    std::vector<ScreenChain> result;
    std::vector<bool> used(lines_.size(), false);
    const auto add = [&](End e) {
      if (used[e / 2]) return;
      if (partner_[e] == kNoEnd && partner_[e ^ 1u] == kNoEnd) {
        used[e / 2] = true;
        result.push_back(std::move(lines_[e / 2]));
        return;
      }
      for (ScreenChain& line : onScreen(walk(e, used), projection_)) {
        result.push_back(std::move(line));
      }
    };
    for (End e = 0; e < partner_.size(); ++e) {
      if (partner_[e] == kNoEnd) add(e);
    }
    for (End e = 0; e < partner_.size(); e += 2) add(e);  // what is left is round
    return result;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  struct Place {
    Cell cell;
    Vector2d screen, outward;
    End end;
  };
  using Candidate = std::tuple<double, End, End>;  // cost, the smaller end, the other

  double overlap() const { return kOverlapTimes * gap_; }
  // Of cells as wide as half of how far is looked, the farthest that is looked into.
  static constexpr std::int64_t kCells = 2;
  double cell() const { return std::sqrt(reach2_) / kCells; }
  Cell cellOf(const Vector2d& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / cell())),
            static_cast<std::int64_t>(std::floor(p.y() / cell()))};
  }

  // Pairs of ends that belong together. Each pair is looked at once, from the end that comes first
  // by cell; then what is near lies in its own column of cells and those to the right, between
  // bounds that only move on.
  std::vector<Candidate> candidatesOf() const {
    std::vector<Candidate> candidates;
    std::array<std::size_t, kCells + 1> first{}, last{};  // of each column
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      const auto& [x, y] = place.cell;
      for (std::int64_t column = 0; column <= kCells; ++column) {
        std::size_t &from = first[column], &to = last[column];
        while (from < places_.size() && places_[from].cell < Cell{x + column, y - kCells}) ++from;
        to = std::max(from, to);
        while (to < places_.size() && places_[to].cell <= Cell{x + column, y + kCells}) ++to;
        for (std::size_t k = std::max(from, i + 1); k < to; ++k) {
          const Place& near = places_[k];
          // Most pairs are too far apart, or point elsewhere.
          if ((near.screen - place.screen).squaredNorm() > reach2_) continue;
          if (-near.outward.dot(place.outward) < kLeastTurnCosine) continue;
          const auto [e, f] = std::minmax(place.end, near.end);
          const double cost = costOf(e, f);
          if (cost >= 0.0) candidates.emplace_back(cost, e, f);
        }
      }
    }
    return candidates;
  }

  // How far an end lies ahead of another, and how far beside.
  struct Gap {
    double ahead, beside;
  };
  Gap gapOf(End e, End f) const {
    const Vector2d gap = tips_[f].screen - tips_[e].screen;
    const Vector2d along = (tips_[e].outward - tips_[f].outward).stableNormalized();
    const double ahead = along.dot(gap);
    return {ahead, (gap - ahead * along).norm()};
  }

  // So that a bridge turns by 45 degrees at most, what is beside each other is cut from both.
  double cutFor(End e, End f) const {
    const Gap gap = gapOf(e, f);
    return std::max(0.0, (gap.beside - gap.ahead) / 2.0);
  }

  // True if the part of a line that reaches past the end of another stays beside that.
  bool runsBeside(End e, End f, double overlap) const {
    const Vector2d behind = seenBehind(lines_[f / 2], f % 2 == 1, overlap);
    return (behind - tips_[e].screen).norm() <= kBesidePx;
  }

  // Of ends that point towards each other; negative if they do not belong together.
  double costOf(End e, End f) const {
    const Tip &a = tips_[e], &b = tips_[f];
    const double turn = -a.outward.dot(b.outward);
    const double size = (b.screen - a.screen).norm(), shorter = std::min(a.length, b.length);
    if (a.level != b.level) return -1.0;
    // Its own ends: only if that makes a loop and not a hairpin.
    if (e / 2 == f / 2 && (lines_[e / 2].screen.size() < 3 || a.length < 4.0 * gap_)) return -1.0;
    const Vector2d gap = b.screen - a.screen;
    const bool isAhead = size <= std::min(gap_, shorter) &&
                         (size <= kNoGapPx || (a.outward.dot(gap) >= kLeastCosine * size &&
                                               -b.outward.dot(gap) >= kLeastCosine * size));
    if (!isAhead && !takesOver(e, f, shorter)) return -1.0;
    if ((b.at - a.at).norm() * pxPerUnit_ > kMostSlant * std::max(size, kNoGapPx)) return -1.0;
    return size * (2.0 - turn);
  }

  // True if one line goes on beside the end of the other.
  bool takesOver(End e, End f, double shorter) const {
    const Gap g = gapOf(e, f);
    if (g.beside > kBesidePx || g.ahead > g.beside || -g.ahead > overlap()) return false;
    // Half of a line is its other end's.
    if (cutFor(e, f) > shorter / 2.0) return false;
    const double common = std::max(0.0, -g.ahead);
    return runsBeside(e, f, common) && runsBeside(f, e, common);
  }

  LineChain walk(End start, std::vector<bool>& used) const {
    LineChain chain;
    chain.family = lines_[start / 2].chain.family;
    chain.level = lines_[start / 2].chain.level;
    End e = start;
    while (true) {
      const LineChain& next = lines_[e / 2].chain;
      used[e / 2] = true;
      append(chain, next.closed ? next : cutBack(lines_[e / 2], cut_[e & ~End{1}], cut_[e | 1u]),
             e % 2 == 1);
      if (next.closed) {
        chain.closed = true;
        return chain;
      }
      e = partner_[e ^ 1u];
      if (e == kNoEnd) return chain;
      chain.triangles.push_back(chain.triangles.back());
      chain.standsOut.push_back(chain.standsOut.back());
      chain.others.push_back(TriangleMesh::kNone);
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
    if (next.others.empty()) {
      chain.others.insert(chain.others.end(), next.pieceCount(), TriangleMesh::kNone);
    } else {
      add(chain.others, next.others);
    }
  }

  std::vector<ScreenChain> lines_;
  const Projection& projection_;
  double pxPerUnit_, gap_;
  double reach2_;  // squared, farther than what may be joined
  std::vector<Tip> tips_;
  std::vector<End> partner_;
  std::vector<double> cut_;    // from each end, px
  std::vector<Place> places_;  // of open ends, by cell
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
  return Bridges(std::move(lines), projection, largestGapPx).joined();
}

}  // namespace flatland
