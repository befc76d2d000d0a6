// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCoreApplication>
#include <QMenu>

#include "ui/app/bridge_controller.h"
#include "ui/app/menus.h"

namespace flatland::ui {

namespace {

struct BridgeMenuWords {
  Q_DECLARE_TR_FUNCTIONS(BridgeMenu)
};

}  // namespace

void addBridgeActions(QMenu& menu, const MenuParts& parts) {
  BridgeController& bridges = parts.bridges;
  Document& document = parts.models.document;
  QAction* extrude = addAction(
      menu,
      {"surface.extrude", BridgeMenuWords::tr("E&xtrude Curve"),
       BridgeMenuWords::tr("Make the selected curve a surface that follows it: moved across its "
                           "plane")},
      [&bridges] { bridges.sweep(SweptSurface::Kind::Extrusion); });
  QAction* revolve = addAction(
      menu,
      {"surface.revolve", BridgeMenuWords::tr("Re&volve Curve"),
       BridgeMenuWords::tr("Make the selected curve a surface that follows it: turned about an "
                           "axis beside it")},
      [&bridges] { bridges.sweep(SweptSurface::Kind::Revolution); });
  QMenu& plane = addSubmenu(menu, "menu.surface.plane", BridgeMenuWords::tr("Cuttin&g Plane"));
  addAction(
      plane,
      {"surface.plane.view", BridgeMenuWords::tr("Through the &View Direction"),
       BridgeMenuWords::tr("A plane that holds the line of sight, through the picked point or "
                           "the middle of the picture")},
      [&bridges] { bridges.cutAlongView(); });
  addAction(plane,
            {"surface.plane.ridge", BridgeMenuWords::tr("Along &t_A at the Picked Point"),
             BridgeMenuWords::tr("A plane that holds the line of sight and t_A: there flatland's "
                                 "equation is the surface's")},
            [&bridges] { bridges.cutAlongRidge(); });
  addAction(plane,
            {"surface.plane.open", BridgeMenuWords::tr("&Open Section as Curve"),
             BridgeMenuWords::tr("Put the section in the place of the scene's curves")},
            [&bridges] { bridges.openSection(); });
  const auto show = [=, &document, &plane] {
    for (QAction* action : {extrude, revolve}) {
      action->setEnabled(!document.scene().curves.empty());
    }
    plane.setEnabled(document.scene().surface.has_value());
  };
  QObject::connect(&document, &Document::changed, &menu, [show](const Change& change) {
    if (change.touchesScene() || change.touchesSurface()) show();
  });
  show();
}

}  // namespace flatland::ui
