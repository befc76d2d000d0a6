// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace flatland::ui {

/// All keys and mouse gestures on one sheet, which may stay open beside the work. H, ? and Esc
/// close it.
class KeySheet : public QDialog {
  Q_OBJECT

 public:
  explicit KeySheet(QWidget* parent);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace flatland::ui
