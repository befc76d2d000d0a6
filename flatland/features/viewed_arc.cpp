// SPDX-License-Identifier: MIT
#include "flatland/features/viewed_arc.h"

#include <algorithm>
#include <cmath>

#include "flatland/features/proxy_arc.h"
#include "flatland/features/regular_arc.h"
#include "flatland/features/tolerances.h"

namespace flatland {

namespace {

/// Marks as roots of polynomials, with certified signs.
class PolynomialArc final : public ViewedArc {
 public:
  PolynomialArc(RegularArc arc, int index, const ViewFrame& frame, double scale)
      : geometry_(std::move(arc)), polynomials_(polynomialsOf(geometry_, frame, scale)) {
    piece = index;
    tLow = geometry_.tLow;
    tHigh = geometry_.tHigh;
    startDirection = geometry_.startDirection();
    endDirection = geometry_.endDirection();
    startCurvature = polynomials_.startCurvature;
    endCurvature = polynomials_.endCurvature;
    for (std::optional<double>* k : {&startCurvature, &endCurvature}) {
      if (*k) **k *= scale;
    }
    straight = geometry_.straight || polynomials_.curvature.isZero();
    if (straight) {
      if (isEndOn(frame, scale)) polynomials_.silhouette = Bernstein::fromDoubles({0.0});
      endOn = polynomials_.silhouette.isZero();
    }
  }

  int signAt(ArcFunction function, double s) const override {
    return polynomial(function).at(s).certainSign();
  }

 private:
  Roots findRoots(ArcFunction function) const override {
    if (straight && function != ArcFunction::Silhouette) return {};
    return isolateRoots(polynomial(function));
  }

  const Bernstein& polynomial(ArcFunction function) const {
    switch (function) {
      case ArcFunction::Silhouette:
        return polynomials_.silhouette;
      case ArcFunction::Curvature:
        return polynomials_.curvature;
      case ArcFunction::CurvaturePrime:
        return polynomials_.curvaturePrime;
      case ArcFunction::LambdaPrime:
        return polynomials_.lambdaPrime;
      case ArcFunction::Fold:
        break;
    }
    if (!fold_) fold_ = foldPolynomial(geometry_);
    return *fold_;
  }

  // The line of sight runs along the piece: at its nearest and farthest point the sine is tiny.
  bool isEndOn(const ViewFrame& frame, double scale) const {
    const auto sine = [&](const Vec2& direction, const Bounded& x, const Bounded& y) {
      const Vec2 point = Vec2(x.value(), y.value()) / scale;
      return std::abs(cross(direction, towardsViewer(frame, point)));
    };
    return sine(startDirection, geometry_.x.first(), geometry_.y.first()) < kEndOnSine &&
           sine(endDirection, geometry_.x.last(), geometry_.y.last()) < kEndOnSine;
  }

  RegularArc geometry_;
  ArcPolynomials polynomials_;
  mutable std::optional<Bernstein> fold_;
};

}  // namespace

const Roots& ViewedArc::roots(ArcFunction function) const {
  std::optional<Roots>& known = roots_[static_cast<std::size_t>(function)];
  if (!known) known = findRoots(function);
  return *known;
}

std::vector<std::unique_ptr<ViewedArc>> viewedArcs(const Curve& curve, int piece,
                                                   const ViewFrame& frame, double extent,
                                                   RootMethod method) {
  const BezierChain* chain = bezierForm(curve);
  if (!chain || method == RootMethod::Proxies) {
    return proxyArcs([&curve, piece](double t) { return derivativesAt(curve, piece, t); }, piece,
                     frame, extent);
  }
  const double scale = unitScale(extent);
  std::vector<std::unique_ptr<ViewedArc>> arcs;
  for (RegularArc& arc : regularArcs(chain->piece(piece), scale)) {
    arcs.push_back(std::make_unique<PolynomialArc>(std::move(arc), piece, frame, scale));
  }
  return arcs;
}

std::vector<double> foldCuts(const Curve& curve, int piece, const ViewFrame& frame, double extent) {
  std::vector<double> cuts;
  const auto cutAt = [&cuts](const Roots& roots) {
    for (const Root& root : roots.roots) cuts.push_back(root.t);
    for (const RootInterval& open : roots.unresolved) {
      cuts.push_back(open.low);
      cuts.push_back(open.high);
    }
  };
  if (const BezierChain* chain = bezierForm(curve)) {
    const double scale = unitScale(extent);
    const Bezier bezier = chain->piece(piece);
    cutAt(isolateRoots(silhouettePolynomial(bezier, frame, scale)));
    if (frame.distance) {
      std::vector<double> depths;
      for (const Vec2& p : bezier.points) {
        depths.push_back(scale * (*frame.distance - p.dot(frame.towards)));
      }
      cutAt(isolateRoots(Bernstein::fromDoubles(depths)));
    }
  } else {
    cutAt(proxyRoots([&](double t) {
            return arcFunctionAt(ArcFunction::Silhouette, derivativesAt(curve, piece, t), frame);
          }).roots);
    if (frame.distance) {
      cutAt(proxyRoots([&](double t) {
              const Vec2 p = derivativesAt(curve, piece, t)[0];
              return Measured{*frame.distance - p.dot(frame.towards), *frame.distance + p.norm()};
            }).roots);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace flatland
