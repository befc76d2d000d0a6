// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/view_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <cmath>

#include "ui/commands/scene_commands.h"

namespace flatland::ui {

namespace {

constexpr int kAngleDecimals = 2;
constexpr double kLargestDistance = 1e12;

QDoubleSpinBox* numberBox(const QString& name, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setKeyboardTracking(false);  // a number counts when it is typed to its end
  box->setLocale(QLocale::c());
  box->setAlignment(Qt::AlignRight);
  return box;
}

}  // namespace

ViewPanel::ViewPanel(Document& document, const Stage& stage, QWidget* parent)
    : QWidget(parent), document_(document), stage_(stage) {
  angle_ = numberBox("view.angle", this);
  angle_->setDecimals(kAngleDecimals);
  angle_->setRange(-360.0, 360.0);
  angle_->setSuffix(QStringLiteral("°"));
  angle_->setToolTip(
      tr("Direction from the curve to the viewer, counter-clockwise from the right"));
  auto* angleLabel = new QLabel(tr("&Angle"), this);
  angleLabel->setBuddy(angle_);

  perspective_ = new QCheckBox(tr("&Perspective"), this);
  perspective_->setObjectName("view.perspective");
  perspective_->setToolTip(tr("The viewer stands at a distance; off: infinitely far away"));
  distance_ = numberBox("view.distance", this);
  distance_->setMinimumWidth(angle_->sizeHint().width());
  distance_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  distance_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  distance_->setToolTip(tr("Distance of the viewer from the origin, in scene lengths"));
  distance_->setAccessibleName(tr("Distance of the viewer"));

  auto* grid = new QGridLayout(this);
  grid->setVerticalSpacing(4);
  grid->setContentsMargins(9, 4, 9, 4);
  grid->addWidget(angleLabel, 0, 0);
  grid->addWidget(angle_, 0, 1);
  auto* quarters = new QHBoxLayout;
  quarters->setSpacing(4);
  for (const int degrees : {0, 90, 180, 270}) {
    auto* button = new QPushButton(tr("%1°").arg(degrees), this);
    button->setObjectName(QStringLiteral("view.angle.%1").arg(degrees));
    button->setToolTip(tr("View from %1°").arg(degrees));
    button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) + 16);
    connect(button, &QPushButton::clicked, this, [this, degrees] { typeAngle(degrees); });
    quarters->addWidget(button);
  }
  grid->addLayout(quarters, 1, 0, 1, 2);
  grid->addWidget(perspective_, 2, 0);
  grid->addWidget(distance_, 2, 1);
  grid->setColumnStretch(1, 1);
  grid->setRowStretch(3, 1);
  setFocusProxy(angle_);

  showView();
  connect(angle_, &QDoubleSpinBox::valueChanged, this, &ViewPanel::typeAngle);
  connect(distance_, &QDoubleSpinBox::valueChanged, this, &ViewPanel::typeDistance);
  connect(perspective_, &QCheckBox::toggled, this, &ViewPanel::setPerspective);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.what == Change::What::View || change.what == Change::What::Scene) showView();
  });
}

void ViewPanel::showView() {
  // The boxes round to the digits they show; what they were merely shown must not come back as an
  // edit, so they are silent here.
  const QSignalBlocker angleSilent(angle_);
  const QSignalBlocker distanceSilent(distance_);
  const View& view = document_.scene().view;
  angle_->setValue(normalizedDeg(view.angleDeg));
  perspective_->setChecked(view.distance.has_value());
  distance_->setEnabled(view.distance.has_value());
  const int decimals = stage_.distanceDecimals();
  distance_->setDecimals(decimals);
  distance_->setRange(std::pow(10.0, -decimals), kLargestDistance);
  distance_->setValue(view.distance ? *view.distance : stage_.suggestedDistance());
}

void ViewPanel::typeAngle(double angleDeg) {
  View view = document_.scene().view;
  view.angleDeg = normalizedDeg(angleDeg);
  set(view);
  showView();  // 270 is shown as -90, also when nothing changed
}

void ViewPanel::typeDistance(double distance) {
  View view = document_.scene().view;
  view.distance = distance;
  set(view);
}

void ViewPanel::setPerspective(bool on) {
  View view = document_.scene().view;
  if (view.distance.has_value() == on) return;
  view.distance = on ? std::optional(stage_.suggestedDistance()) : std::nullopt;
  set(view);
}

void ViewPanel::set(const View& view) {
  document_.push(std::make_unique<SetView>(document_, view));
}

}  // namespace flatland::ui
