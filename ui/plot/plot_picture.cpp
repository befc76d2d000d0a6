// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_picture.h"

#include <qcustomplot.h>

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <algorithm>

#include "flatland/io/input_error.h"

namespace flatland::ui {

namespace {

constexpr int kPxPerInch = 96;
constexpr int kLargestPixels = 32768;  // QImage's own limit

/// On a device without pixels: nothing is cached as an image, nothing snapped to a grid.
void paintVectors(QCustomPlot& plot, QPaintDevice& device, const QSize& size) {
  QCPPainter painter;
  painter.begin(&device);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  plot.toPainter(&painter, size.width(), size.height());
}

void writeSvg(QCustomPlot& plot, QBuffer& to, const QSize& size, const QString& title) {
  QSvgGenerator svg;
  svg.setOutputDevice(&to);
  svg.setResolution(kPxPerInch);
  svg.setSize(size);
  svg.setViewBox(QRect(QPoint(), size));
  svg.setTitle(title);
  paintVectors(plot, svg, size);
}

void writePdf(QCustomPlot& plot, QBuffer& to, const QSize& size, const QString& title) {
  QPdfWriter pdf(&to);
  pdf.setResolution(kPxPerInch);
  pdf.setTitle(title);
  pdf.setPageMargins({});
  pdf.setPageSize(
      QPageSize(QSizeF(size) * 72.0 / kPxPerInch, QPageSize::Point, {}, QPageSize::ExactMatch));
  paintVectors(plot, pdf, size);
}

void writePng(QCustomPlot& plot, QBuffer& to, const QSize& size, double dpi) {
  const double scale = dpi / kPxPerInch;
  const QSize pixels = (QSizeF(size) * scale).toSize().expandedTo({1, 1});
  QImage image;
  if (std::max(pixels.width(), pixels.height()) <= kLargestPixels) {
    image = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
  }
  if (image.isNull()) throw InputError("PNG", "", "no picture of this size can be made");
  image.fill(Qt::white);
  QCPPainter painter(&image);
  painter.setMode(QCPPainter::pmNoCaching);
  painter.scale(scale, scale);
  plot.toPainter(&painter, size.width(), size.height());
  painter.end();
  image.setDotsPerMeterX(qRound(dpi / 0.0254));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  if (!image.save(&to, "PNG")) throw InputError("PNG", "", "no picture of this size can be made");
}

}  // namespace

QString suffixOf(PictureFormat format) {
  switch (format) {
    case PictureFormat::Svg:
      return QStringLiteral("svg");
    case PictureFormat::Pdf:
      return QStringLiteral("pdf");
    case PictureFormat::Png:
      break;
  }
  return QStringLiteral("png");
}

std::string pictureOf(QCustomPlot& plot, PictureFormat format, const QSize& size, double dpi,
                      const QString& title) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  switch (format) {
    case PictureFormat::Svg:
      writeSvg(plot, buffer, size, title);
      break;
    case PictureFormat::Pdf:
      writePdf(plot, buffer, size, title);
      break;
    case PictureFormat::Png:
      writePng(plot, buffer, size, dpi);
      break;
  }
  return buffer.data().toStdString();
}

}  // namespace flatland::ui
