// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/panels.h"

#include <QCoreApplication>

#include "ui/app/message_bar.h"
#include "ui/app/status_line.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/panels/curve_panel.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/points_panel.h"
#include "ui/panels/probe_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plot/limits_panel.h"
#include "ui/plot/plots_panel.h"
#include "ui/plot/study_panel.h"
#include "ui/plot/sweep_panel.h"
#include "ui/view3d/bridge_panel.h"
#include "ui/view3d/derivation_panel.h"
#include "ui/view3d/families_panel.h"
#include "ui/view3d/section_panel.h"
#include "ui/view3d/surface_panel.h"
#include "ui/view3d/triangle_panel.h"

namespace flatland::ui {

namespace {

struct PanelsWords {
  Q_DECLARE_TR_FUNCTIONS(Panels)
};

}  // namespace

void addPanels(Docks& docks, const CanvasModels& models, const PanelParts& parts) {
  StatusLine& status = parts.status;
  using Group = Docks::Group;
  docks.add("view", PanelsWords::tr("View"), new ViewPanel(models.document, models.stage),
            Group::Top);
  docks.add("legend", PanelsWords::tr("Legend"), new LegendPanel(models.document, models.display),
            Group::Side);
  docks.add("probe", PanelsWords::tr("Probe"),
            new ProbePanel(models.document, models.probe, parts.plots), Group::Side);
  auto* points = new PointsPanel(models.document, models.selection);
  QObject::connect(points, &PointsPanel::refused, &status, &StatusLine::say);
  docks.add("points", PanelsWords::tr("Points"), points, Group::Side);
  auto* curve = new CurvePanel(models);
  QObject::connect(curve, &CurvePanel::said, &status, &StatusLine::say);
  docks.add("curve", PanelsWords::tr("Curve"), curve, Group::Side);
  docks.add("families", PanelsWords::tr("Lines"), new FamiliesPanel(parts.surface), Group::Side);
  docks.add("surface", PanelsWords::tr("Surface"), new SurfacePanel(parts.surface), Group::Side);
  auto* bridge = new BridgePanel(models, parts.surface.bridges);
  QObject::connect(bridge, &BridgePanel::said, &status, &StatusLine::say);
  docks.add("bridge", PanelsWords::tr("Bridge"), bridge, Group::Side);
  auto* section = new SectionPanel(parts.surface);
  QObject::connect(section, &SectionPanel::said, &status, &StatusLine::say);
  docks.add("section", PanelsWords::tr("Section"), section, Group::Side);
  auto* plots = new PlotsPanel(parts.plots, models.display, parts.settings);
  QObject::connect(plots, &PlotsPanel::said, &status, &StatusLine::say);
  QObject::connect(plots, &PlotsPanel::failed, &parts.messages, &MessageBar::showError);
  docks.add("plots", PanelsWords::tr("Plots"), plots, Group::Plots);
  auto* sweep = new SweepPanel(models);
  QObject::connect(sweep, &SweepPanel::said, &status, &StatusLine::say);
  docks.add("sweep", PanelsWords::tr("Sweep"), sweep, Group::Plots);
  auto* study = new StudyPanel(models);
  QObject::connect(study, &StudyPanel::said, &status, &StatusLine::say);
  docks.add("study", PanelsWords::tr("Study"), study, Group::Plots);
  auto* limits = new LimitsPanel(models);
  QObject::connect(limits, &LimitsPanel::said, &status, &StatusLine::say);
  docks.add("limits", PanelsWords::tr("Limits"), limits, Group::Plots);
  SurfaceStudy& picked = parts.surface.study;
  QObject::connect(&picked, &SurfaceStudy::failed, &parts.messages, &MessageBar::showError);
  auto* derivation = new DerivationPanel(picked);
  QObject::connect(&parts.lesson, &LessonModel::surfaceEquationWanted, derivation,
                   &DerivationPanel::showEquation);
  docks.add("surface-derivation", PanelsWords::tr("Surface derivation"), derivation, Group::Plots);
  docks.add("triangle", PanelsWords::tr("Triangle"), new TrianglePanel(picked, models.display),
            Group::Plots);
  docks.add("marks", PanelsWords::tr("Marks"), new MarksPanel(models), Group::Bottom);
  docks.add("lesson", PanelsWords::tr("Lesson"),
            new LessonPanel(parts.lesson, models.probe, models.display), Group::Bottom);
}

}  // namespace flatland::ui
