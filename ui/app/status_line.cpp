// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/status_line.h"

#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"
#include "ui/model/core_words.h"
#include "ui/model/mark_words.h"
#include "ui/panels/elided_label.h"

namespace flatland::ui {

namespace {

constexpr int kSayMilliseconds = 6000;
constexpr std::size_t kPlacesListed = 30;

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, const Document& document)
    : QObject(&bar), bar_(bar), document_(document), hint_(new ElidedLabel(&bar)) {
  hint_->setObjectName("status.hint");
  bar.addWidget(hint_, 1);
  // The bar itself hides only what is visible at that moment: what is said before it is shown would
  // stand across the hint.
  connect(&bar, &QStatusBar::messageChanged, hint_,
          [this](const QString& message) { hint_->setVisible(message.isEmpty()); });
  pointer_ = addField("status.pointer", tr("Where the pointer is"));
  view_ = addField("status.view", tr("Direction, and in perspective distance, of the viewer"));
  marks_ = new QToolButton(&bar);
  marks_->setObjectName("status.marks");
  marks_->setAutoRaise(true);
  marks_->setToolTip(
      tr("Whether every mark was found and none invented, with certified signs, or on a "
         "curve of formulas within an error. A click lists the places where that could not be "
         "decided."));
  places_ = new QMenu(marks_);
  places_->setObjectName("status.places");
  connect(places_, &QMenu::aboutToShow, this, &StatusLine::listPlaces);
  marks_->setMenu(places_);
  marks_->setPopupMode(QToolButton::InstantPopup);
  bar.addPermanentWidget(marks_);
  time_ = addField("status.time", tr("Time of the last search for marks"));
  fitFields();
  bar.installEventFilter(this);
  connect(&document, &Document::changed, this, &StatusLine::changed);
  watchSides(false);
  showScene();
}

QLabel* StatusLine::addField(const char* id, const QString& tip) {
  auto* label = new QLabel(&bar_);
  label->setObjectName(id);
  label->setToolTip(tip);
  label->setAlignment(Qt::AlignCenter);
  bar_.addPermanentWidget(label);
  return label;
}

void StatusLine::fitFields() {
  const QFontMetrics metrics = bar_.fontMetrics();
  const auto fit = [&metrics](QWidget* field, const QString& widest) {
    field->setMinimumWidth(metrics.horizontalAdvance(widest) + 8);
  };
  fit(pointer_, "-000.0000, -000.0000");
  fit(view_, tr("View %1").arg("-000.0°, 0000.00"));
  fit(marks_, tr("all %n marks certified", nullptr, 100));
  fit(time_, tr("%1 ms").arg("000.00"));
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FontChange) fitFields();
  return QObject::eventFilter(watched, event);
}

void StatusLine::setFewFields(bool few) {
  few_ = few;
  showFields();
}

void StatusLine::showFields() {
  // All are of the curves; of no curve at all there is nothing to boast of.
  const bool curves = !document_.scene().curves.empty();
  pointer_->setVisible(!few_);
  view_->setVisible(!few_ && curves);
  time_->setVisible(!few_ && curves);
  marks_->setVisible(curves);
}

void StatusLine::showHint(const QString& text) {
  hint_->setText(text);
  hint_->setToolTip(text);
}

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

void StatusLine::changed(const Change& change) {
  if (!change.touchesScene()) return;
  watchSides(change.what == Change::What::View);
  showScene();
}

void StatusLine::watchSides(bool onlyTheViewTurned) {
  std::vector<int> sides = normalSides(document_.scene());
  const bool exchanged = onlyTheViewTurned && sides != sides_;
  sides_ = std::move(sides);
  if (exchanged) {
    say(
        tr("Ridges and valleys exchange names: the viewer has passed the line through the ends of "
           "the curve and sees its other side."));
  }
}

void StatusLine::showScene() {
  const FeatureSet& features = document_.features();
  const View& view = document_.scene().view;
  const QString angle = tr("%1°").arg(normalizedDeg(view.angleDeg), 0, 'f', 1);
  view_->setText(view.distance ? tr("View %1, %2").arg(angle).arg(*view.distance, 0, 'g', 6)
                               : tr("View %1").arg(angle));
  const int marks = static_cast<int>(features.marks.size());
  const int places = static_cast<int>(features.unresolved.size());
  if (!features.complete()) {
    marks_->setText(tr("%n places unresolved", nullptr, places));
  } else if (features.certified()) {
    marks_->setText(tr("all %n marks certified", nullptr, marks));
  } else {
    const QString bound = QString::number(features.errorBound(), 'e', 0);
    marks_->setText(tr("all %n marks found to %1", nullptr, marks).arg(bound));
  }
  marks_->setAccessibleName(marks_->text());
  time_->setText(tr("%1 ms").arg(document_.featureMilliseconds(), 0, 'f', 2));
  showFields();
}

void StatusLine::listPlaces() {
  places_->clear();
  const std::vector<Unresolved>& unresolved = document_.features().unresolved;
  if (unresolved.empty()) {
    const FeatureSet& found = document_.features();
    places_
        ->addAction(found.certified()
                        ? tr("Every mark was found and none is invented: nothing is left open.")
                        : tr("Nothing is left open, to an estimated error of %1; what is narrower "
                             "than the samples may be missed.")
                              .arg(found.errorBound(), 0, 'g', 2))
        ->setEnabled(false);
  }
  for (std::size_t i = 0; i < std::min(unresolved.size(), kPlacesListed); ++i) {
    const Unresolved& place = unresolved[i];
    QAction* action = places_->addAction(
        tr("%1, curve %2, t from %3 to %4: %5")
            .arg(nameForPeople(place.kind))
            .arg(place.curve)
            .arg(place.tLow, 0, 'g', 8)
            .arg(place.tHigh, 0, 'g', 8)
            .arg(coreWords(place.reason)),
        this, [this, curve = place.curve, t = 0.5 * (place.tLow + place.tHigh)] {
          const auto& curves = document_.scene().curves;
          if (static_cast<std::size_t>(curve) >= curves.size()) return;
          emit placePicked(pointAt(curves[static_cast<std::size_t>(curve)].shape, t));
        });
    action->setToolTip(tr("Bring the place to the middle of the canvas"));
  }
  if (unresolved.size() > kPlacesListed) {
    places_
        ->addAction(tr("and %n more", nullptr, static_cast<int>(unresolved.size() - kPlacesListed)))
        ->setEnabled(false);
  }
}

}  // namespace flatland::ui
