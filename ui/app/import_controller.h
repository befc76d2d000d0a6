// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "flatland/io/svg_file.h"
#include "ui/flat/canvas_models.h"
#include "ui/import/glyph.h"

class QWidget;

namespace flatland::ui {

class MessageBar;

/// Brings curves from elsewhere into the scene, as one step each, selected so that they can be
/// moved as a whole. What was done and left out, and what went wrong, goes to the message bar.
class ImportController : public QObject {
  Q_OBJECT

 public:
  ImportController(QWidget& window, const CanvasModels& models, MessageBar& messages);

  void importSvg();    ///< asks which drawing
  void importGlyph();  ///< asks which letter of which font
  void importSvgFile(const QString& name);

 private:
  void add(const ImportedScene& imported, const QString& what);

  QWidget& window_;
  CanvasModels models_;
  MessageBar& messages_;
  QString folder_;
  GlyphName glyph_;
};

}  // namespace flatland::ui
