// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/scene_record.h"

#include <utility>

#include "core3d/io/named_mesh.h"
#include "flatland/io/scene_json.h"

namespace flatland::ui {

std::string sceneRecord(Scene scene) {
  if (scene.surface) scene.surface->mesh = nameOfMesh(scene.surface->mesh);
  return sceneToJson(scene);
}

}  // namespace flatland::ui
