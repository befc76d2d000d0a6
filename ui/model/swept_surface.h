// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core3d/study/bridge_lines.h"
#include "flatland/scene/scene.h"

namespace flatland::ui {

// The surface that a scene sweeps from one of its curves, as values.

/// True if the scene's surface is swept from a curve, whether or not that can be.
bool isSwept(const Scene& scene);

/// The surface itself. Its outside is where flatland's front is: on the side of the curve's normal,
/// as the flat view sees it that belongs to the camera, or where there is none, that of the scene.
/// nullopt if it is not swept, its curve is not there, or an amount is out of range.
std::optional<SweptSurface> sweptOf(const Scene& scene);

/// The kind a setting names; an extrusion for a name that is none.
SweptSurface::Kind kindOf(const SweptSetting& swept);
std::string nameOf(SweptSurface::Kind kind);  ///< "extrusion", "revolution"

/// What the scene's surface becomes if a curve of it is swept: an extrusion as high as the curve is
/// large, or a revolution about an axis beside it, seen as the scene is (usualCamera). Families and
/// style stay, kept cameras if one of the same kind was there. Precondition: there is such a curve.
SurfaceSetting sweptSetting(const Scene& scene, std::size_t curve, SweptSurface::Kind kind);

/// The setting with the usual threshold of apparent ridges lowered to 0, which sweptSetting does: a
/// swept mesh has no noise to hide, and each ridge that flatland predicts should be found. And back
/// again, for another surface.
SurfaceSetting withEveryRidge(SurfaceSetting setting);
SurfaceSetting withUsualRidges(SurfaceSetting setting);

/// The camera from which a swept surface is shown first. Extrusion: the flat view's direction,
/// raised out of the plane of the curve, rulings upright. Revolution: along the axis, from the end
/// that the flat view is nearer to.
SurfaceCamera usualCamera(SweptSurface::Kind kind, const View& flat);

}  // namespace flatland::ui
