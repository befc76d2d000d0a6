// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/ink_row.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "ui/commands/scene_commands.h"

namespace flatland::ui {

namespace {

constexpr double kUsualPercent = 4.0;
constexpr double kLeastPercent = 0.1, kMostPercent = 50.0;

}  // namespace

InkRow::InkRow(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      on_(new QCheckBox(tr("&Equal ink"), this)),
      share_(new QDoubleSpinBox(this)) {
  on_->setObjectName("families.ink");
  on_->setToolTip(
      tr("In every view one factor on the thresholds is solved for, so that its drawing covers "
         "this share of the paper"));
  share_->setObjectName("families.ink.share");
  share_->setAccessibleName(tr("Ink in per cent"));
  share_->setToolTip(tr("Share of the paper that the strokes of a view cover"));
  share_->setRange(kLeastPercent, kMostPercent);
  share_->setDecimals(1);
  share_->setSingleStep(0.5);
  share_->setSuffix(QStringLiteral(" %"));
  share_->setKeyboardTracking(false);
  share_->setValue(kUsualPercent);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins({});
  layout->addWidget(on_);
  layout->addWidget(share_);
  layout->addStretch(1);
  connect(on_, &QCheckBox::toggled, this,
          [this](bool on) { edit(on ? std::optional(share_->value() / 100.0) : std::nullopt); });
  connect(share_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
    if (on_->isChecked()) edit(percent / 100.0);
  });
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showSetting();
  });
  showSetting();
}

void InkRow::showSetting() {
  const auto& setting = models_.document.scene().surface;
  const std::optional<double> ink = setting ? setting->ink : std::nullopt;
  const QSignalBlocker on(on_), share(share_);
  on_->setChecked(ink.has_value());
  share_->setEnabled(ink.has_value());
  if (ink) share_->setValue(100.0 * *ink);
}

void InkRow::edit(const std::optional<double>& share) {
  std::optional<SurfaceSetting> setting = models_.document.scene().surface;
  if (!setting) return;
  setting->ink = share;
  models_.document.push(
      std::make_unique<SetSurface>(models_.document, std::move(setting), tr("change ink")));
}

}  // namespace flatland::ui
