// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QMainWindow;

namespace flatland::ui {

/// All keys, as the menus of the window have them, and mouse gestures on one sheet, which may stay
/// open beside the work. H, ? and Esc close it.
class KeySheet : public QDialog {
  Q_OBJECT

 public:
  explicit KeySheet(QMainWindow* window);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace flatland::ui
