// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/bridge_source.h"

namespace flatland::ui {

namespace {

std::shared_ptr<const BridgeView> bridgeOf(const std::shared_ptr<const SeenSurface>& seen) {
  const LoadedSurface& surface = *seen->surface;
  const SweptOrigin& origin = *surface.swept;
  BridgePrediction prediction(origin.surface, seen->view);
  BridgeView view{seen, std::move(prediction), {}, {}};
  if (!view.prediction.flat().view) return std::make_shared<const BridgeView>(std::move(view));
  const double size = surface.fields->size * surface.mesh->unit;
  view.row = compareLines(view.prediction, origin.mesh, *surface.mesh, size, *seen->compared.get());
  view.row.cells = origin.cells;
  const BridgeScale scale{view.row.edge, size};
  for (const PredictedLine& line : view.prediction.lines()) {
    view.limits.push_back(view.prediction.limitOf(line, scale));
  }
  return std::make_shared<const BridgeView>(std::move(view));
}

}  // namespace

BridgeSource::BridgeSource(const SeenSource& seen, QObject* parent)
    : QObject(parent), seen_(seen), job_([this] { predict(); }) {
  connect(&seen_, &SeenSource::changed, this, &BridgeSource::follow);
  connect(&job_, &LatestJob::failed, this, &BridgeSource::failed);
}

void BridgeSource::setShown(bool shown) {
  if (shown == shown_) return;
  shown_ = shown;
  emit changed();
}

void BridgeSource::follow() {
  const std::shared_ptr<const SeenSurface>& seen = seen_.seen();
  if (!seen || !seen->surface->swept) {
    job_.cancel();
    if (!view_) return;
    view_.reset();
    emit changed();
    return;
  }
  job_.wish();
}

void BridgeSource::predict() {
  using Data = std::shared_ptr<const BridgeView>;
  job_.start<Data>(
      [seen = seen_.seen()](const JobControl&) -> std::optional<Data> { return bridgeOf(seen); },
      [this](const Data& view) {
        view_ = view;
        emit changed();
      });
}

}  // namespace flatland::ui
