// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace flatland::ui {

/// One line of text that ends in dots where there is no room for all of it, and never asks for
/// room: so it widens no panel. Give it a tooltip that has the whole.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace flatland::ui
