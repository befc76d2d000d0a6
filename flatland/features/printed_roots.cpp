// SPDX-License-Identifier: MIT
#include "flatland/features/printed_roots.h"

#include <algorithm>
#include <cmath>

#include "flatland/features/regular_arc.h"
#include "flatland/roots/chebyshev.h"

namespace flatland {

namespace {

// What a piece adds: roots in its parameter.
struct PieceRoots {
  std::vector<double> t;
  int unresolved = 0;
};

PieceRoots onBezier(const Bezier& piece, const ViewFrame& frame, double scale) {
  PieceRoots found;
  for (const RegularArc& arc : regularArcs(piece, scale)) {
    if (arc.straight) continue;
    const Roots roots = isolateRoots(printedPolynomial(arc, frame, scale));
    for (const Root& root : roots.roots) {
      // At an end that is a cusp the equation is not defined; its zeros there are of our making.
      const bool atCusp =
          (root.t <= 0.0 && arc.zerosAtStart > 0) || (root.t >= 1.0 && arc.zerosAtEnd > 0);
      if (!atCusp) found.t.push_back(arc.tLow + root.t * (arc.tHigh - arc.tLow));
    }
    found.unresolved += static_cast<int>(roots.unresolved.size());
  }
  return found;
}

PieceRoots onPiece(const Curve& curve, int piece, const ViewFrame& frame, double scale) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) {
    return onBezier(chain->piece(piece), frame, scale);
  }
  PieceRoots found;
  const Roots roots = printedRootsByProxy(curve, piece, frame);
  for (const Root& root : roots.roots) found.t.push_back(root.t);
  found.unresolved = static_cast<int>(roots.unresolved.size());
  return found;
}

constexpr double kArcLengthAccuracy = 1e-9;  // of the control polygon

PrintedRoot rootAt(const Curve& shape, const ViewFrame& frame, int curve, double t, double u) {
  PrintedRoot root{};
  root.curve = curve;
  root.t = t;
  root.u = u;
  root.point = pointAt(shape, t);
  root.screen = screenCoordinate(frame, root.point);
  return root;
}

void compare(PrintedRoot& root, const FeatureSet& features, double length, bool closed) {
  constexpr double kSameT = 1e-9;
  for (const Mark& mark : features.marks) {
    if (mark.kind != MarkKind::ApparentRidge || mark.curve != root.curve) continue;
    if (std::abs(mark.t - root.t) <= kSameT) root.isMaximum = true;
    double along = std::abs(mark.u - root.u);
    if (closed) along = std::min(along, std::max(length - along, 0.0));
    if (!root.alongToApparentRidge || along < *root.alongToApparentRidge) {
      root.alongToApparentRidge = along;
      root.shareToApparentRidge = length > 0.0 ? along / length : 0.0;
    }
    if (!root.screen || !mark.screen) continue;
    const double distance = std::abs(*mark.screen - *root.screen);
    if (!root.toApparentRidge || distance < *root.toApparentRidge) {
      root.toApparentRidge = distance;
    }
  }
}

}  // namespace

int PrintedRoots::maxima() const {
  return static_cast<int>(
      std::count_if(roots.begin(), roots.end(), [](const PrintedRoot& r) { return r.isMaximum; }));
}

const PrintedRoot* PrintedRoots::nearest() const {
  const PrintedRoot* best = nullptr;
  for (const PrintedRoot& root : roots) {
    if (!root.shareToApparentRidge) continue;
    if (!best || *root.shareToApparentRidge < *best->shareToApparentRidge) best = &root;
  }
  return best;
}

const PrintedRoot* PrintedRoots::farthest() const {
  const PrintedRoot* worst = nullptr;
  for (const PrintedRoot& root : roots) {
    if (!root.shareToApparentRidge) continue;
    if (!worst || *root.shareToApparentRidge > *worst->shareToApparentRidge) worst = &root;
  }
  return worst;
}

Roots printedRootsByProxy(const Curve& curve, int piece, const ViewFrame& frame) {
  const auto value = [&](double t) -> Measured {
    const Jet jet = jetAt(curve, piece, t);
    // Towards the viewer, not of unit length: from the point in perspective.
    const Vec2 w = frame.distance ? Vec2(frame.eye() - jet.p) : frame.towards;
    const double c = cross(jet.d1, jet.d2), cPrime = cross(jet.d1, jet.d3);
    const double s2 = jet.d1.squaredNorm(), h = jet.d1.dot(jet.d2);
    const double nw = cross(jet.d1, w), tw = jet.d1.dot(w);  // left normal
    const auto size = [](const Vec2& a, const Vec2& b) { return a.norm() * b.norm(); };
    const double cSize = size(jet.d1, jet.d2), cPrimeSize = size(jet.d1, jet.d3);
    const double wSize = size(jet.d1, w);
    return {nw * (cPrime * s2 - 3.0 * c * h) - c * c * tw,
            wSize * (cPrimeSize * s2 + 3.0 * cSize * cSize) + cSize * cSize * wSize};
  };
  return proxyRoots(value).roots;
}

PrintedRoots findPrintedRoots(const Scene& scene, const FeatureSet& features) {
  PrintedRoots found;
  const ViewFrame frame = frameOf(scene.view);
  for (std::size_t c = 0; c < scene.curves.size(); ++c) {
    const Curve& curve = scene.curves[c].shape;
    double reach = 0.0;
    for (const Vec2& p : controlPoints(curve)) reach = std::max(reach, p.norm());
    const int pieces = pieceCount(curve);
    std::vector<double> ts;
    for (int piece = 0; piece < pieces; ++piece) {
      const PieceRoots roots = onPiece(curve, piece, frame, unitScale(reach));
      for (const double t : roots.t) ts.push_back(piece + t);
      found.unresolved += roots.unresolved;
    }
    if (ts.empty()) continue;
    std::sort(ts.begin(), ts.end());
    const double accuracy = kArcLengthAccuracy * lengthScale(curve);
    const std::size_t first = found.roots.size();
    double before = 0.0, u = 0.0;
    for (const double t : ts) {
      u += arcLength(curve, before, t, accuracy).value;
      before = t;
      found.roots.push_back(rootAt(curve, frame, static_cast<int>(c), t, u));
    }
    const double length = u + arcLength(curve, before, pieces, accuracy).value;
    for (std::size_t i = first; i < found.roots.size(); ++i) {
      compare(found.roots[i], features, length, isClosed(curve));
    }
  }
  return found;
}

}  // namespace flatland
