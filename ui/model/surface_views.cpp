// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_views.h"

#include <algorithm>

namespace flatland::ui {

SurfaceViews::SurfaceViews(const Document& document, const SurfaceSource& source, QObject* parent)
    : QObject(parent), document_(document), ink_(document, source) {
  for (std::size_t pane = 0; pane <= kMostPanes; ++pane) {
    SeenSource* first = seen_.empty() ? nullptr : seen_.front().get();
    seen_.push_back(std::make_unique<SeenSource>(document, source, pane, first, &ink_));
    connect(seen_.back().get(), &SeenSource::failed, this, &SurfaceViews::failed);
  }
  connect(&ink_, &InkSource::failed, this, &SurfaceViews::failed);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface() && active_ >= count()) setActive(0);
  });
}

bool SurfaceViews::isStale() const {
  return ink_.isStale() || std::any_of(seen_.begin(), seen_.end(),
                                       [](const auto& source) { return source->isStale(); });
}

std::size_t SurfaceViews::count() const {
  const auto& setting = document_.scene().surface;
  return setting ? paneCount(*setting) : 1;
}

void SurfaceViews::setActive(std::size_t pane) {
  if (pane == active_ || pane >= count()) return;
  active_ = pane;
  emit activeChanged();
}

}  // namespace flatland::ui
