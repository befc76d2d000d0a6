// SPDX-License-Identifier: MIT
#include "flatland/features/features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "flatland/curve/arc_length.h"
#include "flatland/features/curve_marks.h"
#include "flatland/features/orientation.h"
#include "flatland/features/terms.h"
#include "flatland/screen/visibility.h"

namespace flatland {

namespace {

constexpr std::array<std::string_view, kMarkKindCount> kNames = {
    "silhouette", "inflection", "ridge",          "valley",
    "flat",       "corner",     "apparent-ridge", "apparent-minimum"};

// Relative to the control polygon; about what arcLength can reach.
constexpr double kArcLengthAccuracy = 1e-13;

// Sixth powers of lengths, and of their inverses, stay finite up to here.
constexpr double kLargestExtent = 1e52;

double residualFor(MarkKind kind, const Residuals& residuals) {
  switch (kind) {
    case MarkKind::Silhouette:
      return residuals.silhouette;
    case MarkKind::Inflection:
      return residuals.inflection;
    case MarkKind::Ridge:
    case MarkKind::Valley:
    case MarkKind::Flat:
      return residuals.extremum;
    case MarkKind::Corner:
      return 0.0;
    case MarkKind::ApparentRidge:
    case MarkKind::ApparentMinimum:
      return residuals.apparentRidge;
  }
  return 0.0;
}

// Everything about a mark but its arc length and visibility.
Mark valued(const CurveMark& found, int index, const Curve& curve, const ViewFrame& frame, int side,
            double length) {
  const Jet jet = jetAt(curve, found.piece, found.t);
  Mark mark{};
  mark.kind = found.kind;
  mark.curve = index;
  mark.t = found.piece + found.t;
  mark.point = jet.p;
  mark.screen = screenCoordinate(frame, jet.p);
  mark.turnDeg = found.turnRad * (180.0 / std::numbers::pi);
  // At a corner or cusp the terms differ on both sides, or do not exist.
  if (found.kind == MarkKind::Corner) return mark;
  const Jet valueJet =
      found.valueAt ? jetAt(curve, found.valueAt->first, found.valueAt->second) : jet;
  if (!(valueJet.d1.squaredNorm() > 0.0)) return mark;
  const Terms terms = termsAt(valueJet, frame, side);
  if (found.kind != MarkKind::Silhouette) mark.lambda = terms.lambda;
  mark.feature = terms.feature;
  mark.offset = terms.offset;
  mark.perspective = terms.perspective;
  if (!found.atJoint) mark.residual = residualFor(found.kind, residualsAt(jet, frame, length));
  return mark;
}

// Arc lengths of marks sorted by t, each from the one before.
void measure(std::vector<Mark>& marks, const Curve& curve, double length) {
  double t = 0.0, u = 0.0;
  for (Mark& mark : marks) {
    if (mark.t > t) {
      u += arcLength(curve, t, mark.t, kArcLengthAccuracy * length).value;
      t = mark.t;
    }
    mark.u = u;
  }
}

}  // namespace

std::string_view nameOf(MarkKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<MarkKind> markKindNamed(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<MarkKind>(found - kNames.begin());
}

bool FeatureSet::certified() const {
  return std::all_of(searches.begin(), searches.end(),
                     [](const CurveSearch& search) { return search.certified; });
}

double FeatureSet::errorBound() const {
  double bound = 0.0;
  for (const CurveSearch& search : searches) bound = std::max(bound, search.errorBound);
  return bound;
}

FeatureSet findFeatures(const Scene& scene) {
  const ViewFrame frame = frameOf(scene.view);
  const Visibility visibility(scene);
  FeatureSet result;
  for (int i = 0; i < static_cast<int>(scene.curves.size()); ++i) {
    const SceneCurve& curve = scene.curves[static_cast<std::size_t>(i)];
    const int side = normalSide(curve, frame);
    const double length = lengthScale(curve.shape);
    if (length > kLargestExtent || (length > 0.0 && length < 1.0 / kLargestExtent)) {
      result.unresolved.push_back({MarkKind::Silhouette, i, 0.0, pieceCount(curve.shape) + 0.0,
                                   "the curve is too large or too small for double precision"});
      continue;
    }
    CurveMarks found = findCurveMarks(curve.shape, frame, side);

    std::vector<Mark> marks;
    for (const CurveMark& mark : found.marks) {
      marks.push_back(valued(mark, i, curve.shape, frame, side, length));
    }
    std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
      return std::tie(a.t, a.kind) < std::tie(b.t, b.kind);
    });
    measure(marks, curve.shape, length);
    for (Mark& mark : marks) mark.visible = visibility.isVisible(i, mark.t);

    const ProxyQuality& quality = found.quality;
    result.searches.push_back(
        {i, quality.pieces == 0, quality.pieces, quality.degree, quality.error});
    for (Unresolved& open : found.unresolved) open.curve = i;
    for (Degenerate& piece : found.degenerate) piece.curve = i;
    result.marks.insert(result.marks.end(), marks.begin(), marks.end());
    result.unresolved.insert(result.unresolved.end(), found.unresolved.begin(),
                             found.unresolved.end());
    result.degenerate.insert(result.degenerate.end(), found.degenerate.begin(),
                             found.degenerate.end());
  }
  return result;
}

}  // namespace flatland
