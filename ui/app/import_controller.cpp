// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/import_controller.h"

#include <QFileDialog>
#include <QFileInfo>

#include "flatland/io/input_error.h"
#include "ui/app/glyph_dialog.h"
#include "ui/app/message_bar.h"
#include "ui/commands/curve_commands.h"
#include "ui/import/shown_svg.h"
#include "ui/model/core_sentences.h"

namespace flatland::ui {

ImportController::ImportController(QWidget& window, const CanvasModels& models,
                                   MessageBar& messages)
    : QObject(&window), window_(window), models_(models), messages_(messages) {}

void ImportController::importSvg() {
  const QString name = QFileDialog::getOpenFileName(&window_, tr("Import drawing"), folder_,
                                                    tr("SVG drawings (*.svg);;All files (*)"));
  if (name.isEmpty()) return;
  folder_ = QFileInfo(name).path();
  importSvgFile(name);
}

void ImportController::importSvgFile(const QString& name) {
  try {
    add(loadSvgToShow(name), tr("import %1").arg(QFileInfo(name).fileName()));
  } catch (const InputError& error) {
    messages_.showError(errorForPeople(error));
  }
}

void ImportController::importGlyph() {
  GlyphDialog dialog(glyph_, &window_);
  if (dialog.exec() != QDialog::Accepted) return;
  glyph_ = dialog.name();
  try {
    add(glyphScene(glyph_), tr("import glyph"));
  } catch (const InputError& error) {
    messages_.showError(errorForPeople(error));
  }
}

void ImportController::add(const ImportedScene& imported, const QString& what) {
  const std::size_t before = models_.document.scene().curves.size();
  models_.document.push(std::make_unique<AddCurves>(models_.document, imported.scene.curves, what));
  std::set<PointRef> points;
  for (std::size_t i = 0; i < imported.scene.curves.size(); ++i) {
    const std::size_t count = controlPoints(imported.scene.curves[i].shape).size();
    for (std::size_t k = 0; k < count; ++k) points.insert({before + i, k});
  }
  models_.selection.setPoints(std::move(points));
  messages_.showNote(importForPeople(imported));
}

}  // namespace flatland::ui
