// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/bridge_marks.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/export/line_style.h"
#include "ui/model/bridge_ticks.h"
#include "ui/model/bridges.h"
#include "ui/model/theme.h"
#include "ui/panels/mark_painting.h"
#include "ui/view3d/mark_lines.h"
#include "ui/view3d/picture_legend.h"

namespace flatland::ui {

namespace {

struct BridgeMarksWords {
  Q_DECLARE_TR_FUNCTIONS(BridgeMarks)
};

constexpr double kTickPx = 16.0;   ///< long
constexpr double kSymbolPx = 8.0;  ///< from the end of a tick to the middle of its symbol
constexpr int kKeyPx = 34;         ///< of the legend

void paintLegend(QPainter& painter, const QPoint& corner, double scale) {
  const Palette palette = themePalette();
  const QPen ink = painter.pen();
  const int line = painter.fontMetrics().height(), key = qRound(kKeyPx * scale);
  const struct {
    MarkKind kind;
    QString words;
  } rows[] = {{MarkKind::ApparentRidge, BridgeMarksWords::tr("predicted apparent ridge")},
              {MarkKind::Silhouette, BridgeMarksWords::tr("predicted contour")}};
  int width = 0;
  for (const auto& row : rows) {
    width = std::max(width, painter.fontMetrics().horizontalAdvance(row.words));
  }
  QColor ground = painter.background().color();
  ground.setAlphaF(static_cast<float>(kBehindText));
  painter.fillRect(QRect(corner.x() - 4, corner.y() - 2, key + width + 12, 2 * line + 4), ground);
  int y = corner.y();
  for (const auto& row : rows) {
    QPen dashes(toQColor(predictedColour(row.kind, palette)), kPredictedWidthPx * scale);
    dashes.setDashPattern({kPredictedDash.begin(), kPredictedDash.end()});
    dashes.setCapStyle(Qt::FlatCap);
    painter.setPen(dashes);
    painter.drawLine(corner.x(), y + line / 2, corner.x() + key - 8, y + line / 2);
    painter.setPen(ink);
    painter.drawText(corner.x() + key, y + painter.fontMetrics().ascent(), row.words);
    y += line;
  }
}

}  // namespace

std::vector<PathShape> tickShapes(const BridgeView& bridge, const Projection& projection,
                                  Palette palette, double scale) {
  std::vector<PathShape> shapes;
  for (const EdgeTick& tick : edgeTicks(bridge, projection)) {
    const bool limited = bridge.limits[tick.line] != BridgeLimit::None;
    const MarkKind kind = bridge.prediction.lines()[tick.line].kind;
    Rgb colour = predictedColour(kind, palette);
    if (limited) colour = paler(colour, sceneColours(palette).background);
    const Vec2 end = tick.at + scale * kTickPx * tick.inward;
    PathData line;
    line.moveTo(tick.at);
    line.lineTo(end);
    shapes.push_back({line, std::nullopt, Stroke{.colour = colour, .width = 2.0 * scale}});
    shapes.push_back(markSymbol(kind, end + scale * kSymbolPx * tick.inward, scale * kSymbolSizePx,
                                std::atan2(tick.inward.y(), tick.inward.x()), palette, limited));
  }
  return shapes;
}

void paintBridge(QPainter& painter, const SurfaceModels& models, const Projection& projection,
                 const QPoint& corner) {
  const BridgeSource& source = models.bridges.source;
  if (!source.isShown() || !source.view() || source.view()->prediction.lines().empty()) return;
  const double scale = models.display.uiScale();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  paintLegend(painter, corner, scale);
  if (!models.setting().ownCamera) {
    for (const PathShape& shape : tickShapes(*source.view(), projection, themePalette(), scale)) {
      paintShape(painter, shape);
    }
  }
  painter.restore();
}

}  // namespace flatland::ui
