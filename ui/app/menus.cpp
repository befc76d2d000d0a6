// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/menus.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace flatland::ui {

namespace {

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

void buildMenus(const MenuParts& parts) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Menus", text); };
  buildFileMenu(addMenu(parts.window, "menu.file", tr("&File")), parts);
  buildEditMenu(addMenu(parts.window, "menu.edit", tr("&Edit")), parts);
  buildCurveMenu(addMenu(parts.window, "menu.curve", tr("&Curve")), parts);
  buildViewMenu(addMenu(parts.window, "menu.view", tr("&View")), parts);
  buildHelpMenu(addMenu(parts.window, "menu.help", tr("&Help")), parts);
}

void buildHelpMenu(QMenu& menu, const MenuParts& parts) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Menus", text); };
  addAction(menu,
            {"help.keys",
             tr("&Keys"),
             tr("All keys and mouse gestures on one sheet"),
             {QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question), QKeySequence("Shift+?"),
              QKeySequence(Qt::Key_F1)}},
            parts.showKeys);
  addAction(menu, {"help.about", tr("&About Flatland"), tr("What this program is")},
            parts.showAbout);
}

}  // namespace flatland::ui
