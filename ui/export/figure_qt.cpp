// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_qt.h"

#include <QBuffer>
#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <cmath>

#include "flatland/io/input_error.h"

namespace flatland::ui {

namespace {

QPointF toQPoint(const Vec2& p) { return {p.x(), p.y()}; }

QPen penOf(const Stroke& stroke) {
  QPen pen(toQColor(stroke.colour));
  pen.setWidthF(stroke.width);
  pen.setCapStyle(stroke.roundCaps ? Qt::RoundCap : Qt::FlatCap);
  pen.setJoinStyle(stroke.roundJoins ? Qt::RoundJoin : Qt::MiterJoin);
  if (!stroke.dash.empty()) {
    QList<qreal> pattern;  // in multiples of the width
    for (const double length : stroke.dash) pattern.append(length / stroke.width);
    pen.setDashPattern(pattern);
  }
  return pen;
}

void paint(QPainter& painter, const PathShape& shape) {
  painter.setPen(shape.stroke ? penOf(*shape.stroke) : QPen(Qt::NoPen));
  painter.setBrush(shape.fill ? QBrush(toQColor(*shape.fill)) : QBrush(Qt::NoBrush));
  painter.drawPath(toPainterPath(shape.path));
}

void paint(QPainter& painter, const TextShape& shape) {
  QFont font;
  font.setFamilies({"Helvetica", "Arial", "DejaVu Sans"});
  font.setStyleHint(QFont::SansSerif);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(shape.size))));
  font.setBold(shape.bold);
  const QString text = QString::fromStdString(shape.text);
  // Metrics of the device painted on, which for a printer differ from the screen's.
  const double width = QFontMetricsF(font, painter.device()).horizontalAdvance(text);
  double x = shape.position.x();
  if (shape.anchor == TextShape::Anchor::Middle) x -= 0.5 * width;
  if (shape.anchor == TextShape::Anchor::End) x -= width;
  painter.setFont(font);
  painter.setPen(toQColor(shape.colour));
  painter.drawText(QPointF(x, shape.position.y() + baselineBelow(shape)), text);
}

QByteArray bytesOf(const std::string& text) {
  return {text.data(), static_cast<qsizetype>(text.size())};
}

}  // namespace

QColor toQColor(Rgb colour) { return {colour.r, colour.g, colour.b}; }

QPainterPath toPainterPath(const PathData& path) {
  QPainterPath result;
  result.setFillRule(Qt::WindingFill);  // as SVG and TikZ have it
  std::size_t next = 0;
  const auto point = [&] { return toQPoint(path.points[next++]); };
  for (const PathData::Verb verb : path.verbs) {
    switch (verb) {
      case PathData::Verb::MoveTo:
        result.moveTo(point());
        break;
      case PathData::Verb::LineTo:
        result.lineTo(point());
        break;
      case PathData::Verb::CubicTo: {
        const QPointF c1 = point();
        const QPointF c2 = point();
        result.cubicTo(c1, c2, point());
        break;
      }
      case PathData::Verb::Close:
        result.closeSubpath();
        break;
    }
  }
  return result;
}

void paintFigure(QPainter& painter, const Figure& figure) {
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  if (figure.background) {
    painter.fillRect(QRectF(0.0, 0.0, figure.width, figure.height), toQColor(*figure.background));
  }
  for (const FigureGroup& group : figure.groups) {
    for (const Shape& shape : group.shapes) {
      std::visit([&painter](const auto& s) { paint(painter, s); }, shape);
    }
  }
  painter.restore();
}

std::string figureToPdf(const Figure& figure, const FigureSource& source) {
  constexpr double kPointsPerPx = 72.0 / 96.0;
  constexpr int kDotsPerInch = 1200;  // of the writer's own grid, which is finer than any printer's
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(source.title));
    writer.setCreator(QString::fromStdString(source.program));
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QSizeF(figure.width, figure.height) * kPointsPerPx,
                                 QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
    writer.addFileAttachment(QString::fromStdString(source.sceneName + ".json"),
                             bytesOf(source.sceneJson), "application/json");
    QPainter painter(&writer);
    painter.scale(kDotsPerInch / 96.0, kDotsPerInch / 96.0);
    paintFigure(painter, figure);
  }
  return buffer.data().toStdString();
}

std::string figureToPng(const Figure& figure, const FigureSource& source, double dpi) {
  constexpr double kLargestSide = 32768.0;
  constexpr double kInchesPerMeter = 1.0 / 0.0254;
  const double scale = dpi / 96.0;
  const double width = std::max(1.0, std::round(figure.width * scale));
  const double height = std::max(1.0, std::round(figure.height * scale));
  QImage image;
  if (width <= kLargestSide && height <= kLargestSide) {
    image = QImage(static_cast<int>(width), static_cast<int>(height),
                   figure.background ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
  }
  if (image.isNull()) {
    throw InputError("", "",
                     "a picture of " + std::to_string(std::llround(width)) + " x " +
                         std::to_string(std::llround(height)) + " pixels is too large");
  }
  image.fill(Qt::transparent);
  image.setDotsPerMeterX(static_cast<int>(std::lround(dpi * kInchesPerMeter)));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  image.setText("Title", QString::fromStdString(source.title));
  image.setText("Software", QString::fromStdString(source.program));
  QString key = QString::fromStdString(source.sceneName);
  key[0] = key[0].toUpper();
  image.setText(key, QString::fromStdString(source.sceneJson));
  image.setText("Command", QString::fromStdString(source.command));
  {
    QPainter painter(&image);
    painter.scale(scale, scale);
    paintFigure(painter, figure);
  }
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data().toStdString();
}

}  // namespace flatland::ui
