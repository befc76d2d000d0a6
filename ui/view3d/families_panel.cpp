// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/families_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "ui/commands/scene_commands.h"
#include "ui/export/line_style.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"
#include "ui/view3d/ink_row.h"

namespace flatland::ui {

namespace {

// The slider is logarithmic: a hundredth to a hundred, its left end 0.
constexpr int kSliderEnd = 200;
constexpr double kDecades = 4.0, kLeast = 0.01;
constexpr double kMostThreshold = 1e6, kMostWidth = 12.0;
constexpr int kIconPx = 16;
constexpr int kMarginPx = 6;
constexpr int kThresholds = 1, kColours = 3, kWidths = 4, kFades = 5;  ///< columns
constexpr int kSpacingPx = 4;
constexpr int kSliderWidth = 32;   ///< in px, at least: a row has room in the dock, in German too
constexpr int kFieldFramePx = 16;  ///< around the digits of a field

double thresholdAt(int slider) {
  if (slider <= 0) return 0.0;
  // Three digits, so that the field shows what is meant.
  const double value = kLeast * std::pow(10.0, kDecades * slider / kSliderEnd);
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::round(value / step) * step;
}

int sliderAt(double threshold) {
  if (!(threshold > kLeast)) return 0;
  return qBound(1, qRound(kSliderEnd * std::log10(threshold / kLeast) / kDecades), kSliderEnd);
}

/// Of a part of a row; that of the slider is set, those of others are in their hints.
int leastWidth(const QWidget& part) {
  return part.minimumWidth() > 0 ? part.minimumWidth() : part.minimumSizeHint().width();
}

bool hasThreshold(LineFamily family) { return *usualFamily(family).threshold > 0.0; }

QIcon colourIcon(Rgb colour) {
  QPixmap pixmap(kIconPx, kIconPx);
  pixmap.fill(QColor(colour.r, colour.g, colour.b));
  return pixmap;
}

QString idOf(LineFamily family, const char* part) {
  const std::string_view name = nameOf(family);
  return QStringLiteral("families.%1.%2")
      .arg(QLatin1String(name.data(), static_cast<qsizetype>(name.size())), part);
}

}  // namespace

FamiliesPanel::FamiliesPanel(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("families-panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMarginPx, kMarginPx, kMarginPx, kMarginPx);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kSpacingPx);
  grid->setVerticalSpacing(1);
  const QString heads[kColumns] = {tr("Lines"), tr("Threshold"), {}, {}, tr("Width"), tr("Fade")};
  for (int i = 0; i < kColumns; ++i) {
    if (heads[i].isEmpty()) continue;
    heads_[static_cast<std::size_t>(i)] = new QLabel(heads[i], this);
    grid->addWidget(heads_[static_cast<std::size_t>(i)], 0, i, 1,
                    i == kThresholds ? 2 : 1);  // above slider and field
  }
  grid->setColumnStretch(1, 1);
  int line = 1;
  for (const LineFamily family : allLineFamilies()) {
    rows_[static_cast<std::size_t>(family)] = makeRow(family, *grid, line++);
  }
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

std::array<QWidget*, FamiliesPanel::kColumns> FamiliesPanel::Row::parts() const {
  return {on, slider, threshold, colour, width, fade};
}

FamiliesPanel::Row FamiliesPanel::makeRow(LineFamily family, QGridLayout& grid, int line) {
  Row row{};
  const QString title = coreWords(std::string(lineTitle(family)));
  row.on = new QCheckBox(title, this);
  row.on->setObjectName(idOf(family, "on"));
  row.on->setToolTip(tr("Draw these lines"));
  connect(row.on, &QCheckBox::toggled, this, [this, family](bool on) { switchOn(family, on); });
  row.slider = new QSlider(Qt::Horizontal, this);
  row.slider->setObjectName(idOf(family, "slider"));
  row.slider->setRange(0, kSliderEnd);
  row.slider->setMinimumWidth(kSliderWidth);
  row.slider->setAccessibleName(tr("Threshold of %1").arg(title));
  row.slider->setToolTip(tr("How strong a line must be; curvatures times the size of the surface"));
  connect(row.slider, &QSlider::sliderPressed, this,
          [this] { gesture_ = models_.document.newGesture(); });
  connect(row.slider, &QSlider::sliderReleased, this, [this] { gesture_ = 0; });
  connect(row.slider, &QSlider::valueChanged, this, [this, family](int value) {
    edit(
        family, [value](SurfaceFamily& look) { look.threshold = thresholdAt(value); }, gesture_);
  });
  row.threshold = new QDoubleSpinBox(this);
  row.threshold->setObjectName(idOf(family, "threshold"));
  row.threshold->setRange(0.0, kMostThreshold);
  row.threshold->setDecimals(2);
  row.threshold->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  row.threshold->setButtonSymbols(QAbstractSpinBox::NoButtons);
  row.threshold->setKeyboardTracking(false);
  row.threshold->setAccessibleName(row.slider->accessibleName());
  row.threshold->setToolTip(row.slider->toolTip());
  connect(row.threshold, &QDoubleSpinBox::valueChanged, this, [this, family](double value) {
    edit(family, [value](SurfaceFamily& look) { look.threshold = value; });
  });
  if (family == LineFamily::Creases) {
    row.threshold->setDecimals(1);
    row.threshold->setSuffix(QStringLiteral("°"));
    row.threshold->setToolTip(tr("Smallest angle between the two triangles of an edge"));
    row.slider->setToolTip(row.threshold->toolTip());
  }
  row.slider->setVisible(hasThreshold(family));
  row.threshold->setVisible(hasThreshold(family));
  auto* colour = new QToolButton(this);
  colour->setObjectName(idOf(family, "colour"));
  colour->setAutoRaise(true);
  colour->setAccessibleName(tr("Colour of %1").arg(title));
  colour->setToolTip(tr("Another colour; the usual one suits the background"));
  connect(colour, &QToolButton::clicked, this, [this, family] { chooseColour(family); });
  row.colour = colour;
  row.width = new QDoubleSpinBox(this);
  row.width->setObjectName(idOf(family, "width"));
  row.width->setRange(0.2, kMostWidth);
  row.width->setDecimals(1);
  row.width->setSingleStep(0.2);
  row.width->setKeyboardTracking(false);
  row.width->setButtonSymbols(QAbstractSpinBox::NoButtons);
  row.width->setAccessibleName(tr("Width of %1").arg(title));
  row.width->setToolTip(tr("Width in pixels"));
  connect(row.width, &QDoubleSpinBox::valueChanged, this, [this, family](double value) {
    edit(family, [value](SurfaceFamily& look) { look.widthPx = value; });
  });
  row.fade = new QCheckBox(this);
  row.fade->setObjectName(idOf(family, "fade"));
  row.fade->setAccessibleName(tr("Fade %1").arg(title));
  row.fade->setToolTip(tr("Weak lines are paler"));
  row.fade->setVisible(hasThreshold(family));
  connect(row.fade, &QCheckBox::toggled, this,
          [this, family](bool on) { edit(family, [on](SurfaceFamily& look) { look.fade = on; }); });
  for (int i = 0; i < kColumns; ++i) grid.addWidget(row.parts()[i], line, i);
  return row;
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
  const auto levels = [&](const char* id, const QString& tip, int SurfaceSetting::*count) {
    auto* box = new QSpinBox(common);
    box->setObjectName(id);
    box->setRange(1, 200);
    box->setKeyboardTracking(false);
    box->setToolTip(tip);
    connect(box, &QSpinBox::valueChanged, this, [this, count](int value) {
      editSetting([count, value](SurfaceSetting& setting) { setting.*count = value; });
    });
    return box;
  };
  isophotes_ =
      levels("families.isophotes", tr("How many levels of brightness"), &SurfaceSetting::isophotes);
  heights_ = levels("families.heights", tr("How many levels of height"), &SurfaceSetting::heights);
  form->addRow(tr("Isophotes"), isophotes_);
  form->addRow(tr("Heights"), heights_);
  return common;
}

void FamiliesPanel::showSetting() {
  const auto& scene = models_.document.scene().surface;
  setEnabled(scene.has_value());
  SurfaceSetting setting = scene.value_or(SurfaceSetting{});
  if (scene) setting = paneSetting(setting, models_.views.active()).surface;
  const Palette palette = themePalette();
  for (const LineFamily family : allLineFamilies()) {
    const Row& row = rows_[static_cast<std::size_t>(family)];
    const SurfaceFamily look = familyOf(setting, family);
    const QSignalBlocker on(row.on), slider(row.slider), threshold(row.threshold), width(row.width),
        fade(row.fade);
    row.on->setChecked(look.on);
    row.slider->setValue(sliderAt(*look.threshold));
    row.threshold->setValue(*look.threshold);
    row.width->setValue(look.widthPx);
    row.fade->setChecked(look.fade);
    row.colour->setIcon(colourIcon(colourOf(look, palette)));
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
  const QFontMetrics metrics = fontMetrics();
  for (const Row& row : rows_) {
    row.threshold->setFixedWidth(metrics.horizontalAdvance("00.00") + kFieldFramePx);
    row.width->setFixedWidth(metrics.horizontalAdvance("12.0") + kFieldFramePx);
  }
}

int FamiliesPanel::widthOf(int column) const {
  int widest = heads_[column] && column != kThresholds ? heads_[column]->sizeHint().width() : 0;
  for (const Row& row : rows_) {
    widest = std::max(widest, leastWidth(*row.parts()[static_cast<std::size_t>(column)]));
  }
  return widest + kSpacingPx;
}

QSize FamiliesPanel::minimumSizeHint() const {
  const int row = widthOf(0) + widthOf(kThresholds + 1) + widthOf(kColours);
  const int least = std::max(row - kSpacingPx, common_->minimumSizeHint().width());
  return {least + 2 * kMarginPx, QWidget::minimumSizeHint().height()};
}

// In large type those columns go first that a class does not look for.
void FamiliesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  int room = width() - minimumSizeHint().width();
  for (const int column : {kWidths, kFades, kThresholds}) {
    room -= widthOf(column);
    const bool shown = room >= 0;
    if (column == kThresholds) {
      heads_[column]->setAlignment(shown ? Qt::AlignLeft : Qt::AlignRight);
    } else {
      heads_[column]->setVisible(shown);
    }
    for (const LineFamily family : allLineFamilies()) {
      const Row& row = rows_[static_cast<std::size_t>(family)];
      row.parts()[static_cast<std::size_t>(column)]->setVisible(
          shown && (column == kWidths || hasThreshold(family)));
    }
  }
}

void FamiliesPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showSetting();
  if (event->type() == QEvent::FontChange) fitFields();
  QWidget::changeEvent(event);
}

}  // namespace flatland::ui
