// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commands/section_command.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <algorithm>

#include "ui/model/cutting_plane.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

namespace {

struct SectionCommandWords {
  Q_DECLARE_TR_FUNCTIONS(SectionCommand)
};

/// The scene as it becomes, beside a surface that stays, if it does, and is seen as it is now:
/// looking is no edit.
void keepCameras(Scene& scene, const std::optional<SurfaceSetting>& now) {
  if (!now || !scene.surface) return;
  scene.surface->camera = now->camera;
  auto& panes = scene.surface->panes;
  for (std::size_t i = 0; i < std::min(panes.size(), now->panes.size()); ++i) {
    if (panes[i].camera && now->panes[i].camera) panes[i].camera = now->panes[i].camera;
  }
}

class OpenSection : public QUndoCommand {
 public:
  OpenSection(Document& document, Scene scene, const CutPlane& plane)
      : QUndoCommand(SectionCommandWords::tr("open section")),
        document_(document),
        scene_(std::move(scene)),
        plane_(plane) {
    setObsolete(scene_ == document_.scene());
  }

  void undo() override {
    keepCameras(scene_, document_.scene().surface);
    document_.swapScene(scene_);
  }
  /// The section is seen as the surface is, which may have been turned since.
  void redo() override {
    keepCameras(scene_, document_.scene().surface);
    if (scene_.surface && !scene_.surface->camera.perspectiveDeg) {
      const PlaneView flat =
          planeViewOf(plane_, {.towards = scene_.surface->camera.towards, .eye = {}});
      if (flat.view) scene_.view = *flat.view;
    }
    document_.swapScene(scene_);
  }

 private:
  Document& document_;
  Scene scene_;
  CutPlane plane_;
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
  document.push(std::make_unique<OpenSection>(document, std::move(scene), section.section.plane));
}

}  // namespace flatland::ui
