// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <algorithm>

#include "core3d/io/named_mesh.h"
#include "ui/app/layouts.h"
#include "ui/app/menus.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/core_words.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"
#include "ui/view3d/surface_area.h"

namespace flatland::ui {

namespace {

struct SurfaceMenuWords {
  Q_DECLARE_TR_FUNCTIONS(SurfaceMenu)
};

void addViews(QMenu& menu, Document& document) {
  const auto look = [&document](StandardView view) {
    return [&document, view] {
      const auto& setting = document.scene().surface;
      if (setting) document.setCamera(seenFrom(setting->camera, view, upAxisOf(*setting)));
    };
  };
  // The keys 1, 3, 7, 5 and R are the view's own: elsewhere they mean something else.
  const struct {
    const char* id;
    QString text;
    StandardView view;
  } views[] = {{"surface.view.front", SurfaceMenuWords::tr("&Front\t1"), StandardView::Front},
               {"surface.view.back", SurfaceMenuWords::tr("&Back"), StandardView::Back},
               {"surface.view.right", SurfaceMenuWords::tr("&Right\t3"), StandardView::Right},
               {"surface.view.left", SurfaceMenuWords::tr("&Left"), StandardView::Left},
               {"surface.view.top", SurfaceMenuWords::tr("&Top\t7"), StandardView::Top},
               {"surface.view.bottom", SurfaceMenuWords::tr("B&ottom"), StandardView::Bottom}};
  for (const auto& one : views) {
    addAction(menu, {one.id, one.text, SurfaceMenuWords::tr("Look at the surface from there")},
              look(one.view));
  }
  menu.addSeparator();
  addAction(menu,
            {"surface.view.perspective", SurfaceMenuWords::tr("&Perspective\t5"),
             SurfaceMenuWords::tr("The viewer of the surface stands at a distance, or far away")},
            [&document] {
              const auto& setting = document.scene().surface;
              if (setting) document.setCamera(withPerspectiveToggled(setting->camera));
            });
  addAction(menu,
            {"surface.view.reset", SurfaceMenuWords::tr("R&eset Camera\tR"),
             SurfaceMenuWords::tr("Look at the surface as when it was opened")},
            [&document] {
              const auto& setting = document.scene().surface;
              if (setting) document.setCamera(homeCamera(upAxisOf(*setting)));
            });
}

/// Which axis of the file points upward: scans are often made lying on their back.
void addUpAxes(QMenu& menu, Document& document) {
  auto* axes = new QActionGroup(&menu);
  for (const char* axis : kUpAxes) {
    QString name = QString(axis).toUpper();
    name.replace('-', QChar(0x2212));
    QAction* action = addAction(
        menu, {"surface.up", name, SurfaceMenuWords::tr("This axis of the file points upward")},
        [&document, axis] {
          std::optional<SurfaceSetting> setting = document.scene().surface;
          if (!setting) return;
          setting->upAxis = axis;
          setting = withCamera(*setting, homeCamera(upAxisOf(*setting)));
          document.push(std::make_unique<SetSurface>(document, std::move(setting),
                                                     SurfaceMenuWords::tr("change up axis")));
        });
    action->setObjectName(QStringLiteral("surface.up.") + axis);
    action->setCheckable(true);
    axes->addAction(action);
  }
  QObject::connect(&menu, &QMenu::aboutToShow, axes, [axes, &document] {
    const auto& setting = document.scene().surface;
    const std::string now = setting ? setting->upAxis : SurfaceSetting{}.upAxis;
    for (QAction* action : axes->actions()) {
      action->setChecked(action->objectName() == QString::fromStdString("surface.up." + now));
    }
  });
}

}  // namespace

void buildSurfaceMenu(QMenu& menu, const MenuParts& parts) {
  SurfaceController& surfaces = parts.surfaces;
  SurfaceArea& area = parts.surfaceArea;
  Document& document = parts.models.document;
  addAction(menu,
            {"surface.open",
             SurfaceMenuWords::tr("&Open Mesh…"),
             SurfaceMenuWords::tr("Put a mesh beside the curves: PLY, OBJ, STL, OFF, glTF"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)}},
            [&surfaces] { surfaces.open(); });
  QMenu& solids = addSubmenu(menu, "menu.surface.solids", SurfaceMenuWords::tr("&Solids"));
  for (const std::string& name : solidNames()) {
    const QString id = QString::fromStdString(name);
    std::string words = name;
    std::replace(words.begin(), words.end(), '-', ' ');
    addAction(solids,
              {"surface.solid", coreWords(words),
               SurfaceMenuWords::tr("Put a surface given by a formula beside the curves")},
              [&surfaces, id] { surfaces.openSolid(id); })
        ->setObjectName("surface.solid." + id);
  }
  QAction* next = addAction(menu,
                            {"surface.next",
                             SurfaceMenuWords::tr("&Next Mesh in the Folder"),
                             SurfaceMenuWords::tr("Open the next mesh of this folder, by name"),
                             {QKeySequence(Qt::CTRL | Qt::Key_PageDown)}},
                            [&surfaces] { surfaces.openNeighbour(1); });
  QAction* previous =
      addAction(menu,
                {"surface.previous",
                 SurfaceMenuWords::tr("&Previous Mesh in the Folder"),
                 SurfaceMenuWords::tr("Open the mesh before this one in its folder"),
                 {QKeySequence(Qt::CTRL | Qt::Key_PageUp)}},
                [&surfaces] { surfaces.openNeighbour(-1); });
  QAction* close = addAction(menu,
                             {"surface.close", SurfaceMenuWords::tr("&Close Surface"),
                              SurfaceMenuWords::tr("Take the surface out of the scene")},
                             [&surfaces] { surfaces.close(); });
  menu.addSeparator();
  addBridgeActions(menu, parts);
  menu.addSeparator();
  QMenu& views = addSubmenu(menu, "menu.surface.views", SurfaceMenuWords::tr("&Look from"));
  addViews(views, document);
  QMenu& up = addSubmenu(menu, "menu.surface.up", SurfaceMenuWords::tr("&Up Axis"));
  addUpAxes(up, document);
  QMenu& compare = addSubmenu(menu, "menu.surface.compare", SurfaceMenuWords::tr("Co&mpare"));
  buildCompareMenu(compare, parts);
  QAction* spin = addSwitch(menu,
                            {"surface.spin", SurfaceMenuWords::tr("Sp&in\tSpace"),
                             SurfaceMenuWords::tr("Turn the surface on and on")},
                            [&area](bool on) { area.setSpinning(on); });
  QObject::connect(&area, &SurfaceArea::spinningChanged, spin, &QAction::setChecked);
  menu.addSeparator();
  QAction* picture = addAction(menu,
                               {"surface.export", SurfaceMenuWords::tr("&Export Surface…"),
                                SurfaceMenuWords::tr("Write the picture of the surface")},
                               [&surfaces, &area] { surfaces.exportPicture(area.viewsSize()); });
  const auto show = [=, &surfaces, &document, &views, &up, &compare] {
    const bool there = document.scene().surface.has_value();
    next->setEnabled(surfaces.hasNeighbours());
    previous->setEnabled(surfaces.hasNeighbours());
    for (QAction* action : {close, spin, picture}) action->setEnabled(there);
    views.setEnabled(there);
    up.setEnabled(there);
    compare.setEnabled(there);
  };
  QObject::connect(&document, &Document::changed, &menu, [show](const Change& change) {
    if (change.touchesSurface()) show();
  });
  show();
}

}  // namespace flatland::ui
