// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/export_fields.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <utility>

namespace flatland::ui {

namespace {

using Unit = ExportSettings::Unit;

constexpr double kSmallestPx = 40.0;  ///< smaller, nothing can be told apart
constexpr double kLargestPx = 20000.0;

double pxPer(Unit unit) { return unit == Unit::Pixels ? 1.0 : ExportSettings::kPxPerCm; }

}  // namespace

ExportFields::ExportFields(const std::vector<ExportFormat>& formats, const QString& suffix,
                           const ExportSettings& settings, QWidget* parent)
    : QGroupBox(parent),
      formats_(formats),
      settings_(settings),
      format_(new QComboBox(this)),
      width_(new QDoubleSpinBox(this)),
      height_(new QDoubleSpinBox(this)),
      unit_(new QComboBox(this)),
      dpi_(new QDoubleSpinBox(this)),
      colours_(new QComboBox(this)),
      form_(new QFormLayout(this)) {
  setTitle(tr("File"));
  format_->setObjectName("export.format");
  format_->setToolTip(tr("SVG and PDF stay sharp at any size; TikZ is for LaTeX"));
  for (const ExportFormat& format : formats_) format_->addItem(format.words, format.suffix);
  format_->setCurrentIndex(qMax(format_->findData(suffix), 0));
  unit_->setObjectName("export.unit");
  unit_->setToolTip(tr("Unit of width and height; 96 px are one inch"));
  unit_->setAccessibleName(tr("Unit"));
  unit_->addItem(tr("cm"), static_cast<int>(Unit::Centimetres));
  unit_->addItem(tr("px"), static_cast<int>(Unit::Pixels));
  unit_->setCurrentIndex(unit_->findData(static_cast<int>(settings_.unit)));
  width_->setObjectName("export.width");
  width_->setToolTip(tr("Width of the picture"));
  height_->setObjectName("export.height");
  height_->setToolTip(tr("Height of the picture"));
  dpi_->setObjectName("export.dpi");
  dpi_->setToolTip(tr("Pixels per inch of a PNG file"));
  dpi_->setRange(10.0, 2400.0);
  dpi_->setDecimals(0);
  dpi_->setValue(settings_.dpi);
  colours_->setObjectName("export.colours");
  colours_->setToolTip(tr("For which background the colours are"));
  colours_->addItem(tr("For white"), static_cast<int>(Palette::Light));
  colours_->addItem(tr("For dark grey"), static_cast<int>(Palette::Dark));
  colours_->addItem(tr("For black"), static_cast<int>(Palette::HighContrast));
  colours_->setCurrentIndex(colours_->findData(static_cast<int>(settings_.figure.palette)));
  addRow(tr("&Format"), format_);
  addRow(tr("&Width"), width_);
  addRow(tr("&Height"), height_);
  addRow(tr("&Unit"), unit_);
  addRow(tr("&Dots per inch"), dpi_);
  addRow(tr("&Colours"), colours_);
  showUnit();
  read();
  for (QComboBox* box : {format_, unit_, colours_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &ExportFields::read);
  }
  for (QDoubleSpinBox* box : {width_, height_, dpi_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &ExportFields::read);
  }
}

void ExportFields::addRow(const QString& label, QWidget* field) { form_->addRow(label, field); }

QString ExportFields::suffix() const { return format_->currentData().toString(); }

void ExportFields::readInto(ExportSettings& settings) const {
  settings.unit = settings_.unit;
  settings.widthPx = settings_.widthPx;
  settings.heightPx = settings_.heightPx;
  settings.dpi = settings_.dpi;
  settings.figure.palette = settings_.figure.palette;
}

void ExportFields::read() {
  const auto unit = static_cast<Unit>(unit_->currentData().toInt());
  if (unit == settings_.unit) {
    settings_.widthPx = width_->value() * pxPer(unit);
    settings_.heightPx = height_->value() * pxPer(unit);
  } else {
    settings_.unit = unit;
    showUnit();  // the same size in other numbers
  }
  settings_.dpi = dpi_->value();
  settings_.figure.palette = static_cast<Palette>(colours_->currentData().toInt());
  const bool isPicture = formats_[static_cast<std::size_t>(format_->currentIndex())].isPicture;
  for (QWidget* field : {static_cast<QWidget*>(width_), static_cast<QWidget*>(height_),
                         static_cast<QWidget*>(unit_), static_cast<QWidget*>(colours_)}) {
    field->setEnabled(isPicture);
  }
  dpi_->setEnabled(suffix() == "png");
  emit changed();
}

void ExportFields::showUnit() {
  const Unit unit = settings_.unit;
  for (const auto& [box, px] :
       {std::pair(width_, settings_.widthPx), {height_, settings_.heightPx}}) {
    const QSignalBlocker silent(box);
    box->setDecimals(unit == Unit::Pixels ? 0 : 2);
    box->setRange(kSmallestPx / pxPer(unit), kLargestPx / pxPer(unit));
    box->setValue(px / pxPer(unit));
  }
}

}  // namespace flatland::ui
