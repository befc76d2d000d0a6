// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the View menu that is about the window itself: layout, theme, size, language.
#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

#include "ui/app/language.h"
#include "ui/app/layouts.h"
#include "ui/app/menus.h"

namespace flatland::ui {

namespace {

struct LayoutMenuWords {
  Q_DECLARE_TR_FUNCTIONS(LayoutMenu)
};

constexpr double kScaleStep = 0.1;

/// Adds one of several actions of which one is on.
QAction* addChoice(QMenu& menu, QActionGroup& group, const ActionText& text,
                   std::function<void()> act) {
  QAction* action = addAction(menu, text, std::move(act));
  action->setCheckable(true);
  group.addAction(action);
  return action;
}

void addLayouts(QMenu& menu, const MenuParts& parts) {
  using Kind = Layouts::Kind;
  Layouts& layouts = parts.layouts;
  auto* group = new QActionGroup(&menu);
  QAction* work = addChoice(menu, *group,
                            {"view.layout.work",
                             LayoutMenuWords::tr("&Work"),
                             LayoutMenuWords::tr("Canvas and all panels"),
                             {QKeySequence(Qt::CTRL | Qt::Key_1)}},
                            [&layouts] { layouts.use(Kind::Work); });
  QAction* surface = addChoice(menu, *group,
                               {"view.layout.surface",
                                LayoutMenuWords::tr("&Surface"),
                                LayoutMenuWords::tr("The surface large, the canvas beside it"),
                                {QKeySequence(Qt::CTRL | Qt::Key_3)}},
                               [&layouts] { layouts.use(Kind::Surface); });
  QAction* picture = addChoice(menu, *group,
                               {"view.layout.picture",
                                LayoutMenuWords::tr("&Picture-Making"),
                                LayoutMenuWords::tr("The canvas alone, with what an export needs"),
                                {QKeySequence(Qt::CTRL | Qt::Key_2)}},
                               [&layouts] { layouts.use(Kind::Picture); });
  QAction* projector =
      addChoice(menu, *group,
                {"view.layout.projector",
                 LayoutMenuWords::tr("P&rojector"),
                 LayoutMenuWords::tr("Full screen, large type, few panels; Esc leaves it"),
                 {QKeySequence(Qt::Key_F11)}},
                [&layouts] { layouts.toggleProjector(); });
  menu.addSeparator();
  addAction(menu,
            {"view.restore-layout", LayoutMenuWords::tr("R&estore Panels"),
             LayoutMenuWords::tr("The panels of this layout back to their places")},
            [&layouts] { layouts.restoreDefault(); });
  const auto show = [&layouts, work, surface, picture, projector] {
    work->setChecked(layouts.current() == Kind::Work);
    surface->setChecked(layouts.current() == Kind::Surface);
    picture->setChecked(layouts.current() == Kind::Picture);
    projector->setChecked(layouts.current() == Kind::Projector);
  };
  QObject::connect(&layouts, &Layouts::changed, &menu, show);
  show();
}

void addSizes(QMenu& menu, Display& display) {
  addAction(menu,
            {"view.scale.larger",
             LayoutMenuWords::tr("&Larger"),
             LayoutMenuWords::tr("Larger type, marks and lines"),
             {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_Plus),
              QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_Equal)}},
            [&display] { display.setUiScale(display.uiScale() + kScaleStep); });
  addAction(menu,
            {"view.scale.smaller",
             LayoutMenuWords::tr("&Smaller"),
             LayoutMenuWords::tr("Smaller type, marks and lines"),
             {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_Minus)}},
            [&display] { display.setUiScale(display.uiScale() - kScaleStep); });
  addAction(
      menu,
      {"view.scale.usual",
       LayoutMenuWords::tr("&Usual Size"),
       LayoutMenuWords::tr("Type, marks and lines as on the first day"),
       {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_0)}},
      [&display] { display.setUiScale(display.isProjector() ? Display::kProjectorScale : 1.0); });
}

void addThemes(QMenu& menu, Display& display) {
  using Theme = Display::Theme;
  auto* group = new QActionGroup(&menu);
  const auto add = [&menu, &display, group](const ActionText& text, Theme theme) {
    QAction* action = addChoice(menu, *group, text, [&display, theme] { display.setTheme(theme); });
    const auto show = [action, &display, theme] { action->setChecked(display.theme() == theme); };
    QObject::connect(&display, &Display::changed, action, show);
    show();
  };
  add({"view.theme.system", LayoutMenuWords::tr("&System"),
       LayoutMenuWords::tr("The colours of the desktop")},
      Theme::System);
  add({"view.theme.light", LayoutMenuWords::tr("&Light"), LayoutMenuWords::tr("Dark on light")},
      Theme::Light);
  add({"view.theme.dark", LayoutMenuWords::tr("&Dark"), LayoutMenuWords::tr("Light on dark")},
      Theme::Dark);
  add({"view.theme.high-contrast", LayoutMenuWords::tr("&High Contrast"),
       LayoutMenuWords::tr("White on black, yellow for what is picked")},
      Theme::HighContrast);
}

void addLanguages(QMenu& menu, const MenuParts& parts) {
  auto* group = new QActionGroup(&menu);
  const auto add = [&](const QString& code, const QString& name, const QString& tip) {
    QAction* action = addChoice(menu, *group, {"view.language", name, tip},
                                [set = parts.setLanguage, code] { set(code); });
    action->setObjectName("view.language." + code);
    action->setChecked(parts.language == code);
  };
  const QString tip = LayoutMenuWords::tr("The language of the window, from its next start on");
  add("system", LayoutMenuWords::tr("&System"), tip);
  for (const Language& language : languages()) {
    add(language.code, "&" + QString::fromUtf8(language.name), tip);
  }
}

}  // namespace

void addLayoutMenus(QMenu& viewMenu, const MenuParts& parts) {
  Display& display = parts.models.display;
  addLayouts(addSubmenu(viewMenu, "menu.view.layout", LayoutMenuWords::tr("&Layout")), parts);
  Layouts& layouts = parts.layouts;
  QAction* flat = addSwitch(viewMenu,
                            {"view.flat-beside", LayoutMenuWords::tr("Cu&rves beside the Surface"),
                             LayoutMenuWords::tr("Show the curves beside a surface; off: the "
                                                 "surface has all the room")},
                            [&layouts](bool on) { layouts.setFlatBeside(on); });
  const auto showFlat = [&layouts, flat] { flat->setChecked(layouts.showsFlatBeside()); };
  QObject::connect(&layouts, &Layouts::changed, flat, showFlat);
  showFlat();
  addSizes(addSubmenu(viewMenu, "menu.view.scale", LayoutMenuWords::tr("&Size")), display);
  addThemes(addSubmenu(viewMenu, "menu.view.theme", LayoutMenuWords::tr("&Theme")), display);
  addLanguages(addSubmenu(viewMenu, "menu.view.language", LayoutMenuWords::tr("Lan&guage")), parts);
  QAction* wheel = addSwitch(viewMenu,
                             {"view.wheel-zooms", LayoutMenuWords::tr("&Wheel Zooms"),
                              LayoutMenuWords::tr("A mouse wheel zooms; off: it moves the picture, "
                                                  "and Ctrl + wheel zooms")},
                             [&display](bool on) { display.setWheelZooms(on); });
  const auto show = [&display, wheel] { wheel->setChecked(display.wheelZooms()); };
  QObject::connect(&display, &Display::changed, wheel, show);
  show();
}

}  // namespace flatland::ui
