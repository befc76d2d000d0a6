// SPDX-License-Identifier: MIT
#pragma once

namespace flatland {

// The tolerances that decide what a curve is: smooth or cornered, straight or bent. All relative.
// Roots are decided by certified signs; what is drawn as visible has its own, in visibility.cpp.

/// Joints that turn by less than this (radians) are smooth, beyond it they are corners. Control
/// points rounded to double turn a smooth joint by up to about 1e-15 times the ratio of curve size
/// to handle length; 1e-6 leaves room for handles a billion times shorter than the scene.
inline constexpr double kSmoothJointRad = 1e-6;

/// Two one-sided curvatures at a smooth joint that agree to this relative difference are one
/// value. Splitting a curve in double makes them differ by about 1e-13.
inline constexpr double kSameCurvature = 1e-9;

/// A window of this width in the parameter beside a smooth joint belongs to the joint: marks in it
/// are judged by the net change across it. Rounded control points can move a root that lies at the
/// joint by about 1e-12, to either side, or double it.
inline constexpr double kJointWindow = 0x1p-30;

/// Control points this many units in the last place (of the largest coordinate) from a line are on
/// it.
inline constexpr double kStraightUlps = 8.0;

/// A straight piece is seen end-on when the sine between it and the line of sight is below this:
/// the rounding of the view direction and of the points, with room to spare.
inline constexpr double kEndOnSine = 0x1p-46;

}  // namespace flatland
