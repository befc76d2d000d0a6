// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"
#include "ui/export/figure.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

/// Which colours values get: from `low` to `high`, both shown at the ends of the legend; beyond
/// them the colour of the end.
struct ColourScale {
  SurfaceQuantity quantity = SurfaceQuantity::Lambda;
  bool diverging = false;    ///< around 0 (ratios: around 1), else from low to high
  bool logarithmic = false;  ///< low and high are exponents of 10
  double low = 0.0, high = 1.0;

  /// Of a share in [0, 1] of the scale: blue over white to orange, or black-blue to yellow. Both
  /// can be told apart by the colour blind and grow lighter or darker steadily.
  Rgb at(double share) const;
  Rgb of(double value) const;  ///< grey if there is no value (NaN)
};

/// A colour for each vertex of a mesh.
struct VertexColours {
  std::vector<Rgb> rgb;
  ColourScale scale;
};

/// The colours of a quantity seen from a view. The ends of the scale are the values that all but
/// two in a hundred vertices stay within, of what depends on the view those that are turned well to
/// the viewer; of lambda, whose scale is logarithmic, two in a hundred at either end. Curvatures
/// are made dimensionless by the size of the surface.
VertexColours vertexColours(const TriangleMesh& mesh, const SurfaceFields& fields,
                            const SurfaceView& view, SurfaceQuantity quantity);

}  // namespace flatland::ui
