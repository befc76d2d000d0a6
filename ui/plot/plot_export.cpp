// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include <qcustomplot.h>

#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGuiApplication>
#include <QPushButton>
#include <QSettings>

#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "flatland/io/profile_text.h"
#include "ui/model/core_sentences.h"
#include "ui/model/paths.h"
#include "ui/plot/profile_drawing.h"
#include "ui/plot/profile_words.h"

namespace flatland::ui {

namespace {

constexpr double kPxPerCm = 96.0 / 2.54;
constexpr double kSmallestCm = 2.0, kLargestCm = 200.0;
constexpr double kPaperFontPx = 12.0;
constexpr const char* kFolderKey = "export/folder";  // that of pictures

double numberIn(const QSettings& settings, const char* key, double low, double high,
                double otherwise) {
  bool isNumber = false;
  const double value = settings.value(key, otherwise).toDouble(&isNumber);
  return isNumber && value >= low && value <= high ? value : otherwise;
}

QSize pixels(const PlotExportSettings& how) {
  return (QSizeF(how.widthCm, how.heightCm) * kPxPerCm).toSize();
}

/// "plot-lambda": a name to begin with.
QString fileNameOf(PlotKind kind) {
  switch (kind) {
    case PlotKind::Curvature:
      return QStringLiteral("curvature");
    case PlotKind::Lambda:
      return QStringLiteral("lambda");
    case PlotKind::Terms:
      return QStringLiteral("terms");
    case PlotKind::Ratio:
      break;
  }
  return QStringLiteral("ratio");
}

}  // namespace

void PlotExportSettings::restore(const QSettings& settings) {
  const QString saved = settings.value("plots/export-format").toString();
  if (QStringList{"svg", "pdf", "png", "csv"}.contains(saved)) suffix = saved;
  widthCm = numberIn(settings, "plots/export-width", kSmallestCm, kLargestCm, widthCm);
  heightCm = numberIn(settings, "plots/export-height", kSmallestCm, kLargestCm, heightCm);
  dpi = numberIn(settings, "plots/export-dpi", 10.0, 2400.0, dpi);
}

void PlotExportSettings::save(QSettings& settings) const {
  settings.setValue("plots/export-format", suffix);
  settings.setValue("plots/export-width", widthCm);
  settings.setValue("plots/export-height", heightCm);
  settings.setValue("plots/export-dpi", dpi);
}

PlotExportDialog::PlotExportDialog(const QString& title, const PlotExportSettings& settings,
                                   QWidget* parent)
    : QDialog(parent),
      format_(new QComboBox(this)),
      width_(new QDoubleSpinBox(this)),
      height_(new QDoubleSpinBox(this)),
      dpi_(new QDoubleSpinBox(this)) {
  setObjectName("plot-export");
  setWindowTitle(tr("Export plot: %1").arg(title));
  format_->setObjectName("plot-export.format");
  format_->setToolTip(tr("SVG and PDF stay sharp at any size; CSV is for a spreadsheet"));
  format_->addItem(tr("SVG, vector graphics"), "svg");
  format_->addItem(tr("PDF, vector graphics"), "pdf");
  format_->addItem(tr("PNG, pixels"), "png");
  format_->addItem(tr("CSV, the numbers"), "csv");
  format_->setCurrentIndex(std::max(0, format_->findData(settings.suffix)));
  for (auto& [box, value, id, tip] :
       {std::tuple(width_, settings.widthCm, "plot-export.width", tr("Width of the picture")),
        std::tuple(height_, settings.heightCm, "plot-export.height",
                   tr("Height of the picture"))}) {
    box->setObjectName(id);
    box->setToolTip(tip);
    box->setRange(kSmallestCm, kLargestCm);
    box->setSuffix(tr(" cm"));
    box->setValue(value);
  }
  dpi_->setObjectName("plot-export.dpi");
  dpi_->setToolTip(tr("Pixels per inch of a PNG file"));
  dpi_->setRange(10.0, 2400.0);
  dpi_->setDecimals(0);
  dpi_->setValue(settings.dpi);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* go = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
  go->setObjectName("plot-export.go");
  go->setToolTip(tr("Choose a file and write the plot"));
  go->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(format_, &QComboBox::currentIndexChanged, this, &PlotExportDialog::showFormat);
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Format"), format_);
  form->addRow(tr("&Width"), width_);
  form->addRow(tr("&Height"), height_);
  form->addRow(tr("&Dots per inch"), dpi_);
  form->addRow(buttons);
  showFormat();
}

void PlotExportDialog::showFormat() {
  const QString suffix = format_->currentData().toString();
  width_->setEnabled(suffix != "csv");
  height_->setEnabled(suffix != "csv");
  dpi_->setEnabled(suffix == "png");
}

PlotExportSettings PlotExportDialog::settings() const {
  return {.suffix = format_->currentData().toString(),
          .widthCm = width_->value(),
          .heightCm = height_->value(),
          .dpi = dpi_->value()};
}

PlotExporter::PlotExporter(const Plots& plots, QSettings* settings, QWidget* parent)
    : QObject(parent), plots_(plots), settings_(settings), parent_(parent) {}

std::string PlotExporter::pictureOf(PlotKind kind, PictureFormat format,
                                    const PlotExportSettings& how) const {
  // A plot of its own: that on the window keeps its size, theme and probe.
  QCustomPlot plot;
  QFont font = plot.font();
  font.setPixelSize(static_cast<int>(kPaperFontPx));
  plot.setFont(font);
  plot.resize(pixels(how));
  ProfileDrawing drawing(plot, kind);
  drawing.setLook({.palette = Palette::Light, .scale = 1.0, .onPaper = true, .xTicks = true});
  drawing.show(plots_);
  plot.replot(QCustomPlot::rpImmediateRefresh);  // lays out, so that the ticks know their room
  drawing.showRange(plots_);
  return ui::pictureOf(plot, format, pixels(how), how.dpi, titleOf(kind));
}

std::string PlotExporter::tableOf(PlotKind kind) const {
  return profileToCsv(plots_.profile(), plots_.quantitiesOf(kind));
}

void PlotExporter::copyPicture(PlotKind kind) {
  PlotExportSettings how;
  if (settings_) how.restore(*settings_);
  const std::string png = pictureOf(kind, PictureFormat::Png, how);
  QImage image;
  image.loadFromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()));
  QGuiApplication::clipboard()->setImage(image);
  emit said(tr("Copied the plot as a picture."));
}

void PlotExporter::copyTable(PlotKind kind) {
  QGuiApplication::clipboard()->setText(QString::fromStdString(tableOf(kind)));
  emit said(tr("Copied the numbers of the plot as CSV."));
}

void PlotExporter::write(PlotKind kind, const std::filesystem::path& file,
                         const PlotExportSettings& how) const {
  std::string bytes;
  if (how.suffix == "csv") {
    bytes = tableOf(kind);
  } else {
    PictureFormat format = PictureFormat::Svg;
    for (const PictureFormat other : {PictureFormat::Pdf, PictureFormat::Png}) {
      if (how.suffix == suffixOf(other)) format = other;
    }
    bytes = pictureOf(kind, format, how);
  }
  writeFileAtomically(file, bytes);
}

void PlotExporter::exportPlot(PlotKind kind) {
  PlotExportSettings how;
  if (settings_) how.restore(*settings_);
  PlotExportDialog dialog(titleOf(kind), how, parent_);
  if (dialog.exec() != QDialog::Accepted) return;
  how = dialog.settings();
  const QString folder = settings_ ? settings_->value(kFolderKey).toString() : QString();
  QFileDialog files(parent_, tr("Export plot"), folder,
                    tr("%1 files (*.%2)").arg(how.suffix.toUpper(), how.suffix));
  files.setAcceptMode(QFileDialog::AcceptSave);
  files.setDefaultSuffix(
      how.suffix);  // the question about replacing a file is then about the right one
  files.selectFile(fileNameOf(kind) + "." + how.suffix);
  if (files.exec() != QDialog::Accepted || files.selectedFiles().isEmpty()) return;
  const QString name = files.selectedFiles().front();
  try {
    write(kind, toPath(name), how);
  } catch (const InputError& error) {
    emit failed(errorForPeople(error));
    return;
  }
  emit said(tr("Exported to %1").arg(QDir::toNativeSeparators(name)));
  if (!settings_) return;
  how.save(*settings_);
  settings_->setValue(kFolderKey, QFileInfo(name).absolutePath());
}

}  // namespace flatland::ui
