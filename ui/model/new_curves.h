// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "flatland/curve/curve.h"

namespace flatland::ui {

/// A kind of curve that a person can begin with.
struct NewCurve {
  QString id;     ///< "bspline", or the name of a family
  QString title;  ///< in the person's language
};

/// All of them in menu order: Bezier, B-spline, rational Bezier, the families, typed formula.
std::vector<NewCurve> newCurves();

/// A curve of the kind around `centre`, of the size `radius`; families and formulas have the size
/// their numbers say. Precondition: id is one of newCurves().
Curve newCurve(const QString& id, const Vec2& centre, double radius);

}  // namespace flatland::ui
