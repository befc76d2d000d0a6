// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/export_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "ui/app/export_fields.h"
#include "ui/export/figure_qt.h"
#include "ui/model/mark_words.h"
#include "ui/panels/mark_icon.h"

namespace flatland::ui {

namespace {

using Format = ExportSettings::Format;

std::vector<ExportFormat> formats() {
  return {{ExportDialog::tr("SVG, vector graphics"), suffixOf(Format::Svg)},
          {ExportDialog::tr("PDF, vector graphics"), suffixOf(Format::Pdf)},
          {ExportDialog::tr("PNG, pixels"), suffixOf(Format::Png)},
          {ExportDialog::tr("TikZ, for LaTeX"), suffixOf(Format::Tikz)}};
}

}  // namespace

ExportDialog::ExportDialog(const Document& document, const ExportSettings& settings,
                           QWidget* parent)
    : QDialog(parent),
      document_(document),
      settings_(settings),
      fields_(new ExportFields(formats(), suffixOf(settings.format), settings, this)),
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
  buildScale();
  fields->addWidget(fields_);
  fields->addWidget(buildContents());
  fields->addStretch(1);
  auto* columns = new QHBoxLayout;
  columns->addLayout(fields);
  columns->addWidget(preview_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons);

  read();
  connect(fields_, &ExportFields::changed, this, &ExportDialog::read);
  connect(scale_, &QDoubleSpinBox::valueChanged, this, &ExportDialog::read);
  for (QCheckBox* box : findChildren<QCheckBox*>()) {
    connect(box, &QCheckBox::toggled, this, &ExportDialog::read);
  }
  resize(820, 500);
}

void ExportDialog::buildScale() {
  scale_->setObjectName("export.scale");
  scale_->setToolTip(tr("How much larger than usual marks, letters and lines are"));
  scale_->setRange(ExportSettings::kSmallestScale, ExportSettings::kLargestScale);
  scale_->setSingleStep(0.1);
  scale_->setValue(settings_.figure.scale);
  fields_->addRow(tr("&Marks"), scale_);
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
  fields_->readInto(settings_);
  for (const Format format : {Format::Svg, Format::Pdf, Format::Png, Format::Tikz}) {
    if (suffixOf(format) == fields_->suffix()) settings_.format = format;
  }
  FlatFigureOptions& figure = settings_.figure;
  for (std::size_t i = 0; i < kinds_.size(); ++i) figure.kinds[i] = kinds_[i]->isChecked();
  figure.letters = letters_->isChecked();
  figure.legend = legend_->isChecked();
  figure.controlPolygon = controlPolygon_->isChecked();
  figure.hidden =
      hidden_->isChecked() ? FlatFigureOptions::Hidden::Pale : FlatFigureOptions::Hidden::Remove;
  figure.scale = scale_->value();
  figure.transparent = transparent_->isChecked();
  showPreview();
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
