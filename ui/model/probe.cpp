// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/probe.h"

#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"

namespace flatland::ui {

Probe::Probe(const Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &Probe::follow);
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
  if (!place_) return std::nullopt;
  const Scene& scene = document_.scene();
  const SceneCurve& curve = scene.curves[place_->curve];
  const Jet jet = jetAt(curve.shape, place_->t);
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  const ViewFrame view = frameOf(scene.view);
  const int side = normalSide(curve, view);
  return Reading{jet, frameOf(jet, side), side, termsAt(jet, view, side)};
}

void Probe::follow(const Change& change) {
  if (!place_ || !change.touchesScene()) return;
  place_ = change.what == Change::What::Scene ? std::nullopt : valid(place_);
  emit changed();
}

}  // namespace flatland::ui
