// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/legend_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPalette>

#include "ui/export/figure_qt.h"
#include "ui/model/mark_words.h"
#include "ui/model/theme.h"
#include "ui/panels/mark_icon.h"

namespace flatland::ui {

namespace {

QString idOf(MarkKind kind) {
  const std::string_view name = nameOf(kind);
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

QLabel* letterLabel(MarkKind kind) {
  auto* label = new QLabel(QString(QLatin1Char(styleOf(kind).letter)));
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

}  // namespace

LegendPanel::LegendPanel(const Document& document, Display& display, QWidget* parent)
    : QWidget(parent), document_(document), display_(display) {
  auto* grid = new QGridLayout(this);
  grid->setVerticalSpacing(2);
  grid->setContentsMargins(9, 4, 9, 4);
  grid->setHorizontalSpacing(8);
  grid->setColumnStretch(0, 1);
  int row = 0;
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const auto i = static_cast<std::size_t>(kind);
    auto* box = new QCheckBox(pluralForPeople(kind), this);
    box->setObjectName("legend." + idOf(kind));
    box->setToolTip(explanation(kind));
    connect(box, &QCheckBox::toggled, this, [this, kind](bool on) { display_.setShows(kind, on); });
    switches_[i] = box;
    counts_[i] = new QLabel(this);
    counts_[i]->setObjectName("legend.count." + idOf(kind));
    counts_[i]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    counts_[i]->setMinimumWidth(counts_[i]->fontMetrics().horizontalAdvance("000"));
    grid->addWidget(box, row, 0);
    letters_[i] = letterLabel(kind);
    grid->addWidget(letters_[i], row, 1);
    grid->addWidget(counts_[i], row, 2);
    ++row;
  }
  hidden_ = new QCheckBox(tr("Hidden parts, paler"), this);
  hidden_->setObjectName("legend.hidden");
  hidden_->setToolTip(tr("Show what lies behind the curve as seen from the viewer"));
  connect(hidden_, &QCheckBox::toggled, &display_, &Display::setShowsHidden);
  grid->setRowMinimumHeight(row, 4);
  grid->addWidget(hidden_, row + 1, 0, 1, 3);
  grid->setRowStretch(row + 2, 1);

  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.touchesScene()) showCounts();
  });
  connect(&display_, &Display::changed, this, &LegendPanel::showSwitches);
  showColours();
  showCounts();
  showSwitches();
}

void LegendPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) showColours();
  QWidget::changeEvent(event);
}

void LegendPanel::showColours() {
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const auto i = static_cast<std::size_t>(kind);
    if (!letters_[i]) return;  // too early: under construction
    switches_[i]->setIcon(markIcon(kind));
    const int side = switches_[i]->fontMetrics().height();
    switches_[i]->setIconSize({side, side});
    QPalette palette;
    palette.setColor(QPalette::WindowText, toQColor(styleOf(kind, themePalette()).letterColour));
    letters_[i]->setPalette(palette);
  }
}

void LegendPanel::showCounts() {
  std::array<int, kMarkKindCount> counts{};
  for (const Mark& mark : document_.features().marks) ++counts[static_cast<std::size_t>(mark.kind)];
  for (std::size_t i = 0; i < counts.size(); ++i) counts_[i]->setText(QString::number(counts[i]));
}

void LegendPanel::showSwitches() {
  for (const MarkKind kind : markKindsInLegendOrder()) {
    switches_[static_cast<std::size_t>(kind)]->setChecked(display_.shows(kind));
  }
  hidden_->setChecked(display_.showsHidden());
}

}  // namespace flatland::ui
