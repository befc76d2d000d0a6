// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"
#include "ui/export/figure.h"
#include "ui/export/mark_style.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

/// Which shares of a row of colours values get: from `low` to `high`, both shown at the ends of the
/// legend; beyond them the end.
struct ColourScale {
  SurfaceQuantity quantity = SurfaceQuantity::Lambda;
  bool diverging = false;    ///< around 0 (ratios: around 1), else from low to high
  bool logarithmic = false;  ///< low and high are exponents of 10
  double low = 0.0, high = 1.0;
  /// Above 0: linear to about this value on either side of 0 and logarithmic beyond, by asinh.
  double knee = 0.0;

  /// Where on the scale a value is, in [0, 1]; below 0 if there is no value (NaN).
  double share(double value) const;
  /// Of a share: dark or pale as the background in the middle of a diverging scale and at the low
  /// end of others, so that lines stand out from it as from paper. Teal and purple, or blue: none
  /// of them the colour of a usual line, and told apart by the colour blind.
  Rgb at(double share, Palette palette) const;
  /// The colours that at() goes through at shares 0, 1/4, ... 1, linearly between.
  std::array<Rgb, 5> stops(Palette palette) const;
  static constexpr Rgb kNoValue{0x9A, 0x9A, 0x9A};

  /// Values to mark on a legend: ends and middle of the scale, powers of ten between.
  std::vector<double> ticks() const;
};

/// A place on the scale for each vertex of a mesh.
struct VertexColours {
  std::vector<float> share;  ///< as ColourScale::share
  ColourScale scale;
};

/// The colours of a quantity seen from a view. The ends of the scale are the values, rounded to two
/// digits, that all but two in a hundred vertices stay within, of what depends on the view those
/// that are turned well to the viewer; of lambda, whose scale is logarithmic, two in a hundred at
/// either end. Curvatures and terms have long tails: their scale is linear for the half of the
/// vertices that is nearest to 0 and logarithmic beyond. Curvatures are made dimensionless by the
/// size of the surface.
VertexColours vertexColours(const TriangleMesh& mesh, const SurfaceFields& fields,
                            const SurfaceView& view, SurfaceQuantity quantity);

}  // namespace flatland::ui
