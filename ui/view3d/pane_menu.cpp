// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pane_menu.h"

#include <QCoreApplication>
#include <QMenu>
#include <QStringList>

#include "ui/commands/scene_commands.h"
#include "ui/export/line_style.h"
#include "ui/model/core_words.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

namespace {

struct PaneWords {
  Q_DECLARE_TR_FUNCTIONS(PaneWords)
};

void change(const SurfaceModels& models, const QString& text,
            const std::function<void(SurfaceSetting&)>& edit) {
  std::optional<SurfaceSetting> setting = models.document.scene().surface;
  if (!setting) return;
  edit(*setting);
  models.document.push(std::make_unique<SetSurface>(models.document, std::move(setting), text));
}

QAction* addSwitch(QMenu& menu, const char* id, const QString& text, bool on,
                   std::function<void()> act) {
  QAction* action = menu.addAction(text);
  action->setObjectName(id);
  action->setCheckable(true);
  action->setChecked(on);
  QObject::connect(action, &QAction::triggered, &menu, std::move(act));
  return action;
}

QString titleOf(LineFamily family) { return coreWords(std::string(lineTitle(family))); }

void addOwnChoices(QMenu& menu, const SurfaceModels& models, const PaneSetting& now) {
  const std::size_t index = models.pane - 1;
  addSwitch(menu, "pane.families.first", PaneWords::tr("Families of the First View"),
            !models.document.scene().surface->panes[index].families, [models, index] {
              change(models, PaneWords::tr("change view"),
                     [index](SurfaceSetting& setting) { setting.panes[index].families.reset(); });
            });
  const bool oneRing = now.derivative == RidgeDerivative::OneRing;
  addSwitch(menu, "pane.one-ring", PaneWords::tr("Derivative from Neighbours, as in the Thesis"),
            oneRing, [models, index, oneRing] {
              change(models, PaneWords::tr("change view"), [index, oneRing](SurfaceSetting& s) {
                s.panes[index].derivative = oneRing ? kClosedForm : kOneRing;
              });
            });
  addSwitch(menu, "pane.difference", PaneWords::tr("Difference from the First View"),
            now.difference, [models, index, difference = now.difference] {
              change(models, PaneWords::tr("change view"), [index, difference](SurfaceSetting& s) {
                s.panes[index].shows = difference ? kShowsLines : kShowsDifference;
              });
            });
  addSwitch(menu, "pane.camera", PaneWords::tr("Camera of Its Own"), now.ownCamera,
            [models, index, own = now.ownCamera] {
              change(models, PaneWords::tr("change view"), [index, own](SurfaceSetting& setting) {
                if (own) {
                  setting.panes[index].camera.reset();
                } else {
                  setting.panes[index].camera = setting.camera;
                }
              });
            });
}

}  // namespace

QString paneWords(const SurfaceModels& models) {
  const PaneSetting pane = models.setting();
  QStringList families;
  for (const LineFamily family : allLineFamilies()) {
    if (familyOf(pane.surface, family).on) families << titleOf(family);
  }
  QString words =
      families.isEmpty() ? PaneWords::tr("No lines") : families.join(QStringLiteral(", "));
  if (pane.derivative == RidgeDerivative::OneRing) {
    words = PaneWords::tr("By neighbours: %1").arg(words);
  }
  if (pane.difference) words = PaneWords::tr("Difference: %1").arg(words);
  if (pane.ownCamera) words = PaneWords::tr("Second camera: %1").arg(words);
  return words;
}

void fillPaneMenu(QMenu& menu, const SurfaceModels& models) {
  menu.clear();
  if (!models.there()) return;
  const PaneSetting now = models.setting();
  for (const LineFamily family : allLineFamilies()) {
    const bool on = familyOf(now.surface, family).on;
    QAction* action = addSwitch(menu, "", titleOf(family), on, [models, family, on] {
      change(models, PaneWords::tr("change lines"), [&](SurfaceSetting& setting) {
        setting = withFamilyOn(setting, models.pane, family, !on);
      });
    });
    const std::string_view name = nameOf(family);
    action->setObjectName(QStringLiteral("pane.family.") +
                          QLatin1String(name.data(), static_cast<qsizetype>(name.size())));
  }
  if (models.pane == 0) return;
  menu.addSeparator();
  addOwnChoices(menu, models, now);
}

}  // namespace flatland::ui
