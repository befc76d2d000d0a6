// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/export/figure_qt.h"
#include "ui/model/mark_words.h"
#include "ui/panels/mark_icon.h"

namespace flatland::ui {

namespace {

using Unit = ExportSettings::Unit;
using Format = ExportSettings::Format;

constexpr double kSmallestPx = 40.0;  ///< smaller, nothing can be told apart
constexpr double kLargestPx = 20000.0;

double pxPer(Unit unit) { return unit == Unit::Pixels ? 1.0 : ExportSettings::kPxPerCm; }

}  // namespace

ExportDialog::ExportDialog(const Document& document, const ExportSettings& settings,
                           QWidget* parent)
    : QDialog(parent),
      document_(document),
      settings_(settings),
      format_(new QComboBox(this)),
      width_(new QDoubleSpinBox(this)),
      height_(new QDoubleSpinBox(this)),
      unit_(new QComboBox(this)),
      dpi_(new QDoubleSpinBox(this)),
      colours_(new QComboBox(this)),
      scale_(new QDoubleSpinBox(this)),
      preview_(new QLabel(this)) {
  setObjectName("export");
  setWindowTitle(tr("Export picture"));
  preview_->setObjectName("export.preview");
  preview_->setAccessibleName(tr("Preview"));
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setFrameShape(QFrame::StyledPanel);
  preview_->setMinimumSize(360, 300);
  preview_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* go = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
  go->setObjectName("export.go");
  go->setToolTip(tr("Choose a file and write the picture"));
  go->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* fields = new QVBoxLayout;
  fields->addWidget(buildSize());
  fields->addWidget(buildContents());
  fields->addStretch(1);
  auto* columns = new QHBoxLayout;
  columns->addLayout(fields);
  columns->addWidget(preview_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons);

  showUnit();
  read();
  for (QComboBox* box : {format_, unit_, colours_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::read);
  }
  for (QDoubleSpinBox* box : {width_, height_, dpi_, scale_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &ExportDialog::read);
  }
  for (QCheckBox* box : findChildren<QCheckBox*>()) {
    connect(box, &QCheckBox::toggled, this, &ExportDialog::read);
  }
  resize(820, 500);
}

QWidget* ExportDialog::buildSize() {
  format_->setObjectName("export.format");
  format_->setToolTip(tr("SVG and PDF stay sharp at any size; TikZ is for LaTeX"));
  format_->addItem(tr("SVG, vector graphics"), static_cast<int>(Format::Svg));
  format_->addItem(tr("PDF, vector graphics"), static_cast<int>(Format::Pdf));
  format_->addItem(tr("PNG, pixels"), static_cast<int>(Format::Png));
  format_->addItem(tr("TikZ, for LaTeX"), static_cast<int>(Format::Tikz));
  format_->setCurrentIndex(format_->findData(static_cast<int>(settings_.format)));
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
  scale_->setObjectName("export.scale");
  scale_->setToolTip(tr("How much larger than usual marks, letters and lines are"));
  scale_->setRange(ExportSettings::kSmallestScale, ExportSettings::kLargestScale);
  scale_->setSingleStep(0.1);
  scale_->setValue(settings_.figure.scale);

  auto* group = new QGroupBox(tr("File"), this);
  auto* form = new QFormLayout(group);
  form->addRow(tr("&Format"), format_);
  form->addRow(tr("&Width"), width_);
  form->addRow(tr("&Height"), height_);
  form->addRow(tr("&Unit"), unit_);
  form->addRow(tr("&Dots per inch"), dpi_);
  form->addRow(tr("&Colours"), colours_);
  form->addRow(tr("&Marks"), scale_);
  return group;
}

QCheckBox* ExportDialog::addSwitch(const char* id, const QString& text, const QString& tip) {
  auto* box = new QCheckBox(text, this);
  box->setObjectName(id);
  box->setToolTip(tip);
  return box;
}

QWidget* ExportDialog::buildContents() {
  const FlatFigureOptions& figure = settings_.figure;
  auto* group = new QGroupBox(tr("Show"), this);
  auto* grid = new QGridLayout(group);
  grid->setVerticalSpacing(3);
  int row = 0;
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const std::string id = "export." + std::string(nameOf(kind));
    QCheckBox* box = addSwitch(id.c_str(), pluralForPeople(kind), explanation(kind));
    box->setIcon(markIcon(kind));
    box->setChecked(contains(figure.kinds, kind));
    kinds_[static_cast<std::size_t>(kind)] = box;
    grid->addWidget(box, row++, 0);
  }
  letters_ = addSwitch("export.letters", tr("Letters"), tr("Name the marks by letters"));
  legend_ = addSwitch("export.legend", tr("Legend"), tr("Explain the marks in a legend"));
  controlPolygon_ = addSwitch("export.control-polygon", tr("Control polygon"),
                              tr("Show the lines between the control points"));
  hidden_ =
      addSwitch("export.hidden", tr("Hidden parts"), tr("Show what the viewer cannot see, paler"));
  transparent_ = addSwitch("export.transparent", tr("Transparent"), tr("Leave out the background"));
  letters_->setChecked(figure.letters);
  legend_->setChecked(figure.legend);
  controlPolygon_->setChecked(figure.controlPolygon);
  hidden_->setChecked(figure.hidden == FlatFigureOptions::Hidden::Pale);
  transparent_->setChecked(figure.transparent);
  row = 0;
  for (QCheckBox* box : {letters_, legend_, controlPolygon_, hidden_, transparent_}) {
    grid->addWidget(box, row++, 1);
  }
  return group;
}

void ExportDialog::read() {
  const auto unit = static_cast<Unit>(unit_->currentData().toInt());
  settings_.format = static_cast<Format>(format_->currentData().toInt());
  if (unit == settings_.unit) {
    settings_.widthPx = width_->value() * pxPer(unit);
    settings_.heightPx = height_->value() * pxPer(unit);
  } else {
    settings_.unit = unit;
    showUnit();  // the same size in other numbers
  }
  settings_.dpi = dpi_->value();
  dpi_->setEnabled(settings_.format == Format::Png);
  FlatFigureOptions& figure = settings_.figure;
  for (std::size_t i = 0; i < kinds_.size(); ++i) figure.kinds[i] = kinds_[i]->isChecked();
  figure.letters = letters_->isChecked();
  figure.legend = legend_->isChecked();
  figure.controlPolygon = controlPolygon_->isChecked();
  figure.hidden =
      hidden_->isChecked() ? FlatFigureOptions::Hidden::Pale : FlatFigureOptions::Hidden::Remove;
  figure.palette = static_cast<Palette>(colours_->currentData().toInt());
  figure.scale = scale_->value();
  figure.transparent = transparent_->isChecked();
  showPreview();
}

void ExportDialog::showUnit() {
  const Unit unit = settings_.unit;
  for (const auto& [box, px] :
       {std::pair(width_, settings_.widthPx), {height_, settings_.heightPx}}) {
    const QSignalBlocker silent(box);
    box->setDecimals(unit == Unit::Pixels ? 0 : 2);
    box->setRange(kSmallestPx / pxPer(unit), kLargestPx / pxPer(unit));
    box->setValue(px / pxPer(unit));
  }
}

void ExportDialog::showPreview() {
  const Figure figure = exportedFigure(document_, settings_);
  const QSizeF room = preview_->size() - QSize(8, 8);
  const double scale = std::min(room.width() / figure.width, room.height() / figure.height);
  if (scale <= 0.0) return;
  const double dense = devicePixelRatioF();
  QPixmap picture(
      (QSizeF(figure.width, figure.height) * scale * dense).toSize().expandedTo({1, 1}));
  picture.setDevicePixelRatio(dense);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  if (!figure.background) {
    // The checks that stand for "nothing here".
    painter.fillRect(QRectF(QPointF(), room), QColor(250, 250, 250));
    painter.fillRect(QRectF(QPointF(), room), QBrush(QColor(225, 225, 225), Qt::Dense6Pattern));
  }
  painter.scale(scale, scale);
  paintFigure(painter, figure);
  painter.end();
  preview_->setPixmap(picture);
}

void ExportDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  showPreview();
}

}  // namespace flatland::ui
