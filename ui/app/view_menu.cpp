// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenu>

#include "ui/app/menus.h"
#include "ui/view3d/surface_area.h"

namespace flatland::ui {

namespace {

struct ViewMenuWords {
  Q_DECLARE_TR_FUNCTIONS(ViewMenu)
};

constexpr double kZoomStep = 1.25;

/// The next or previous one of canvas and open docks gets the focus.
void movePane(const MenuParts& parts, int step) {
  QList<QWidget*> panes;
  if (parts.canvas.isVisible()) panes << &parts.canvas;
  if (QWidget* surface = parts.surfaceArea.canvas(); surface && surface->isVisible()) {
    panes << surface;
  }
  for (QDockWidget* dock : parts.docks) {
    if (dock->isVisible() && !dock->visibleRegion().isEmpty()) panes << dock->widget();
  }
  qsizetype now = 0;
  const QWidget* focus = QApplication::focusWidget();
  for (qsizetype i = 0; i < panes.size(); ++i) {
    if (focus && (panes[i] == focus || panes[i]->isAncestorOf(focus))) now = i;
  }
  panes[(now + step + panes.size()) % panes.size()]->setFocus(Qt::ShortcutFocusReason);
}

void addZoom(QMenu& menu, const MenuParts& parts) {
  FlatCanvas& canvas = parts.canvas;
  Viewport& viewport = parts.models.viewport;
  addAction(menu,
            {"view.fit",
             ViewMenuWords::tr("&Fit"),
             ViewMenuWords::tr("Show the whole scene"),
             {QKeySequence(Qt::Key_F)}},
            [&canvas] { canvas.fit(); });
  addAction(menu,
            {"view.zoom-in",
             ViewMenuWords::tr("Zoom &In"),
             ViewMenuWords::tr("Show it larger"),
             {QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)}},
            [&viewport] { viewport.zoomAtCentre(kZoomStep); });
  addAction(menu,
            {"view.zoom-out",
             ViewMenuWords::tr("Zoom &Out"),
             ViewMenuWords::tr("Show it smaller"),
             {QKeySequence(Qt::CTRL | Qt::Key_Minus)}},
            [&viewport] { viewport.zoomAtCentre(1.0 / kZoomStep); });
}

void addAngles(QMenu& menu, EditController& edits) {
  const int keys[] = {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4};
  for (int i = 0; i < 4; ++i) {
    const int degrees = 90 * i;
    addAction(menu,
              {"view.from",
               ViewMenuWords::tr("View from %1°").arg(degrees),
               ViewMenuWords::tr("Put the viewer at %1°").arg(degrees),
               {QKeySequence(keys[i])}},
              [&edits, degrees] { edits.setAngle(degrees); })
        ->setObjectName(QStringLiteral("view.from.%1").arg(degrees));
  }
}

void addSwitches(QMenu& menu, const MenuParts& parts) {
  Display& display = parts.models.display;
  EditController& edits = parts.edits;
  Document& document = parts.models.document;
  QAction* perspective = addSwitch(menu,
                                   {"view.perspective",
                                    ViewMenuWords::tr("&Perspective"),
                                    ViewMenuWords::tr("The viewer stands at a distance"),
                                    {QKeySequence(Qt::Key_P)}},
                                   [&edits](bool on) { edits.togglePerspective(on); });
  QAction* polygon = addSwitch(menu,
                               {"view.control-polygon",
                                ViewMenuWords::tr("&Control Polygon"),
                                ViewMenuWords::tr("Show the lines between the control points"),
                                {QKeySequence(Qt::Key_C)}},
                               [&display](bool on) { display.setShowsControlPolygon(on); });
  QAction* hidden = addSwitch(menu,
                              {"view.hidden",
                               ViewMenuWords::tr("&Hidden Parts"),
                               ViewMenuWords::tr("Show what the viewer cannot see, paler"),
                               {QKeySequence(Qt::Key_D)}},
                              [&display](bool on) { display.setShowsHidden(on); });
  const auto showDisplay = [&display, polygon, hidden] {
    polygon->setChecked(display.showsControlPolygon());
    hidden->setChecked(display.showsHidden());
  };
  const auto showView = [&document, perspective] {
    perspective->setChecked(document.scene().view.distance.has_value());
  };
  QObject::connect(&display, &Display::changed, &menu, showDisplay);
  QObject::connect(&document, &Document::changed, &menu, [showView](const Change& change) {
    if (change.what == Change::What::View || change.what == Change::What::Scene) showView();
  });
  showDisplay();
  showView();
}

}  // namespace

void buildViewMenu(QMenu& menu, const MenuParts& parts) {
  addZoom(menu, parts);
  menu.addSeparator();
  addAngles(menu, parts.edits);
  menu.addSeparator();
  addSwitches(menu, parts);
  QMenu* probe = menu.addMenu(ViewMenuWords::tr("Pro&be"));
  probe->setObjectName("menu.view.probe");
  probe->setToolTipsVisible(true);
  buildProbeMenu(*probe, parts);
  menu.addSeparator();
  QMenu& panels = addSubmenu(menu, "menu.view.panels", ViewMenuWords::tr("Pa&nels"));
  for (QDockWidget* dock : parts.docks) {
    QAction* toggle = dock->toggleViewAction();
    toggle->setObjectName("view.dock." + dock->objectName());
    toggle->setStatusTip(ViewMenuWords::tr("Show or close this panel"));
    toggle->setToolTip(toggle->statusTip());
    // What is opened is wanted, not hidden behind another.
    QObject::connect(toggle, &QAction::triggered, dock, [dock](bool on) {
      if (on) dock->raise();
    });
    panels.addAction(toggle);
  }
  addLayoutMenus(menu, parts);
  menu.addSeparator();
  addAction(menu,
            {"view.next-pane",
             ViewMenuWords::tr("Ne&xt Pane"),
             ViewMenuWords::tr("Move the focus on: canvas, panels"),
             {QKeySequence(Qt::Key_F6)}},
            [parts] { movePane(parts, 1); });
  addAction(menu,
            {"view.previous-pane",
             ViewMenuWords::tr("Pre&vious Pane"),
             ViewMenuWords::tr("Move the focus back"),
             {QKeySequence(Qt::SHIFT | Qt::Key_F6)}},
            [parts] { movePane(parts, -1); });
}

}  // namespace flatland::ui
