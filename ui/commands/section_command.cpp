// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/section_command.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/commands/scene_commands.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

namespace {

struct SectionCommandWords {
  Q_DECLARE_TR_FUNCTIONS(SectionCommand)
};

/// ReplaceScene beside a surface that stays, if it does, and is seen as it is now: looking is no
/// edit.
class OpenSection : public ReplaceScene {
 public:
  OpenSection(Document& document, Scene scene, const QString& text)
      : ReplaceScene(document, std::move(scene), text), document_(document) {}

  void undo() override {
    keepingCameras([this] { ReplaceScene::undo(); });
  }
  void redo() override {
    keepingCameras([this] { ReplaceScene::redo(); });
  }

 private:
  template <class Swap>
  void keepingCameras(Swap swap) {
    const std::optional<SurfaceSetting> before = document_.scene().surface;
    swap();
    if (!before || !document_.scene().surface) return;
    document_.setCamera(before->camera);
    const auto& panes = document_.scene().surface->panes;
    for (std::size_t i = 0; i < std::min(panes.size(), before->panes.size()); ++i) {
      if (panes[i].camera && before->panes[i].camera) {
        document_.setCamera(*before->panes[i].camera, i + 1);
      }
    }
  }

  Document& document_;
};

}  // namespace

QString whyNotOpened(const SectionView* section) {
  if (!section) return SectionCommandWords::tr("There is no plane that cuts the surface yet.");
  if (section->section.scene.curves.empty()) {
    return SectionCommandWords::tr("The plane does not cut the surface.");
  }
  return {};
}

void openSection(Document& document, const SectionView& section) {
  Scene scene = document.scene();
  scene.curves = section.section.scene.curves;
  scene.view = section.section.scene.view;
  if (isSwept(scene)) scene.surface.reset();
  document.push(std::make_unique<OpenSection>(document, std::move(scene),
                                              SectionCommandWords::tr("open section")));
}

}  // namespace flatland::ui
