// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/mark_icon.h"

#include <QPainter>
#include <QPixmap>

#include "ui/export/figure_qt.h"
#include "ui/export/mark_style.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

constexpr int kIconPx = 16;
constexpr double kOversampling = 3.0;  ///< stays sharp on dense displays

}  // namespace

QIcon markIcon(MarkKind kind) {
  const MarkStyle& style = styleOf(kind, themePalette());
  QPixmap pixmap(QSize(kIconPx, kIconPx) * kOversampling);
  pixmap.setDevicePixelRatio(kOversampling);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const SymbolOutline outline =
      symbolOutline(style.symbol, Vec2(kIconPx / 2.0, kIconPx / 2.0), kSymbolSizePx, 0.0);
  const QColor colour = toQColor(style.colour);
  if (outline.filled) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
  } else {
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
  }
  painter.drawPath(toPainterPath(outline.path));
  painter.end();
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // not tinted: the colour says which family it is
  return icon;
}

}  // namespace flatland::ui
