// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flatland/scene/scene.h"

namespace flatland {

// What hides what along one line of sight: shared by Visibility, which cuts a whole scene for one
// view, and by SightRays, which ask for single lines of any view.

/// The curves of a scene, with what no view changes. Keeps its own copies.
struct SightCurves {
  explicit SightCurves(const Scene& scene);

  struct Stretch {
    double low, high;          ///< chain parameter
    std::vector<Vec2> around;  ///< their hull holds the curve, up to `slack`
    double slack;              ///< length; 0 but for formulas
  };

  std::vector<Curve> curves;
  std::vector<std::vector<Bezier>> pieces;  ///< of each curve that has a Bezier form
  /// Of each curve, in order: whole pieces, or of a formula what is nearly a cubic.
  std::vector<std::vector<Stretch>> stretches;
  double size = 1.0;  ///< of the scene; 1 if it is a point

  Vec2 point(int curve, int piece, double t) const;
};

/// A stretch of a piece whose image on the screen does not fold: each line of sight meets it once.
struct SightPart {
  int curve;
  int piece;
  double low, high;          ///< local parameter
  Vec2 pointLow, pointHigh;  ///< at the ends
  double atLow, atHigh;      ///< image at the ends
  double nearest;            ///< no point of it is nearer to the viewer (nearness() of view.h)
  const SightCurves::Stretch* stretch;  ///< what it is a part of
  bool goesOn = false;                  ///< where the part before it ends there is no fold
};

/// A line of sight; its coefficients are chosen so that nothing is infinite.
struct SightLine {
  double image;      ///< see CurveSight::image
  double along, up;  ///< perspective: the line is across * along = depth * up
};

/// A scene in one view. Holds a reference to `curves`.
class CurveSight {
 public:
  CurveSight(const SightCurves& curves, const View& view);

  const ViewFrame& frame() const { return frame_; }
  const SightCurves& scene() const { return *curves_; }

  /// Where a point appears: the coordinate along the screen, or in perspective the angle in radians
  /// from the middle of the view, which is finite beside the viewer too. Neither is in front of nor
  /// behind anything by this.
  double image(const Vec2& p) const;
  /// Images nearer than this are one: the rounding of a view direction.
  double sameImage() const { return sameImage_; }
  /// Nearer to the viewer by less than this is the same place.
  double sameDepth() const;

  SightLine lineThrough(const Vec2& q) const;
  SightLine lineAt(double image) const;

  /// Cuts a piece where its image folds and beside the viewer, and appends what lies before the
  /// viewer.
  void cut(int curve, int piece, std::vector<SightPart>& to) const;
  /// Appends [low, high] of a piece, known not to fold, if it lies before the viewer.
  bool add(const SightCurves::Stretch& stretch, int curve, int piece, double low, double high,
           double nearest, std::vector<SightPart>& to) const;

  Vec2 point(const SightPart& part, double t) const {
    return curves_->point(part.curve, part.piece, t);
  }

  /// Seen along itself, to within rounding: all of it lies on one line of sight.
  bool isEndOn(const SightPart& part) const;

  /// The parameter at which the part meets the line; its ends must lie on both sides.
  double crossing(const SightPart& part, const SightLine& line) const;

  /// No point of the part on that line is nearer to the viewer; -infinity if none can be on it.
  double nearestOn(const SightPart& part, const SightLine& line) const;

  /// Whether the part lies between the viewer and the point q on that line. Curves that only touch
  /// the line at the end of a fold count.
  bool hides(const SightPart& part, const Vec2& q, const SightLine& line) const;

  /// True if parameter t of `curve` lies on the part or touches it, also across a joint: its own
  /// neighbourhood, which does not hide it.
  bool isOn(const SightPart& part, int curve, double t) const;

  /// Whether a part that is not end-on hides nothing of itself from this point.
  bool concerns(const SightPart& part, int curve, double t) const {
    return isEndOn(part) || !isOn(part, curve, t);
  }

 private:
  double depth(const Vec2& p) const;
  double beside(const Vec2& p, const SightLine& line) const;
  double nearestOf(int curve, int piece, double low, double high) const;

  const SightCurves* curves_;
  ViewFrame frame_;
  double sameImage_;
};

}  // namespace flatland
