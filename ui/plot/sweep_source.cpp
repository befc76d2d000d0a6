// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sweep_source.h"

#include <algorithm>

#include "flatland/features/orientation.h"
#include "ui/export/sweep_figure.h"

namespace flatland::ui {

namespace {

constexpr double kAccuracy = 1e-9;  // of the scene's size
constexpr int kHalvings = 60;

double accuracyIn(const Scene& scene) {
  const double size = boundsOf(scene).diagonal();
  return size > 0.0 ? kAccuracy * size : kAccuracy;
}

// The view matters to a sweep only in which of the two names the sides bear.
bool sameButView(const Scene& a, const Scene& b) {
  if (a.curves != b.curves) return false;
  const ViewFrame fa = frameOf(a.view), fb = frameOf(b.view);
  return std::all_of(a.curves.begin(), a.curves.end(), [&](const SceneCurve& curve) {
    return normalSide(curve, fa) == normalSide(curve, fb);
  });
}

}  // namespace

double SweepData::lengthAt(int curve, double t) const {
  const Curve& shape = scene.curves[static_cast<std::size_t>(curve)].shape;
  return arcLength(shape, 0.0, t, accuracyIn(scene)).value;
}

double SweepData::parameterAt(int curve, double u) const {
  const Curve& shape = scene.curves[static_cast<std::size_t>(curve)].shape;
  double low = 0.0, high = pieceCount(shape), below = 0.0;
  const double accuracy = accuracyIn(scene);
  for (int i = 0; i < kHalvings && high - low > 1e-12; ++i) {
    const double middle = 0.5 * (low + high);
    const double step = arcLength(shape, low, middle, accuracy).value;
    if (below + step <= u) {
      low = middle, below += step;
    } else {
      high = middle;
    }
  }
  return 0.5 * (low + high);
}

SweepSource::SweepSource(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &SweepSource::follow);
  connect(&job_, &Job::failed, this, &SweepSource::failed);
  connect(&job_, &Job::runningChanged, this, &SweepSource::changed);
}

void SweepSource::setActive(bool active) {
  active_ = active;
  if (active_ && waiting_) start();
}

void SweepSource::follow(const Change& change) {
  if (!change.touchesScene()) return;
  // Also while it is being computed, or an animation would start it anew with every frame.
  if (change.what == Change::What::View && !waiting_ && sameButView(started_, document_.scene())) {
    return;
  }
  waiting_ = true;
  if (active_) start();
  emit changed();
}

void SweepSource::start() {
  waiting_ = false;
  started_ = document_.scene();
  using Data = std::shared_ptr<const SweepData>;
  const auto show = [this](const Data& data) {
    data_ = data;
    emit changed();
  };
  job_.start<Data>(
      [scene = started_, show](const JobControl& control) -> std::optional<Data> {
        auto first = std::make_shared<SweepData>();
        first->scene = scene;
        first->sweep = sweepOf(scene);
        first->lengths = curveLengths(scene);
        if (control.isCancelled()) return std::nullopt;
        control.deliver([show, data = Data(first)] { show(data); });
        auto whole = std::make_shared<SweepData>(*first);
        whole->visibility =
            visibilityOf(first->sweep, scene, [&control] { return !control.isCancelled(); });
        if (control.isCancelled()) return std::nullopt;
        return whole;
      },
      show);
}

}  // namespace flatland::ui
