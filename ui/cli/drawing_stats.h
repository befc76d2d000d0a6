// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core3d/draw/draughtsman.h"
#include "ui/cli/mesh_options.h"

namespace flatland::ui {

/// What one picture took and shows.
struct PictureStats {
  std::string file;  ///< without folder
  DrawingStats drawing;
  std::size_t polylines = 0;
  double writeMs = 0.0;  ///< of making the file's contents and writing it
};

/// For the "stats" of a JSON drawing, one line: what depends on mesh, view and options alone.
std::string statsOfDrawing(const Drawing& drawing, const TriangleMesh& mesh);

/// For --stats: the mesh, milliseconds by stage, every picture, and the most memory the program has
/// used. Keys in docs/user/lines.md.
std::string statsOfRun(const std::string& mesh, const PreparedMesh& prepared,
                       const Draughtsman::Preparation& drawer,
                       const std::vector<PictureStats>& pictures);

}  // namespace flatland::ui
