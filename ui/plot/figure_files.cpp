// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "ui/export/figure_qt.h"
#include "ui/export/figure_writers.h"
#include "ui/model/core_sentences.h"
#include "ui/model/paths.h"
#include "ui/panels/save_name.h"

namespace flatland::ui {

namespace {

constexpr double kPngDpi = 192.0;

struct FigureFiles {
  Q_DECLARE_TR_FUNCTIONS(FigureFiles)
};

}  // namespace

void writeFigureFile(const std::filesystem::path& file, const FigureFile& contents) {
  const QString suffix = QFileInfo(toQString(file)).suffix().toLower();
  const FigureSource source{.title = contents.title,
                            .program = QStringLiteral("%1 %2")
                                           .arg(QCoreApplication::applicationName(),
                                                QCoreApplication::applicationVersion())
                                           .trimmed()
                                           .toStdString(),
                            .command = contents.command,
                            .sceneJson = contents.sceneJson};
  std::string bytes;
  if (suffix == "csv" && contents.table) {
    bytes = contents.table();
  } else if (suffix == "svg" && contents.figure) {
    bytes = figureToSvg(contents.figure(), source);
  } else if (suffix == "tex" && contents.figure) {
    bytes = figureToTikz(contents.figure(), source);
  } else if (suffix == "pdf" && contents.figure) {
    bytes = figureToPdf(contents.figure(), source);
  } else if (suffix == "png" && contents.figure) {
    bytes = figureToPng(contents.figure(), source, kPngDpi);
  } else {
    throw InputError(
        file.string(), "",
        FigureFiles::tr("the name should end in .svg, .pdf, .png, .tex or .csv").toStdString());
  }
  writeFileAtomically(file, bytes);
}

QString exportFigureFile(QWidget* parent, const FigureFile& contents) {
  QStringList filters;
  if (contents.figure) {
    filters << FigureFiles::tr("SVG picture (*.svg)") << FigureFiles::tr("PDF picture (*.pdf)")
            << FigureFiles::tr("PNG picture (*.png)") << FigureFiles::tr("TikZ picture (*.tex)");
  }
  if (contents.table) filters << FigureFiles::tr("CSV table (*.csv)");
  const QString name =
      askSaveName(parent, FigureFiles::tr("Export diagram"), contents.suggestedName, filters);
  if (name.isEmpty()) return {};
  try {
    writeFigureFile(toPath(name), contents);
  } catch (const InputError& error) {
    return errorForPeople(error);
  }
  return FigureFiles::tr("Exported to %1").arg(QDir::toNativeSeparators(name));
}

}  // namespace flatland::ui
