// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/section_command.h"

#include <QCoreApplication>

#include "ui/commands/scene_commands.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

namespace {

struct SectionCommandWords {
  Q_DECLARE_TR_FUNCTIONS(SectionCommand)
};

}  // namespace

QString whyNotOpened(const Document& document, const SectionView* section) {
  if (!section) return SectionCommandWords::tr("There is no plane that cuts the surface yet.");
  if (section->section.scene.curves.empty()) {
    return SectionCommandWords::tr("The plane does not cut the surface.");
  }
  if (isSwept(document.scene())) {
    return SectionCommandWords::tr(
        "This surface is swept from the scene's curve, which the section would replace.");
  }
  return {};
}

void openSection(Document& document, const SectionView& section) {
  Scene scene = document.scene();
  scene.curves = section.section.scene.curves;
  scene.view = section.section.scene.view;
  document.push(std::make_unique<ReplaceScene>(document, std::move(scene),
                                               SectionCommandWords::tr("open section")));
}

}  // namespace flatland::ui
