// SPDX-License-Identifier: MIT
#include "core3d/draw/line_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace flatland {
namespace {

using Eigen::Vector3d;

// Of pieces that are points: any size does.
constexpr double kSmallestCell = 1e-9;

Vector3d fromOf(const LineSegment& s) { return s.a.at.cast<double>(); }
Vector3d toOf(const LineSegment& s) { return s.b.at.cast<double>(); }
double lengthOf(const LineSegment& s) { return (toOf(s) - fromOf(s)).norm(); }

double distanceTo(const LineSegment& s, const Vector3d& p) {
  const Vector3d from = fromOf(s), along = toOf(s) - from;
  const double lengthSq = along.squaredNorm();
  const double t = lengthSq > 0.0 ? std::clamp((p - from).dot(along) / lengthSq, 0.0, 1.0) : 0.0;
  return (from + t * along - p).norm();
}

// Pieces by the cells of a grid that they pass.
class Grid {
 public:
  Grid(std::span<const LineSegment> pieces, double tolerance)
      : pieces_(pieces), tolerance_(tolerance) {
    double total = 0.0;
    for (const LineSegment& piece : pieces_) total += lengthOf(piece);
    const double mean = pieces_.empty() ? 0.0 : total / static_cast<double>(pieces_.size());
    cell_ = std::max({2.0 * tolerance, mean, kSmallestCell});
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) enter(i);
  }

  bool hasNear(const Vector3d& p) const {
    const Cell middle = cellOf(p);
    for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x) {
      for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
        for (std::int64_t z = middle.z - 1; z <= middle.z + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const std::uint32_t i : found->second) {
            if (distanceTo(pieces_[i], p) <= tolerance_) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      constexpr std::uint64_t kOdd[] = {0x9e3779b97f4a7c15U, 0xc2b2ae3d27d4eb4fU,
                                        0x165667b19e3779f9U};
      const std::uint64_t mixed = static_cast<std::uint64_t>(c.x) * kOdd[0] ^
                                  static_cast<std::uint64_t>(c.y) * kOdd[1] ^
                                  static_cast<std::uint64_t>(c.z) * kOdd[2];
      return static_cast<std::size_t>(mixed ^ (mixed >> 29));
    }
  };

  Cell cellOf(const Vector3d& p) const {
    const auto part = [this](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    return {part(p.x()), part(p.y()), part(p.z())};
  }

  // At samples no farther apart than a cell. A place within the tolerance, at most half a cell, of
  // the piece is within a cell of a sample: its own cell or a neighbour of that was entered.
  void enter(std::uint32_t i) {
    const Vector3d from = fromOf(pieces_[i]), to = toOf(pieces_[i]);
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / cell_)));
    Cell last{std::numeric_limits<std::int64_t>::max(), 0, 0};
    for (int k = 0; k <= steps; ++k) {
      const Cell cell = cellOf(from + (to - from) * (static_cast<double>(k) / steps));
      if (cell == last) continue;
      cells_[cell].push_back(i);
      last = cell;
    }
  }

  std::span<const LineSegment> pieces_;
  double tolerance_, cell_ = 1.0;
  std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

}  // namespace

LineDifference differenceOf(std::span<const LineSegment> lines,
                            std::span<const LineSegment> reference, double tolerance) {
  LineDifference difference;
  const Grid known(reference, tolerance), drawn(lines, tolerance);
  const auto middle = [](const LineSegment& s) { return Vector3d((fromOf(s) + toOf(s)) / 2.0); };
  for (const LineSegment& piece : lines) {
    const double length = lengthOf(piece);
    difference.linesLength += length;
    if (known.hasNear(middle(piece))) {
      difference.common.push_back(piece);
    } else {
      difference.added.push_back(piece);
      difference.addedLength += length;
    }
  }
  for (const LineSegment& piece : reference) {
    const double length = lengthOf(piece);
    difference.referenceLength += length;
    if (drawn.hasNear(middle(piece))) continue;
    difference.missing.push_back(piece);
    difference.missingLength += length;
  }
  return difference;
}

}  // namespace flatland
