// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/export_settings.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>

#include "flatland/io/atomic_file.h"
#include "ui/export/figure_qt.h"
#include "ui/export/figure_writers.h"
#include "ui/export/scene_record.h"
#include "ui/model/core_words.h"
#include "ui/model/paths.h"

namespace flatland::ui {

namespace {

QString key(const char* name) { return QStringLiteral("export/") + name; }

QString key(MarkKind kind) {
  const std::string_view name = nameOf(kind);
  return "export/marks/" + QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

/// A stored number brought back into a range, whatever the file says.
double numberIn(const QSettings& settings, const char* name, double low, double high,
                double otherwise) {
  bool isNumber = false;
  const double value = settings.value(key(name), otherwise).toDouble(&isNumber);
  return isNumber && value >= low && value <= high ? value : otherwise;
}

std::string bytesOf(const Figure& figure, const FigureSource& source,
                    const ExportSettings& settings) {
  switch (settings.format) {
    case ExportSettings::Format::Svg:
      return figureToSvg(figure, source);
    case ExportSettings::Format::Pdf:
      return figureToPdf(figure, source);
    case ExportSettings::Format::Png:
      return figureToPng(figure, source, settings.dpi);
    case ExportSettings::Format::Tikz:
      break;
  }
  return figureToTikz(figure, source);
}

}  // namespace

void ExportSettings::restore(const QSettings& settings) {
  const int stored = settings.value(key("format"), static_cast<int>(format)).toInt();
  format = static_cast<Format>(std::clamp(stored, 0, static_cast<int>(Format::Tikz)));
  unit = settings.value(key("unit")).toString() == "px" ? Unit::Pixels : Unit::Centimetres;
  widthPx = numberIn(settings, "width", 1.0, 1e5, widthPx);
  heightPx = numberIn(settings, "height", 1.0, 1e5, heightPx);
  dpi = numberIn(settings, "dpi", 10.0, 2400.0, dpi);
  figure.transparent = settings.value(key("transparent"), figure.transparent).toBool();
  figure.letters = settings.value(key("letters"), figure.letters).toBool();
  figure.legend = settings.value(key("legend"), figure.legend).toBool();
  figure.controlPolygon = settings.value(key("control-polygon"), figure.controlPolygon).toBool();
  figure.hidden = settings.value(key("hidden"), true).toBool() ? FlatFigureOptions::Hidden::Pale
                                                               : FlatFigureOptions::Hidden::Remove;
  const int colours = settings.value(key("colours"), static_cast<int>(figure.palette)).toInt();
  figure.palette =
      static_cast<Palette>(std::clamp(colours, 0, static_cast<int>(Palette::HighContrast)));
  figure.scale = numberIn(settings, "scale", kSmallestScale, kLargestScale, figure.scale);
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const auto i = static_cast<std::size_t>(kind);
    figure.kinds[i] = settings.value(key(kind), figure.kinds.test(i)).toBool();
  }
}

void ExportSettings::save(QSettings& settings) const {
  settings.setValue(key("format"), static_cast<int>(format));
  settings.setValue(key("unit"), unit == Unit::Pixels ? "px" : "cm");
  settings.setValue(key("width"), widthPx);
  settings.setValue(key("height"), heightPx);
  settings.setValue(key("dpi"), dpi);
  settings.setValue(key("transparent"), figure.transparent);
  settings.setValue(key("letters"), figure.letters);
  settings.setValue(key("legend"), figure.legend);
  settings.setValue(key("control-polygon"), figure.controlPolygon);
  settings.setValue(key("hidden"), figure.hidden == FlatFigureOptions::Hidden::Pale);
  settings.setValue(key("colours"), static_cast<int>(figure.palette));
  settings.setValue(key("scale"), figure.scale);
  for (const MarkKind kind : markKindsInLegendOrder()) {
    settings.setValue(key(kind), contains(figure.kinds, kind));
  }
}

QString suffixOf(ExportSettings::Format format) {
  switch (format) {
    case ExportSettings::Format::Svg:
      return QStringLiteral("svg");
    case ExportSettings::Format::Pdf:
      return QStringLiteral("pdf");
    case ExportSettings::Format::Png:
      return QStringLiteral("png");
    case ExportSettings::Format::Tikz:
      break;
  }
  return QStringLiteral("tex");
}

Figure exportedFigure(const Document& document, const ExportSettings& settings) {
  FlatFigureOptions options = settings.figure;
  options.width = settings.widthPx;
  options.height = settings.heightPx;
  options.words = wordsOfTheWindow();
  return flatFigure(document.scene(), document.features(), document.visibility(), options);
}

void exportTo(const std::filesystem::path& file, const Document& document,
              const ExportSettings& settings) {
  FigureSource source;
  source.title = document.file().empty() ? document.originName().toStdString()
                                         : document.file().stem().string();
  source.program =
      QStringLiteral("%1 %2")
          .arg(QCoreApplication::applicationName(), QCoreApplication::applicationVersion())
          .trimmed()
          .toStdString();
  source.sceneJson = sceneRecord(document.scene());
  writeFileAtomically(file, bytesOf(exportedFigure(document, settings), source, settings));
}

}  // namespace flatland::ui
