// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCoreApplication>
#include <QMenu>

#include "ui/app/menus.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/compare_presets.h"

namespace flatland::ui {

namespace {

struct CompareMenuWords {
  Q_DECLARE_TR_FUNCTIONS(CompareMenu)
};

}  // namespace

void buildCompareMenu(QMenu& menu, const MenuParts& parts) {
  Document& document = parts.models.document;
  auto comparison = std::make_shared<Comparison>();
  QObject::connect(&document, &Document::changed, &menu, [comparison](const Change& change) {
    if (change.what == Change::What::Scene) *comparison = {};
  });
  const auto add = [&](const char* id, const QString& text, const QString& tip,
                       ComparePreset preset) {
    addAction(menu, {id, text, tip}, [&document, comparison, preset] {
      const auto& setting = document.scene().surface;
      if (!setting) return;
      document.push(std::make_unique<SetSurface>(document, comparison->compared(*setting, preset),
                                                 CompareMenuWords::tr("compare views")));
    });
  };
  const QString side = CompareMenuWords::tr("Views of the surface side by side");
  add("surface.compare.one", CompareMenuWords::tr("&One View"),
      CompareMenuWords::tr("Only the first view, with the lines it had before comparing"),
      ComparePreset::OneView);
  add("surface.compare.two", CompareMenuWords::tr("&Two Views"), side, ComparePreset::TwoViews);
  add("surface.compare.four", CompareMenuWords::tr("&Four Views"), side, ComparePreset::FourViews);
  menu.addSeparator();
  add("surface.compare.families",
      CompareMenuWords::tr("&Contours, Suggestive, Ridges, Apparent Ridges"),
      CompareMenuWords::tr("Four views: contours alone, and with each of the other families"),
      ComparePreset::Families);
  add("surface.compare.derivatives", CompareMenuWords::tr("Closed Form and &Neighbours"),
      CompareMenuWords::tr("Apparent ridges by the closed form, and by differences between "
                           "neighbours as in the thesis"),
      ComparePreset::Derivatives);
  add("surface.compare.difference", CompareMenuWords::tr("&Difference of the Two"),
      CompareMenuWords::tr("Where the two derivatives give different apparent ridges"),
      ComparePreset::Difference);
  add("surface.compare.camera", CompareMenuWords::tr("&Second Camera"),
      CompareMenuWords::tr("The lines of the first view seen from elsewhere"),
      ComparePreset::SecondCamera);
}

}  // namespace flatland::ui
