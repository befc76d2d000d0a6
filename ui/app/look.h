// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QObject>
#include <QPalette>

#include "ui/model/display.h"

namespace flatland::ui {

/// Makes the application look as the person wants it: theme, size of type, and a frame around
/// whatever has the keyboard's focus. While it lives; afterwards everything is as before.
class Look : public QObject {
  Q_OBJECT

 public:
  Look(const Display& display, QObject* parent);
  ~Look() override;

 private:
  void apply();
  void scaleTables(double factor);

  const Display& display_;
  QPalette system_;
  QString systemStyle_;
  QFont font_;
  Display::Theme theme_ = Display::Theme::System;
  double scale_ = 1.0;
};

}  // namespace flatland::ui
