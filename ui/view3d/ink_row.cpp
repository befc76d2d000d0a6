// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/ink_row.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/commands/scene_commands.h"
#include "ui/view3d/picture_legend.h"

namespace flatland::ui {

namespace {

constexpr double kUsualPercent = 4.0;
constexpr double kLeastPercent = 0.1, kMostPercent = 50.0;

}  // namespace

InkRow::InkRow(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      on_(new QCheckBox(tr("&Equal ink"), this)),
      share_(new QDoubleSpinBox(this)),
      missed_(new QLabel(this)) {
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
  missed_->setObjectName("families.ink.missed");
  missed_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->addWidget(on_);
  row->addWidget(share_);
  row->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addLayout(row);
  layout->addWidget(missed_);
  connect(on_, &QCheckBox::toggled, this,
          [this](bool on) { edit(on ? std::optional(share_->value() / 100.0) : std::nullopt); });
  connect(share_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
    if (on_->isChecked()) edit(percent / 100.0);
  });
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showSetting();
  });
  connect(&models_.views.ink(), &InkSource::changed, this, &InkRow::showMissed);
  showSetting();
}

void InkRow::showMissed() {
  const auto& setting = models_.document.scene().surface;
  QStringList lines;
  for (std::size_t pane = 0; setting && setting->ink && pane < models_.views.count(); ++pane) {
    const PaneInk* ink = models_.views.ink().of(pane);
    if (!ink || ink->reached) continue;
    const QString share = percentWords(ink->share);
    const QString line = ink->share < *setting->ink
                             ? tr("All lines of these families give %1 % only.").arg(share)
                             : tr("Lines that have no threshold give %1 % already.").arg(share);
    lines << (models_.views.count() > 1 ? tr("View %1: %2").arg(pane + 1).arg(line) : line);
  }
  missed_->setText(lines.join('\n'));
  missed_->setVisible(!lines.isEmpty());
}

void InkRow::showSetting() {
  const auto& setting = models_.document.scene().surface;
  const std::optional<double> ink = setting ? setting->ink : std::nullopt;
  const QSignalBlocker on(on_), share(share_);
  on_->setChecked(ink.has_value());
  share_->setEnabled(ink.has_value());
  if (ink) share_->setValue(100.0 * *ink);
  showMissed();
}

void InkRow::edit(const std::optional<double>& share) {
  std::optional<SurfaceSetting> setting = models_.document.scene().surface;
  if (!setting) return;
  setting->ink = share;
  models_.document.push(
      std::make_unique<SetSurface>(models_.document, std::move(setting), tr("change ink")));
}

}  // namespace flatland::ui
