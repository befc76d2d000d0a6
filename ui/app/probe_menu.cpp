// SPDX-License-Identifier: GPL-3.0-or-later
// The submenu Probe of the View menu.
#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <vector>

#include "ui/app/menus.h"
#include "ui/model/plots.h"

namespace flatland::ui {

namespace {

struct ProbeMenuWords {
  Q_DECLARE_TR_FUNCTIONS(ProbeMenu)
};

constexpr double kStep = 0.002;  // of the arc length; with Shift ten times
constexpr double kCombStep = 1.25;

void addMoves(QMenu& menu, const MenuParts& parts) {
  Plots& plots = parts.plots;
  FlatCanvas& canvas = parts.canvas;
  Probe& probe = parts.models.probe;
  addAction(menu,
            {"probe.place",
             ProbeMenuWords::tr("&Place at Pointer"),
             ProbeMenuWords::tr("Put the probe on the curve where the pointer is; a click there "
                                "does so too"),
             {QKeySequence(Qt::Key_K)}},
            [&canvas] { canvas.placeProbe(); });
  addAction(menu,
            {"probe.remove", ProbeMenuWords::tr("&Remove"),
             ProbeMenuWords::tr("Take the probe away (Esc with nothing selected)")},
            [&probe] { probe.setPlace(std::nullopt); });
  menu.addSeparator();
  addAction(menu,
            {"probe.next-mark",
             ProbeMenuWords::tr("&Next Mark"),
             ProbeMenuWords::tr("Move the probe to the next mark, exactly"),
             {QKeySequence(Qt::Key_M)}},
            [&plots] { plots.stepToMark(1); });
  addAction(menu,
            {"probe.previous-mark",
             ProbeMenuWords::tr("Previo&us Mark"),
             ProbeMenuWords::tr("Move the probe to the mark before, exactly"),
             {QKeySequence(Qt::SHIFT | Qt::Key_M)}},
            [&plots] { plots.stepToMark(-1); });
  // Shift makes other characters of comma and period, by keyboard.
  const auto with = [](std::initializer_list<QKeyCombination> keys) {
    QList<QKeySequence> list;
    for (const QKeyCombination& key : keys) list << QKeySequence(key);
    return list;
  };
  addAction(menu,
            {"probe.forward", ProbeMenuWords::tr("&Forward"),
             ProbeMenuWords::tr("Move the probe along the curve"), with({Qt::Key_Period})},
            [&plots] { plots.moveProbe(kStep); });
  addAction(menu,
            {"probe.back", ProbeMenuWords::tr("&Back"),
             ProbeMenuWords::tr("Move the probe back along the curve"), with({Qt::Key_Comma})},
            [&plots] { plots.moveProbe(-kStep); });
  addAction(menu,
            {"probe.forward-far", ProbeMenuWords::tr("Forward, Ten Times"),
             ProbeMenuWords::tr("Move the probe ten times as far"),
             with({Qt::SHIFT | Qt::Key_Period, Qt::Key_Greater, Qt::SHIFT | Qt::Key_Greater,
                   Qt::SHIFT | Qt::Key_Colon})},
            [&plots] { plots.moveProbe(10.0 * kStep); });
  addAction(menu,
            {"probe.back-far", ProbeMenuWords::tr("Back, Ten Times"),
             ProbeMenuWords::tr("Move the probe back ten times as far"),
             with({Qt::SHIFT | Qt::Key_Comma, Qt::Key_Less, Qt::SHIFT | Qt::Key_Less,
                   Qt::SHIFT | Qt::Key_Semicolon})},
            [&plots] { plots.moveProbe(-10.0 * kStep); });
}

void addOverlays(QMenu& menu, Display& display) {
  struct Entry {
    Overlay overlay;
    const char* id;
    QString text, tip;
  };
  const std::vector<Entry> entries{
      {Overlay::Vectors, "probe.vectors", ProbeMenuWords::tr("&Vectors n, t, k"),
       ProbeMenuWords::tr("Normal, tangent and dn/du = k t at the probe")},
      {Overlay::Circle, "probe.circle", ProbeMenuWords::tr("&Osculating Circle"),
       ProbeMenuWords::tr("The circle that touches the curve to second order at the probe")},
      {Overlay::Comb, "probe.comb", ProbeMenuWords::tr("&Curvature Comb"),
       ProbeMenuWords::tr("Teeth as long as the curvature is large, along the curve of the probe")},
      {Overlay::ScreenTurn, "probe.screen-turn", ProbeMenuWords::tr("&dn/di on the Screen"),
       ProbeMenuWords::tr("How fast the normal turns for a step on the screen")}};
  std::vector<std::pair<Overlay, QAction*>> actions;
  for (const Entry& entry : entries) {
    QAction* action =
        addSwitch(menu, {entry.id, entry.text, entry.tip},
                  [&display, overlay = entry.overlay](bool on) { display.setShows(overlay, on); });
    actions.emplace_back(entry.overlay, action);
  }
  const auto show = [&display, actions] {
    for (const auto& [overlay, action] : actions) action->setChecked(display.shows(overlay));
  };
  QObject::connect(&display, &Display::changed, &menu, show);
  show();
  addAction(menu,
            {"probe.comb-longer",
             ProbeMenuWords::tr("&Longer Comb"),
             ProbeMenuWords::tr("Lengthen the teeth of the comb"),
             {QKeySequence(Qt::Key_BracketRight)}},
            [&display] { display.setCombScale(display.combScale() * kCombStep); });
  addAction(menu,
            {"probe.comb-shorter",
             ProbeMenuWords::tr("&Shorter Comb"),
             ProbeMenuWords::tr("Shorten the teeth of the comb"),
             {QKeySequence(Qt::Key_BracketLeft)}},
            [&display] { display.setCombScale(display.combScale() / kCombStep); });
}

}  // namespace

void buildProbeMenu(QMenu& menu, const MenuParts& parts) {
  addMoves(menu, parts);
  menu.addSeparator();
  addOverlays(menu, parts.models.display);
}

}  // namespace flatland::ui
