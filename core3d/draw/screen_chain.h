// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "core3d/draw/camera.h"
#include "core3d/draw/chains.h"

namespace flatland {

/// A chain with its picture. A place on it is given by the length on the screen from the first
/// point, px.
struct ScreenChain {
  LineChain chain;
  std::vector<Eigen::Vector2d> screen;  ///< px, of each point
  std::vector<double> along;            ///< place of each point; on a closed chain also of the
                                        ///< first point when it is reached again
  /// What strokes are filtered by, of each point: the strength, less where pieces around do not
  /// stand out (LineSegment::standsOut): in full if three tenths of the line within 12 px to either
  /// side stand out, in proportion if less.
  std::vector<float> judged;

  double length() const { return along.back(); }

  /// What is at a place. On a closed chain places may exceed the length by up to another one.
  struct Point {
    Eigen::Vector3d at;  ///< coordinates of the mesh
    float strength;
    std::size_t piece;  ///< from point `piece` to the next
  };
  Point at(double place) const;
};

/// The parts of a chain in front of the viewer: without pieces that reach behind, and cut off half
/// the picture's diagonal outside it, so that the length does not grow with the zoom. Parts that
/// are points on the screen are left out.
std::vector<ScreenChain> onScreen(LineChain chain, const Projection& projection);

/// How a stretch of a line is seen.
enum class Seen : std::uint8_t {
  Hidden,
  Visible,
  Outline,  ///< visible, with nothing but background on its other side
  Covered,  ///< hidden, with nothing but background on its other side; none is left by lookAt
};

/// From place to place of a chain. On a closed chain `to` may exceed its length.
struct Stretch {
  double from, to;
  Seen seen;
};

/// Divides a chain into stretches. `seenAt` is asked about once in `samplePx`, places where the
/// answer changes are then located to 1/32 px. Stretches shorter than `smallestGapPx` take the
/// answer of their longer neighbour, the shortest first. The stretches cover the chain from 0
/// (open) or from the first change (closed); one stretch from 0 to the length if nothing changes.
std::vector<Stretch> stretchesOf(const ScreenChain& chain, double smallestGapPx,
                                 const std::function<Seen(const ScreenChain::Point&)>& seenAt,
                                 double samplePx = 1.0);

/// What stretchesOf ends with: neighbours that are seen alike become one, and stretches shorter
/// than `smallestGapPx` take their longer neighbour's answer, the shortest first, what is covered
/// beside what is hidden that of the latter.
void smoothStretches(std::vector<Stretch>& stretches, const ScreenChain& chain,
                     double smallestGapPx);

}  // namespace flatland
