// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/theme.h"

#include <QGuiApplication>
#include <QPalette>

namespace flatland::ui {

Palette figurePaletteOf(const QPalette& palette) {
  constexpr int kMiddle = 128;
  const QColor base = palette.color(QPalette::Base);
  if (base == Qt::black) return Palette::HighContrast;
  return base.lightness() < kMiddle ? Palette::Dark : Palette::Light;
}

Palette themePalette() { return figurePaletteOf(QGuiApplication::palette()); }

}  // namespace flatland::ui
