// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flatland/scene/scene.h"

namespace flatland::ui {

/// What a picture says of the scene that it shows (FigureSource::sceneJson): the scene as a file
/// has it, but a mesh file by its name alone. Pictures are passed on, and the folders of who made
/// them are nobody's business.
std::string sceneRecord(Scene scene);

}  // namespace flatland::ui
