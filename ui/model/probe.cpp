// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/probe.h"

#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"
#include "flatland/study/probe_geometry.h"

namespace flatland::ui {

Probe::Probe(const Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &Probe::follow);
  place_ = home();
  remember();
}

std::optional<Probe::Place> Probe::home(std::size_t curve) const {
  constexpr double kShare = 0.69;  // of the curve
  const auto& curves = document_.scene().curves;
  if (curve >= curves.size()) return std::nullopt;
  return Place{curve, kShare * pieceCount(curves[curve].shape)};
}

void Probe::remember() {
  if (place_) point_ = pointAt(document_.scene().curves[place_->curve].shape, place_->t);
}

std::optional<Probe::Place> Probe::valid(std::optional<Place> place) const {
  const auto& curves = document_.scene().curves;
  if (!place || place->curve >= curves.size() || std::isnan(place->t)) return std::nullopt;
  const double end = pieceCount(curves[place->curve].shape);
  return Place{place->curve, std::clamp(place->t, 0.0, end)};
}

void Probe::setPlace(std::optional<Place> place) {
  place = valid(place);
  if (place == place_) return;
  place_ = place;
  remember();
  emit changed();
}

void Probe::moveBy(double share) {
  const auto& curves = document_.scene().curves;
  if (curves.empty()) return;
  if (!place_) {
    setPlace(Place{0, 0.5 * pieceCount(curves[0].shape)});
    return;
  }
  const Curve& curve = curves[place_->curve].shape;
  const double end = pieceCount(curve);
  double t = place_->t + share * end;
  if (isClosed(curve)) t -= end * std::floor(t / end);
  setPlace(Place{place_->curve, t});
}

std::optional<Probe::Reading> Probe::reading() const {
  return place_ ? readingAt(document_.scene(), *place_) : std::nullopt;
}

std::optional<Probe::Reading> Probe::readingAt(const Scene& scene, const Place& place) {
  const SceneCurve& curve = scene.curves[place.curve];
  const Jet jet = jetAt(curve.shape, place.t);
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  const ViewFrame view = frameOf(scene.view);
  const int side = normalSide(curve, view);
  return Reading{jet, frameOf(jet, side), side, termsAt(jet, view, side), lengthScale(curve.shape)};
}

std::optional<double> Probe::valueOf(const Reading& reading, ProfileQuantity quantity) {
  const Terms& terms = reading.terms;
  switch (quantity) {
    case ProfileQuantity::Curvature:
      return terms.k;
    case ProfileQuantity::Lambda:
      return lambdaAt(terms);
    case ProfileQuantity::Feature:
      return terms.feature;
    case ProfileQuantity::Offset:
      return terms.offset;
    case ProfileQuantity::Perspective:
      return terms.perspective;
    case ProfileQuantity::Sum:
      return terms.sum();
    case ProfileQuantity::Ratio:
      break;
  }
  return termRatioAt(terms, reading.size);
}

void Probe::follow(const Change& change) {
  if (!change.touchesScene()) return;
  if (change.what == Change::What::Scene) {
    place_ = home();
  } else if (!place_) {
    return;
  } else {
    const std::optional<std::size_t> curve = change.shift.after(place_->curve);
    const std::optional<Place> kept = curve ? valid(Place{*curve, place_->t}) : std::nullopt;
    place_ = kept ? kept : home();  // another curve may be left when its own is gone
    if (kept && change.what == Change::What::Topology) {
      // Parameters count anew; the shape may not have changed at all.
      place_->t = nearestPoint(document_.scene().curves[place_->curve].shape, point_).t;
    }
  }
  remember();
  emit changed();
}

}  // namespace flatland::ui
