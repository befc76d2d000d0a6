// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/menus.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "ui/app/export_key.h"
#include "ui/flat/canvas.h"
#include "ui/view3d/surface_area.h"

namespace flatland::ui {

namespace {

struct MenusWords {
  Q_DECLARE_TR_FUNCTIONS(Menus)
};

QAction* makeAction(QMenu& menu, const ActionText& text) {
  QAction* action = menu.addAction(text.text);
  action->setObjectName(text.id);
  action->setToolTip(text.tip);
  action->setStatusTip(text.tip);
  action->setShortcuts(text.keys);
  return action;
}

QMenu& addMenu(QMainWindow& window, const char* id, const QString& title) {
  QMenu* menu = window.menuBar()->addMenu(title);
  menu->setObjectName(id);
  menu->setToolTipsVisible(true);
  return *menu;
}

}  // namespace

QAction* addAction(QMenu& menu, const ActionText& text, std::function<void()> act) {
  QAction* action = makeAction(menu, text);
  QObject::connect(action, &QAction::triggered, action, [act = std::move(act)] { act(); });
  return action;
}

QAction* addSwitch(QMenu& menu, const ActionText& text, std::function<void(bool)> act) {
  QAction* action = makeAction(menu, text);
  action->setCheckable(true);
  QObject::connect(action, &QAction::toggled, action, std::move(act));
  return action;
}

QMenu& addSubmenu(QMenu& menu, const char* id, const QString& title) {
  QMenu* submenu = menu.addMenu(title);
  submenu->setObjectName(id);
  submenu->setToolTipsVisible(true);
  return *submenu;
}

void buildMenus(const MenuParts& parts) {
  buildFileMenu(addMenu(parts.window, "menu.file", MenusWords::tr("&File")), parts);
  buildEditMenu(addMenu(parts.window, "menu.edit", MenusWords::tr("&Edit")), parts);
  buildCurveMenu(addMenu(parts.window, "menu.curve", MenusWords::tr("&Curve")), parts);
  buildViewMenu(addMenu(parts.window, "menu.view", MenusWords::tr("&View")), parts);
  buildSurfaceMenu(addMenu(parts.window, "menu.surface", MenusWords::tr("&Surface")), parts);
  buildLessonMenu(addMenu(parts.window, "menu.lesson", MenusWords::tr("&Lesson")), parts);
  // Opening a lesson is looked for among what opens files, too: the same action.
  QMenu& file = *parts.window.findChild<QMenu*>("menu.file");
  const QAction* presets = parts.window.findChild<QMenu*>("menu.file.presets")->menuAction();
  const qsizetype after = file.actions().indexOf(presets) + 1;
  file.insertAction(file.actions().value(after), parts.window.findChild<QAction*>("lesson.open"));
  buildHelpMenu(addMenu(parts.window, "menu.help", MenusWords::tr("&Help")), parts);
  const auto action = [&parts](const char* id) { return parts.window.findChild<QAction*>(id); };
  new ExportKey(parts.models.document, parts.canvas, parts.surfaceArea, *action("file.export"),
                *action("surface.export"), &parts.window);
  for (const char* id :
       {"file.export", "surface.export", "view.fit", "view.control-polygon", "view.hidden"}) {
    QAction* shown = action(id);
    parts.pictureBar.addAction(shown);
    QWidget* button = parts.pictureBar.widgetForAction(shown);
    button->setObjectName(QStringLiteral("picture-bar.") + id);
    button->setAccessibleName(shown->toolTip());
    button->setFocusPolicy(Qt::StrongFocus);
  }
}

void buildHelpMenu(QMenu& menu, const MenuParts& parts) {
  addAction(menu,
            {"help.keys",
             MenusWords::tr("&Keys"),
             MenusWords::tr("All keys and mouse gestures on one sheet"),
             {QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question), QKeySequence("Shift+?"),
              QKeySequence(Qt::Key_F1)}},
            parts.showKeys);
  addAction(
      menu,
      {"help.about", MenusWords::tr("&About Flatland"), MenusWords::tr("What this program is")},
      parts.showAbout);
}

}  // namespace flatland::ui
