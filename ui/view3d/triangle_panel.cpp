// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/triangle_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/lesson/lesson_words.h"
#include "ui/view3d/pane_marks.h"

namespace flatland::ui {

namespace {

constexpr int kNone = -1;  ///< no triangle is picked

/// What the filters say.
QString filteredVerdict(const TriangleLesson& lesson) {
  QString sentence;
  switch (lesson.verdict) {
    case RidgeVerdict::UnknownNormal:
      return TrianglePanel::tr("Dropped: a normal is unknown.");
    case RidgeVerdict::Creased:
      return TrianglePanel::tr(
          "Dropped: a sharp edge parts the surface here, and is itself the line.");
    case RidgeVerdict::NoCrossing:
      return TrianglePanel::tr("Nothing here: all three directions agree.");
    case RidgeVerdict::TurnedAway:
      return TrianglePanel::tr("Dropped: a corner is turned away.");
    case RidgeVerdict::SingularPoint:
      return TrianglePanel::tr(
          "Dropped: one edge alone is crossed; t_A has a singular point here.");
    case RidgeVerdict::DirectionsTurn:
      return TrianglePanel::tr("Dropped: t_A turns too far from corner to corner.");
    case RidgeVerdict::Weak:
      return TrianglePanel::tr("Dropped: √λ is below the threshold %1.")
          .arg(numberForPeople(lesson.threshold));
    case RidgeVerdict::Minimum:
      return TrianglePanel::tr(
          "Dropped: a direction points away from the line, so it is a minimum.");
    case RidgeVerdict::Flat:
      sentence = TrianglePanel::tr("A maximum, but λ hardly falls beside it");
      break;
    case RidgeVerdict::Kept:
      sentence = TrianglePanel::tr("A maximum: all directions point towards the line");
      break;
  }
  if (lesson.followsNeighbour()) {
    return lesson.drawn ? TrianglePanel::tr("%1. Drawn, as the triangle before it on the line.")
                              .arg(sentence)
                        : TrianglePanel::tr("%1. Dropped, as the triangle before it on the line.")
                              .arg(sentence);
  }
  return lesson.verdict == RidgeVerdict::Kept ? TrianglePanel::tr("%1. Kept.").arg(sentence)
                                              : TrianglePanel::tr("%1. Dropped.").arg(sentence);
}

}  // namespace

QString verdictForPeople(const TriangleLesson& lesson) {
  const QString verdict = filteredVerdict(lesson);
  if (!lesson.unfiltered || !lesson.drawn || lesson.verdict == RidgeVerdict::Kept) return verdict;
  return TrianglePanel::tr("Drawn, as every crossing. The filters would say: %1").arg(verdict);
}

TrianglePanel::TrianglePanel(SurfaceStudy& study, const Display& display, QWidget* parent)
    : QWidget(parent),
      study_(study),
      triangle_(new QSpinBox(this)),
      view_(new TriangleView(display, this)),
      words_(new QLabel(this)),
      numbers_(new QLabel(this)) {
  setObjectName("triangle-panel");
  triangle_->setObjectName("triangle.number");
  triangle_->setToolTip(tr("The picked triangle; type a number to pick another"));
  triangle_->setKeyboardTracking(false);
  triangle_->setSpecialValueText(tr("none"));
  triangle_->setRange(kNone, kNone);
  connect(triangle_, &QSpinBox::valueChanged, this, [this](int value) {
    if (value == kNone) return study_.pick().pick(std::nullopt);
    study_.pick().pickTriangle(static_cast<std::uint32_t>(value));
  });
  auto* label = new QLabel(tr("Triangle"), this);
  label->setBuddy(triangle_);
  words_->setObjectName("triangle.words");
  words_->setAccessibleName(tr("What becomes of the triangle"));
  words_->setToolTip(words_->accessibleName());
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  numbers_->setObjectName("triangle.numbers");
  numbers_->setAccessibleName(tr("At the corners"));
  numbers_->setToolTip(
      tr("At each corner λ, its derivative along t_A on the screen, the same from its neighbours, "
         "and the cosine between t_A and the perpendicular; ↔: flipped"));
  numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(triangle_);
  row->addStretch(1);
  row->addWidget(stageButton(TriangleStage::Ring, QStringLiteral("a"),
                             tr("(a) Where λ is compared, to both sides along t_A")));
  row->addWidget(stageButton(TriangleStage::Directions, QStringLiteral("b"),
                             tr("(b) t_A, turned to where λ grows")));
  row->addWidget(stageButton(TriangleStage::Crossing, QStringLiteral("c"),
                             tr("(c) Where two directions disagree: crossings and the line")));
  row->addWidget(stageButton(TriangleStage::Perpendiculars, QStringLiteral("d"),
                             tr("(d) Perpendiculars: a maximum if all angles are acute")));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addLayout(row);
  layout->addWidget(words_);
  layout->addWidget(view_, 1);
  layout->addWidget(numbers_);
  connect(&study_, &SurfaceStudy::changed, this, &TrianglePanel::refresh);
  connect(&study_, &SurfaceStudy::lessonChanged, this, &TrianglePanel::refresh);
  refresh();
}

QToolButton* TrianglePanel::stageButton(TriangleStage stage, const QString& text,
                                        const QString& tip) {
  constexpr const char* kIds[] = {"triangle.ring", "triangle.directions", "triangle.crossing",
                                  "triangle.perpendiculars"};
  auto* button = new QToolButton(this);
  button->setObjectName(kIds[static_cast<std::size_t>(stage)]);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setCheckable(true);
  button->setChecked(view_->isShown(stage));
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the surface
  connect(button, &QToolButton::toggled, this,
          [this, stage](bool on) { view_->setShown(stage, on); });
  return button;
}

void TrianglePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  study_.setTriangleWanted(true);
  refresh();
}

void TrianglePanel::hideEvent(QHideEvent* event) {
  study_.setTriangleWanted(false);
  QWidget::hideEvent(event);
}

void TrianglePanel::refresh() {
  SurfacePick& pick = study_.pick();
  const QSignalBlocker blocker(triangle_);
  triangle_->setEnabled(pick.surface() != nullptr);
  if (pick.surface()) {
    triangle_->setRange(kNone, static_cast<int>(pick.surface()->mesh->triangleCount()) - 1);
  }
  triangle_->setValue(pick.hit() ? static_cast<int>(pick.hit()->triangle) : kNone);
  const auto& lesson = study_.lesson();
  if (!pick.hit() || !lesson) {
    view_->show(nullptr, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
    words_->setText(tr("Click a point of the surface, or press P over its picture."));
    numbers_->clear();
    return;
  }
  const Projection projection = study_.projection(1.0, 1.0);
  view_->show(lesson, projection.axes.row(0), projection.axes.row(1));
  const QString seenBy = seenByWords(study_.setting());
  words_->setText((seenBy.isEmpty() ? QString() : seenBy + ' ') + "<b>" +
                  verdictForPeople(*lesson).toHtmlEscaped() + "</b>");
  numbers_->setText(numbers(*lesson));
}

QString TrianglePanel::numbers(const TriangleLesson& lesson) const {
  // Room beside a number, so that none and no head runs into the next.
  QString rows = QStringLiteral(
                     "<tr><td></td><td>λ&nbsp;&nbsp;&nbsp;</"
                     "td><td>½&nbsp;D&nbsp;λ&nbsp;&nbsp;&nbsp;</td><td>%1&nbsp;&nbsp;&nbsp;"
                     "</td><td>%2</td></tr>")
                     .arg(tr("by neighbours"), tr("cos"));
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleLesson::Corner& corner = lesson.corners[k];
    QStringList cosines;
    for (const TriangleLesson::Piece& piece : lesson.pieces) {
      for (const auto& test : piece.tests) {
        if (test.corner == static_cast<int>(k)) cosines << QString::number(test.cosine, 'f', 2);
      }
    }
    rows += QStringLiteral(
                "<tr><td>%1&nbsp;&nbsp;&nbsp;</td><td>%2&nbsp;&nbsp;&nbsp;</"
                "td><td>%3&nbsp;&nbsp;&nbsp;</td><td>%4&nbsp;&nbsp;&nbsp;"
                "</td><td>%5</td></tr>")
                .arg(QString(QChar('A' + static_cast<int>(k))) + (corner.flipped ? "↔" : ""),
                     numberForPeople(corner.lambda), numberForPeople(corner.derivative),
                     numberForPeople(corner.ringDerivative), cosines.join(", "));
  }
  return "<table cellspacing='0' cellpadding='1'>" + rows + "</table>";
}

}  // namespace flatland::ui
