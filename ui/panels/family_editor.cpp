// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/family_editor.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>

#include "flatland/study/bifurcation.h"
#include "ui/commands/curve_commands.h"
#include "ui/model/core_words.h"
#include "ui/panels/marked_slider.h"

namespace flatland::ui {

namespace {

constexpr int kSteps = 1000;
constexpr int kDecimals = 4;

int stepsOf(const FamilyParameter& parameter) {
  return parameter.whole ? static_cast<int>(parameter.high - parameter.low) : kSteps;
}

int stepAt(const FamilyParameter& parameter, double value) {
  const double share = (value - parameter.low) / (parameter.high - parameter.low);
  return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * stepsOf(parameter)));
}

/// Rounded to the digits the number box shows, so that both agree.
double valueAt(const FamilyParameter& parameter, int step) {
  const double unit = std::pow(10.0, kDecimals);
  const double value = parameter.low + (parameter.high - parameter.low) * step / stepsOf(parameter);
  return std::round(value * unit) / unit;
}

}  // namespace

FamilyEditor::FamilyEditor(Document& document, std::size_t curve, QWidget* parent)
    : QWidget(parent), document_(document), curve_(curve) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  const Family& family = familyOf(*shape().family());
  auto* formula = new QLabel(QString::fromStdString(family.formula), this);
  formula->setObjectName("curve.formula");
  formula->setTextInteractionFlags(Qt::TextSelectableByMouse);
  formula->setWordWrap(true);
  grid->addWidget(formula, 0, 0, 1, 3);
  for (std::size_t i = 0; i < family.parameters.size(); ++i) addRow(i);
  note_ = new QLabel(this);
  note_->setObjectName("curve.note");
  note_->setWordWrap(true);
  grid->addWidget(note_, grid->rowCount(), 0, 1, 3);
  grid->setColumnStretch(1, 1);
  refresh();
}

const FormulaCurve& FamilyEditor::shape() const {
  return std::get<FormulaCurve>(document_.scene().curves[curve_].shape);
}

void FamilyEditor::addRow(std::size_t index) {
  const FamilyParameter& parameter = familyOf(*shape().family()).parameters[index];
  const QString id = QString::fromStdString(parameter.id);
  const QString meaning = coreWords(parameter.meaning);
  auto* grid = static_cast<QGridLayout*>(layout());
  const int row = grid->rowCount();

  auto* slider = new MarkedSlider(this);
  slider->setObjectName("curve.slider." + id);
  slider->setRange(0, stepsOf(parameter));
  slider->setPageStep(std::max(1, stepsOf(parameter) / 20));
  auto* number = new QDoubleSpinBox(this);
  number->setObjectName("curve.number." + id);
  number->setKeyboardTracking(false);  // a number counts when it is typed to its end
  number->setLocale(QLocale::c());
  number->setDecimals(parameter.whole ? 0 : kDecimals);
  number->setRange(parameter.least, parameter.most);
  number->setSingleStep(parameter.whole ? 1.0 : 0.05);
  number->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  number->setFixedWidth(number->fontMetrics().horizontalAdvance(QStringLiteral("00000.0000")) + 24);
  for (QWidget* widget : {static_cast<QWidget*>(slider), static_cast<QWidget*>(number)}) {
    widget->setToolTip(meaning);
    widget->setAccessibleName(meaning);
  }
  auto* label = new QLabel(id, this);
  label->setToolTip(meaning);
  label->setBuddy(number);
  grid->addWidget(label, row, 0);
  grid->addWidget(slider, row, 1);
  grid->addWidget(number, row, 2);
  rows_.push_back({slider, number});

  connect(slider, &QSlider::sliderPressed, this, [this] { gesture_ = document_.newGesture(); });
  connect(slider, &QSlider::sliderReleased, this, [this] { gesture_ = kNoGesture; });
  connect(slider, &QSlider::valueChanged, this, [this, index](int step) {
    const FamilyParameter& moved = familyOf(*shape().family()).parameters[index];
    set(index, valueAt(moved, step), gesture_);
  });
  connect(number, &QDoubleSpinBox::valueChanged, this,
          [this, index](double value) { set(index, value, kNoGesture); });
}

void FamilyEditor::set(std::size_t index, double value, int gesture) {
  FamilyCurve changed = *shape().family();
  changed.parameters[index] = value;
  const FormulaCurve::Result result = FormulaCurve::make(changed, shape().at());
  if (!result.curve) {
    emit refused(coreWords(result.error.reason));
    refresh();
    return;
  }
  document_.push(std::make_unique<ReplaceCurve>(document_, curve_, *result.curve,
                                                tr("change parameter"), gesture));
}

void FamilyEditor::refresh() {
  // The boxes and sliders round; what they were merely shown must not come back as an edit.
  const FamilyCurve& curve = *shape().family();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const FamilyParameter& parameter = familyOf(curve).parameters[i];
    const QSignalBlocker sliderSilent(rows_[i].slider);
    const QSignalBlocker numberSilent(rows_[i].number);
    rows_[i].slider->setValue(stepAt(parameter, curve.parameters[i]));
    rows_[i].number->setValue(curve.parameters[i]);
  }
  showNote();
}

void FamilyEditor::showNote() {
  const FamilyCurve& curve = *shape().family();
  const auto bifurcation = bifurcationOf(curve);
  note_->setVisible(bifurcation.has_value());
  if (!bifurcation) return;
  const double a = curve.parameters[0], b = curve.parameters[1];
  const FamilyParameter& parameter = familyOf(curve).parameters[bifurcation->parameter];
  const bool inRange = bifurcation->value >= parameter.low && bifurcation->value <= parameter.high;
  rows_[bifurcation->parameter].slider->setMark(
      inRange ? std::optional(stepAt(parameter, bifurcation->value)) : std::nullopt);
  note_->setText(
      tr("b/a = %1. The triangle marks b/a = \u221a(3/2) = 1.2247: seen along y, the tip that "
         "faces "
         "the viewer is an apparent ridge only above it; below, lambda has a minimum there.")
          .arg(b / a, 0, 'f', 4));
}

}  // namespace flatland::ui
