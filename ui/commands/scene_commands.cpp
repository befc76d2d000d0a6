// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/scene_commands.h"

#include <cassert>
#include <cmath>

#include "ui/commands/command_ids.h"

namespace flatland::ui {

SetView::SetView(Document& document, const View& view, int gesture)
    : document_(document), before_(document.scene().view), after_(view), gesture_(gesture) {
  assert(!view.distance || (*view.distance > 0.0 && std::isfinite(*view.distance)));
  const bool perspective = view.distance.has_value();
  setText(perspective != document.scene().view.distance.has_value() ? tr("change projection")
                                                                    : tr("turn view"));
  setObsolete(after_ == before_);
}

int SetView::id() const { return gesture_ == 0 ? -1 : kViewCommandId; }

bool SetView::mergeWith(const QUndoCommand* other) {
  const auto& later = *static_cast<const SetView*>(other);
  if (later.gesture_ != gesture_) return false;
  after_ = later.after_;
  setObsolete(after_ == before_);
  return true;
}

void SetViewAndProbe::swapPlace() {
  const std::optional<Probe::Place> now = probe_.place();
  probe_.setPlace(place_);
  place_ = now;
}

ReplaceScene::ReplaceScene(Document& document, Scene scene, const QString& text)
    : QUndoCommand(text), document_(document), scene_(std::move(scene)) {
  setObsolete(scene_ == document_.scene());
}

SetSurface::SetSurface(Document& document, std::optional<SurfaceSetting> surface,
                       const QString& text, int gesture)
    : QUndoCommand(text), document_(document), surface_(std::move(surface)), gesture_(gesture) {
  setObsolete(surface_ == document_.scene().surface);
}

int SetSurface::id() const { return gesture_ == 0 ? -1 : kSurfaceCommandId; }

bool SetSurface::mergeWith(const QUndoCommand* other) {
  if (static_cast<const SetSurface*>(other)->gesture_ != gesture_) return false;
  setObsolete(surface_ == document_.scene().surface);  // the other is done already
  return true;
}

}  // namespace flatland::ui
