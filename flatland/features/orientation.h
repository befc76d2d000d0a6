// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flatland/scene/scene.h"

namespace flatland {

/// +1 if the normal of the curve is the left normal (tangent turned by +90 degrees), -1 if the
/// right one. Closed curves: outward, by the sign of the enclosed area. Open curves: the side of
/// the chord that faces the viewer, so that over the whole curve the mean of n.w is not negative.
/// An open curve whose chord is seen end-on (to 1e-12 of its size), and one whose ends coincide,
/// counts as closed; no area counts as positive. SceneCurve::flipNormal reverses the answer.
int normalSide(const SceneCurve& curve, const ViewFrame& frame);

/// That of every curve of the scene in its view.
std::vector<int> normalSides(const Scene& scene);

}  // namespace flatland
