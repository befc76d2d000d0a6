// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/panels.h"

#include <QCoreApplication>

#include "ui/app/status_line.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/points_panel.h"
#include "ui/panels/view_panel.h"

namespace flatland::ui {

void addPanels(Docks& docks, const CanvasModels& models, StatusLine& status) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Panels", text); };
  using Group = Docks::Group;
  docks.add("view", tr("View"), new ViewPanel(models.document, models.stage), Group::Top);
  docks.add("legend", tr("Legend"), new LegendPanel(models.document, models.display), Group::Side);
  auto* points = new PointsPanel(models.document, models.selection);
  QObject::connect(points, &PointsPanel::refused, &status, &StatusLine::say);
  docks.add("points", tr("Points"), points, Group::Side);
  docks.add("marks", tr("Marks"), new MarksPanel(models), Group::Bottom);
}

}  // namespace flatland::ui
