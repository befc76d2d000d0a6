// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/theme.h"

#include <QGuiApplication>
#include <QPalette>

namespace flatland::ui {

Palette themePalette() {
  constexpr int kMiddle = 128;
  const bool dark = QGuiApplication::palette().color(QPalette::Base).lightness() < kMiddle;
  return dark ? Palette::Dark : Palette::Light;
}

}  // namespace flatland::ui
