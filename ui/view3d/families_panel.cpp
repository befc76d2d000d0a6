// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/families_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/commands/scene_commands.h"
#include "ui/export/line_style.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"
#include "ui/view3d/ink_row.h"

namespace flatland::ui {

namespace {

constexpr int kMarginPx = 6, kSpacingPx = 4;
constexpr int kMostLevels = 200;
constexpr int kFieldFramePx = 16;  ///< around the digits of a field

int leastWidth(const QWidget& part) {
  return part.minimumWidth() > 0 ? part.minimumWidth() : part.minimumSizeHint().width();
}

}  // namespace

FamiliesPanel::FamiliesPanel(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("families-panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMarginPx, kMarginPx, kMarginPx, kMarginPx);
  auto* grid = grid_ = new QGridLayout;
  grid->setHorizontalSpacing(kSpacingPx);
  grid->setVerticalSpacing(1);
  const QString heads[FamilyRow::kColumns] = {
      tr("Lines"), tr("Threshold"), {}, tr("Width"), tr("Fade")};
  for (int i = 0; i < FamilyRow::kColumns; ++i) {
    if (heads[i].isEmpty()) continue;
    auto* head = heads_[static_cast<std::size_t>(i)] = new QLabel(heads[i], this);
    if (i == FamilyRow::kNumber) {
      // Longer than the field; names are not as long as their column.
      grid->addWidget(head, 0, FamilyRow::kName, 1, 2, Qt::AlignRight);
    } else {
      grid->addWidget(head, 0, i);
    }
  }
  grid->setColumnStretch(FamilyRow::kName, 1);
  int line = 1;
  for (const LineFamily family : allLineFamilies()) {
    addRow(family, *grid, line);
    line += FamilyRow::kLines;
  }
  isophotes_ = addLevels(LineFamily::Isophotes, "families.isophotes",
                         tr("How many levels of brightness"), &SurfaceSetting::isophotes);
  heights_ = addLevels(LineFamily::Topographic, "families.heights", tr("How many levels of height"),
                       &SurfaceSetting::heights);
  layout->addLayout(grid);
  common_ = makeCommon();
  layout->addWidget(common_);
  layout->addStretch(1);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showSetting();
  });
  connect(&models_.views, &SurfaceViews::activeChanged, this, &FamiliesPanel::showSetting);
  fitFields();
  showSetting();
}

void FamiliesPanel::addRow(LineFamily family, QGridLayout& grid, int line) {
  auto* row = new FamilyRow(family, models_.document, *this);
  connect(row, &FamilyRow::switched, this, [this, family](bool on) { switchOn(family, on); });
  connect(row, &FamilyRow::edited, this,
          [this, family](const std::function<void(SurfaceFamily&)>& change, int gesture) {
            edit(family, change, gesture);
          });
  connect(row, &FamilyRow::colourWanted, this, [this, family] { chooseColour(family); });
  row->addTo(grid, line);
  rows_[static_cast<std::size_t>(family)] = row;
}

QSpinBox* FamiliesPanel::addLevels(LineFamily family, const char* id, const QString& tip,
                                   int SurfaceSetting::*count) {
  auto* box = new QSpinBox(this);
  box->setObjectName(id);
  box->setRange(1, kMostLevels);
  box->setKeyboardTracking(false);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setToolTip(tip);
  box->setAccessibleName(tip);
  connect(box, &QSpinBox::valueChanged, this, [this, count](int value) {
    editSetting([count, value](SurfaceSetting& setting) { setting.*count = value; });
  });
  const int line = 1 + FamilyRow::kLines * static_cast<int>(family);
  grid_->addWidget(box, line, FamilyRow::kNumber);
  return box;
}

QWidget* FamiliesPanel::makeCommon() {
  auto* common = new QWidget(this);
  auto* form = new QFormLayout(common);
  form->setContentsMargins(0, 8, 0, 0);
  hidden_ = new QComboBox(common);
  hidden_->setObjectName("families.hidden");
  hidden_->setToolTip(tr("Lines that the surface hides"));
  hidden_->addItems({tr("Left out"), tr("Dashed"), tr("Shown")});
  connect(hidden_, &QComboBox::activated, this, [this](int index) {
    editSetting([index](SurfaceSetting& setting) {
      setting.hidden = nameOf(static_cast<HiddenLines>(index));
    });
  });
  form->addRow(tr("Hidden lines"), hidden_);
  unfiltered_ = new QCheckBox(tr("Every crossing, unfiltered"), common);
  unfiltered_->setObjectName("families.unfiltered");
  unfiltered_->setToolTip(
      tr("Also where the equation holds but no line is drawn: minima, weak ones, the far side"));
  connect(unfiltered_, &QCheckBox::toggled, this, [this](bool on) {
    editSetting([on](SurfaceSetting& setting) { setting.unfiltered = on; });
  });
  form->addRow(unfiltered_);
  form->addRow(new InkRow(models_, common));
  return common;
}

void FamiliesPanel::showSetting() {
  const auto& scene = models_.document.scene().surface;
  setEnabled(scene.has_value());
  SurfaceSetting setting = scene.value_or(SurfaceSetting{});
  if (scene) setting = paneSetting(setting, models_.views.active()).surface;
  const Palette palette = themePalette();
  for (const LineFamily family : allLineFamilies()) {
    rows_[static_cast<std::size_t>(family)]->show(familyOf(setting, family), palette);
  }
  const QSignalBlocker unfiltered(unfiltered_), isophotes(isophotes_), heights(heights_);
  hidden_->setCurrentIndex(static_cast<int>(hiddenOf(setting)));
  unfiltered_->setChecked(setting.unfiltered);
  isophotes_->setValue(setting.isophotes);
  heights_->setValue(setting.heights);
}

void FamiliesPanel::edit(LineFamily family, const std::function<void(SurfaceFamily&)>& change,
                         int gesture) {
  const auto& setting = models_.document.scene().surface;
  if (!setting) return;
  SurfaceFamily look = familyOf(*setting, family);
  const SurfaceFamily before = look;
  change(look);
  if (look == before) return;
  models_.document.push(std::make_unique<SetSurface>(models_.document, withFamily(*setting, look),
                                                     tr("change lines"), gesture));
}

void FamiliesPanel::switchOn(LineFamily family, bool on) {
  editSetting([&](SurfaceSetting& setting) {
    setting = withFamilyOn(setting, models_.views.active(), family, on);
  });
}

void FamiliesPanel::editSetting(const std::function<void(SurfaceSetting&)>& change) {
  std::optional<SurfaceSetting> setting = models_.document.scene().surface;
  if (!setting) return;
  change(*setting);
  models_.document.push(
      std::make_unique<SetSurface>(models_.document, std::move(setting), tr("change lines")));
}

void FamiliesPanel::chooseColour(LineFamily family) {
  const auto& setting = models_.document.scene().surface;
  if (!setting) return;
  const Rgb now = colourOf(familyOf(*setting, family), themePalette());
  const QColor chosen =
      QColorDialog::getColor(QColor(now.r, now.g, now.b), this,
                             tr("Colour of %1").arg(coreWords(std::string(lineTitle(family)))));
  if (!chosen.isValid()) return;
  edit(family, [&chosen](SurfaceFamily& look) { look.colour = chosen.name().toStdString(); });
}

void FamiliesPanel::fitFields() {
  for (FamilyRow* row : rows_) row->fitFields();
  for (QSpinBox* levels : {isophotes_, heights_}) {
    levels->setFixedWidth(fontMetrics().horizontalAdvance("00.00") + kFieldFramePx);
  }
}

int FamiliesPanel::widthOf(int column) const {
  const QLabel* head = heads_[static_cast<std::size_t>(column)];
  int widest = head && column != FamilyRow::kNumber ? head->sizeHint().width() : 0;
  for (const FamilyRow* row : rows_) {
    if (const QWidget* part = row->part(column)) widest = std::max(widest, leastWidth(*part));
  }
  return widest + kSpacingPx;
}

QSize FamiliesPanel::minimumSizeHint() const {
  const int row =
      widthOf(FamilyRow::kName) + widthOf(FamilyRow::kNumber) + widthOf(FamilyRow::kColour);
  const int least = std::max(row - kSpacingPx, common_->minimumSizeHint().width());
  return {least + 2 * kMarginPx, QWidget::minimumSizeHint().height()};
}

// In large type those columns go first that a class does not look for.
void FamiliesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  int room = width() - minimumSizeHint().width();
  for (const int column : {FamilyRow::kWidth, FamilyRow::kFade}) {
    room -= widthOf(column);
    heads_[static_cast<std::size_t>(column)]->setVisible(room >= 0);
    for (const FamilyRow* row : rows_) {
      if (QWidget* part = row->part(column)) part->setVisible(room >= 0);
    }
  }
}

void FamiliesPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showSetting();
  if (event->type() == QEvent::FontChange) fitFields();
  QWidget::changeEvent(event);
}

}  // namespace flatland::ui
