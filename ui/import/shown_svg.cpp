// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/shown_svg.h"

#include "flatland/io/input_error.h"
#include "ui/model/paths.h"

namespace flatland::ui {

ImportedScene loadSvgToShow(const QString& name) {
  ImportedScene imported = loadSvg(toPath(name));
  int pieces = 0;
  for (const SceneCurve& curve : imported.scene.curves) pieces += pieceCount(curve.shape);
  if (pieces > kMostShownPieces) {
    throw InputError(name.toStdString(), "",
                     "has " + std::to_string(pieces) + " pieces, more than the " +
                         std::to_string(kMostShownPieces) +
                         " that the window can follow; flatland features takes them all");
  }
  return imported;
}

}  // namespace flatland::ui
