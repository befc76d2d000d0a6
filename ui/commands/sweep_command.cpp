// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/sweep_command.h"

#include <QCoreApplication>

#include "ui/commands/scene_commands.h"
#include "ui/model/surface_panes.h"

namespace flatland::ui {

namespace {

struct SweepCommandWords {
  Q_DECLARE_TR_FUNCTIONS(SweepCommand)
};

}  // namespace

void sweepCurve(Document& document, std::size_t curve, SweptSurface::Kind kind) {
  const bool revolution = kind == SweptSurface::Kind::Revolution;
  const QString text =
      revolution ? SweepCommandWords::tr("revolve curve") : SweepCommandWords::tr("extrude curve");
  const SurfaceSetting setting = sweptSetting(document.scene(), curve, kind);
  View view = document.scene().view;
  if (revolution) view.angleDeg = setting.camera.towards.y() < 0.0 ? -90.0 : 90.0;
  // The same again is no step: it only brings the camera back.
  const bool isNew = !document.scene().surface || !(document.scene().view == view) ||
                     !(withCamera(*document.scene().surface, setting.camera) == setting);
  if (isNew) {
    document.undoStack().beginMacro(text);
    auto turn = std::make_unique<SetView>(document, view);
    turn->setObsolete(false);  // the camera may turn the view, and undo brings this one back
    document.push(std::move(turn));
    document.push(std::make_unique<SetSurface>(document, setting, text));
    document.undoStack().endMacro();
  }
  // A surface that was swept before has kept its cameras.
  for (std::size_t pane = 0; pane < paneCount(setting); ++pane) {
    document.setCamera(paneCamera(setting, pane), pane);
  }
}

}  // namespace flatland::ui
