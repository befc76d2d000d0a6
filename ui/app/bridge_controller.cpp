// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/bridge_controller.h"

#include "ui/app/docks.h"
#include "ui/commands/sweep_command.h"
#include "ui/view3d/section_panel.h"

namespace flatland::ui {

BridgeController::BridgeController(const CanvasModels& models, Docks& docks, SectionPanel& section,
                                   QObject* parent)
    : QObject(parent), models_(models), docks_(docks), section_(section) {
  connect(&section_, &SectionPanel::curvesOpened, this, [this] {
    emit curvesWanted();
    emit said(tr("The section is in flatland; undo brings the curves back."));
  });
}

void BridgeController::sweep(SweptSurface::Kind kind) {
  const std::optional<std::size_t> curve = models_.selection.currentCurve();
  if (!curve) return emit said(tr("There is no curve to make a surface of."));
  sweepCurve(models_.document, *curve, kind);
  emit surfaceWanted();
  docks_.show("bridge");
}

void BridgeController::cutAlongView() {
  emit surfaceWanted();
  docks_.show("section");
  section_.cutAlongView();
}

void BridgeController::cutAlongRidge() {
  emit surfaceWanted();
  docks_.show("section");
  section_.cutAlongRidge();
}

void BridgeController::openSection() { section_.openAsCurve(); }

}  // namespace flatland::ui
