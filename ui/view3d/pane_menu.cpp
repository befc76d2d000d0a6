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

struct SwitchText {
  QString id, text, tip;
};

void addSwitch(QMenu& menu, const SwitchText& text, bool on, std::function<void()> act) {
  QAction* action = menu.addAction(text.text);
  action->setObjectName(text.id);
  action->setToolTip(text.tip);
  action->setStatusTip(text.tip);
  action->setCheckable(true);
  action->setChecked(on);
  QObject::connect(action, &QAction::triggered, &menu, std::move(act));
}

QString titleOf(LineFamily family) { return coreWords(std::string(lineTitle(family))); }

void addOwnChoices(QMenu& menu, const SurfaceModels& models, const PaneSetting& now) {
  const std::size_t index = models.pane - 1;
  addSwitch(menu,
            {"pane.families.first", PaneWords::tr("Families of the First View"),
             PaneWords::tr("Draw the lines that the first view draws")},
            !models.document.scene().surface->panes[index].families, [models, index] {
              change(models, PaneWords::tr("change view"),
                     [index](SurfaceSetting& setting) { setting.panes[index].families.reset(); });
            });
  const bool oneRing = now.derivative == RidgeDerivative::OneRing;
  addSwitch(menu,
            {"pane.one-ring", PaneWords::tr("Derivative from Neighbours, as in the Thesis"),
             PaneWords::tr("Apparent ridges by differences between neighbours; off: by the closed "
                           "form")},
            oneRing, [models, index, oneRing] {
              change(models, PaneWords::tr("change view"), [index, oneRing](SurfaceSetting& s) {
                s.panes[index].derivative = oneRing ? kClosedForm : kOneRing;
              });
            });
  addSwitch(menu,
            {"pane.difference", PaneWords::tr("Difference from the First View"),
             PaneWords::tr("Lines of both views, coloured by which of them has them")},
            now.difference, [models, index, difference = now.difference] {
              change(models, PaneWords::tr("change view"), [index, difference](SurfaceSetting& s) {
                s.panes[index].shows = difference ? kShowsLines : kShowsDifference;
              });
            });
  addSwitch(menu,
            {"pane.camera", PaneWords::tr("Camera of Its Own"),
             PaneWords::tr("See the lines of the first view from elsewhere")},
            now.ownCamera, [models, index, own = now.ownCamera] {
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
  menu.setToolTipsVisible(true);
  if (!models.there()) return;
  const PaneSetting now = models.setting();
  for (const LineFamily family : allLineFamilies()) {
    const bool on = familyOf(now.surface, family).on;
    const std::string_view name = nameOf(family);
    const QString id = QLatin1String(name.data(), static_cast<qsizetype>(name.size()));
    const SwitchText text{"pane.family." + id, titleOf(family),
                          PaneWords::tr("Draw these lines in this view")};
    addSwitch(menu, text, on, [models, family, on] {
      change(models, PaneWords::tr("change lines"), [&](SurfaceSetting& setting) {
        setting = withFamilyOn(setting, models.pane, family, !on);
      });
    });
  }
  if (models.pane == 0) return;
  menu.addSeparator();
  addOwnChoices(menu, models, now);
}

}  // namespace flatland::ui
