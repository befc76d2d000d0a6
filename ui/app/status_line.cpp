// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/status_line.h"

#include <QLabel>
#include <QStatusBar>
#include <algorithm>
#include <cmath>

namespace flatland::ui {

namespace {

constexpr int kSayMilliseconds = 6000;

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, const Document& document)
    : QObject(&bar), bar_(bar), document_(document), hint_(new QLabel(&bar)) {
  hint_->setObjectName("status.hint");
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // never widens the window
  bar.addWidget(hint_, 1);
  pointer_ = addField("status.pointer", "-000.0000, -000.0000", tr("Where the pointer is"));
  view_ = addField("status.view", tr("View %1").arg("-000.0°, 0000.00"),
                   tr("Direction, and in perspective distance, of the viewer"));
  marks_ = addField("status.marks", tr("all %1 marks certified").arg("000"),
                    tr("Whether every mark was found and none invented, with certified signs"));
  time_ =
      addField("status.time", tr("%1 ms").arg("000.00"), tr("Time of the last search for marks"));
  connect(&document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesScene()) showScene();
  });
  showScene();
}

QLabel* StatusLine::addField(const char* id, const QString& widest, const QString& tip) {
  auto* label = new QLabel(&bar_);
  label->setObjectName(id);
  label->setToolTip(tip);
  label->setAlignment(Qt::AlignCenter);
  label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
  bar_.addPermanentWidget(label);
  return label;
}

void StatusLine::showHint(const QString& text) { hint_->setText(text); }

void StatusLine::say(const QString& text) { bar_.showMessage(text, kSayMilliseconds); }

void StatusLine::showPointer(const std::optional<Vec2>& world, double scale) {
  if (!world) {
    pointer_->clear();
    return;
  }
  const int decimals = std::clamp(static_cast<int>(std::ceil(std::log10(scale))), 0, 12);
  pointer_->setText(
      QStringLiteral("%1, %2").arg(world->x(), 0, 'f', decimals).arg(world->y(), 0, 'f', decimals));
}

void StatusLine::showScene() {
  const FeatureSet& features = document_.features();
  const View& view = document_.scene().view;
  const QString angle = tr("%1°").arg(normalizedDeg(view.angleDeg), 0, 'f', 1);
  view_->setText(view.distance ? tr("View %1, %2").arg(angle).arg(*view.distance, 0, 'g', 6)
                               : tr("View %1").arg(angle));
  marks_->setText(features.complete() ? tr("all %1 marks certified").arg(features.marks.size())
                                      : tr("%1 marks, %2 places unresolved")
                                            .arg(features.marks.size())
                                            .arg(features.unresolved.size()));
  time_->setText(tr("%1 ms").arg(document_.featureMilliseconds(), 0, 'f', 2));
}

}  // namespace flatland::ui
