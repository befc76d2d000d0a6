// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/family_row.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QPixmap>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <cmath>

#include "ui/export/line_style.h"
#include "ui/model/core_words.h"

namespace flatland::ui {

namespace {

// The slider is logarithmic, 100 steps to a decade: a hundredth to a hundred, its left end 0.
constexpr int kSliderEnd = 400, kSliderPage = 20;
constexpr double kDecades = 4.0, kLeast = 0.01;
constexpr double kMostThreshold = 1e6, kMostWidth = 12.0;
constexpr int kIconPx = 16;
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

FamilyRow::FamilyRow(LineFamily family, Document& document, QWidget& panel)
    : QObject(&panel), family_(family) {
  const QString title = coreWords(std::string(lineTitle(family)));
  on_ = new QCheckBox(title, &panel);
  on_->setObjectName(idOf(family, "on"));
  on_->setToolTip(tr("Draw these lines"));
  connect(on_, &QCheckBox::toggled, this, &FamilyRow::switched);
  if (hasThreshold(family)) addThreshold(document, panel, title);
  addLook(panel, title);
}

void FamilyRow::addThreshold(Document& document, QWidget& panel, const QString& title) {
  const QString tip =
      family_ == LineFamily::Creases
          ? tr("Smallest angle between the two triangles of an edge")
          : tr("How strong a line must be; curvatures times the size of the surface, so that the "
               "threshold can stay, and stays, for the next mesh");
  threshold_ = new QDoubleSpinBox(&panel);
  threshold_->setObjectName(idOf(family_, "threshold"));
  threshold_->setRange(0.0, kMostThreshold);
  threshold_->setDecimals(2);
  threshold_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  threshold_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  threshold_->setKeyboardTracking(false);
  threshold_->setAccessibleName(tr("Threshold of %1").arg(title));
  threshold_->setToolTip(tip);
  if (family_ == LineFamily::Creases) {
    threshold_->setDecimals(1);
    threshold_->setSuffix(QStringLiteral("°"));
  }
  connect(threshold_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    emit edited([value](SurfaceFamily& look) { look.threshold = value; }, 0);
  });
  slider_ = new QSlider(Qt::Horizontal, &panel);
  slider_->setObjectName(idOf(family_, "slider"));
  slider_->setRange(0, kSliderEnd);
  slider_->setPageStep(kSliderPage);
  slider_->setAccessibleName(threshold_->accessibleName());
  slider_->setToolTip(tip + tr(". Arrow keys and wheel: 2 % up or down"));
  connect(slider_, &QSlider::sliderPressed, this,
          [this, &document] { gesture_ = document.newGesture(); });
  connect(slider_, &QSlider::sliderReleased, this, [this] { gesture_ = 0; });
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    emit edited([value](SurfaceFamily& look) { look.threshold = thresholdAt(value); }, gesture_);
  });
  fade_ = new QCheckBox(&panel);
  fade_->setObjectName(idOf(family_, "fade"));
  fade_->setAccessibleName(tr("Fade %1").arg(title));
  fade_->setToolTip(tr("Weak lines are paler"));
  connect(fade_, &QCheckBox::toggled, this,
          [this](bool on) { emit edited([on](SurfaceFamily& look) { look.fade = on; }, 0); });
}

void FamilyRow::addLook(QWidget& panel, const QString& title) {
  auto* colour = new QToolButton(&panel);
  colour->setObjectName(idOf(family_, "colour"));
  colour->setAutoRaise(true);
  colour->setAccessibleName(tr("Colour of %1").arg(title));
  colour->setToolTip(tr("Another colour; the usual one suits the background"));
  connect(colour, &QToolButton::clicked, this, &FamilyRow::colourWanted);
  colour_ = colour;
  width_ = new QDoubleSpinBox(&panel);
  width_->setObjectName(idOf(family_, "width"));
  width_->setRange(0.2, kMostWidth);
  width_->setDecimals(1);
  width_->setSingleStep(0.2);
  width_->setKeyboardTracking(false);
  width_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  width_->setAccessibleName(tr("Width of %1").arg(title));
  width_->setToolTip(tr("Width in pixels"));
  connect(width_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    emit edited([value](SurfaceFamily& look) { look.widthPx = value; }, 0);
  });
}

void FamilyRow::addTo(QGridLayout& grid, int line) {
  for (int i = 0; i < kColumns; ++i) {
    if (QWidget* widget = part(i)) grid.addWidget(widget, line, i);
  }
  if (!slider_) return;
  auto* below = new QHBoxLayout;
  below->addSpacing(on_->style()->pixelMetric(QStyle::PM_IndicatorWidth) +
                    on_->style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing));
  below->addWidget(slider_);
  grid.addLayout(below, line + 1, 0, 1, kColumns);
}

void FamilyRow::show(const SurfaceFamily& look, Palette palette) {
  const QSignalBlocker on(on_), width(width_);
  on_->setChecked(look.on);
  width_->setValue(look.widthPx);
  colour_->setIcon(colourIcon(colourOf(look, palette)));
  if (!slider_) return;
  const QSignalBlocker slider(slider_), threshold(threshold_), fade(fade_);
  slider_->setValue(sliderAt(*look.threshold));
  threshold_->setValue(*look.threshold);
  fade_->setChecked(look.fade);
}

void FamilyRow::fitFields() {
  const QFontMetrics metrics = width_->fontMetrics();
  if (threshold_) {
    threshold_->setFixedWidth(metrics.horizontalAdvance("00.00") + kFieldFramePx);
  }
  width_->setFixedWidth(metrics.horizontalAdvance("12.0") + kFieldFramePx);
}

QWidget* FamilyRow::part(int column) const {
  switch (column) {
    case kName:
      return on_;
    case kNumber:
      return threshold_;
    case kColour:
      return colour_;
    case kWidth:
      return width_;
    default:
      return fade_;
  }
}

}  // namespace flatland::ui
