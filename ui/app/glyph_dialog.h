// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "ui/import/glyph.h"

class QFontComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace flatland::ui {

class OutlineView;

/// Asks for a font and a character, and shows the outline that would come. Accepts only what
/// glyphScene() gives.
class GlyphDialog : public QDialog {
  Q_OBJECT

 public:
  explicit GlyphDialog(const GlyphName& start, QWidget* parent = nullptr);

  GlyphName name() const;

 private:
  void refresh();

  QFontComboBox* family_;
  QLineEdit* character_;
  OutlineView* outline_;
  QLabel* message_;
  QPushButton* accept_;
};

}  // namespace flatland::ui
