// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/display.h"
#include "ui/model/document.h"

class QCheckBox;
class QLabel;

namespace flatland::ui {

/// The families of marks with symbol, letter and count, each with a switch.
class LegendPanel : public QWidget {
  Q_OBJECT

 public:
  LegendPanel(const Document& document, Display& display, QWidget* parent = nullptr);

 private:
  void changeEvent(QEvent* event) override;
  void showColours();  ///< icons and letters in those of the theme, icons as large as the text
  void showCounts();
  void showSwitches();

  const Document& document_;
  Display& display_;
  std::array<QCheckBox*, kMarkKindCount> switches_{};
  std::array<QLabel*, kMarkKindCount> letters_{};
  std::array<QLabel*, kMarkKindCount> counts_{};
  QCheckBox* hidden_;
};

}  // namespace flatland::ui
