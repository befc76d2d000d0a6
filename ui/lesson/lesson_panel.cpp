// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtMath>
#include <algorithm>

#include "ui/lesson/formula_view.h"
#include "ui/lesson/lesson_words.h"
#include "ui/panels/elided_label.h"
#include "ui/plot/step_size_plot.h"

namespace flatland::ui {

namespace {

// How words, equation and plot share the width.
constexpr int kWordsShare = 5;
constexpr int kEquationShare = 8;
constexpr int kPlotShare = 4;
constexpr double kEquationHeight = 200.0;  ///< formula, both sides and switches

QString wordsOf(const LessonStep& step) {
  return "**" + QString::fromStdString(step.title) + "**\n\n" + QString::fromStdString(step.text);
}

}  // namespace

LessonPanel::LessonPanel(LessonModel& lesson, Probe& probe, Display& display, QWidget* parent)
    : QWidget(parent), lesson_(lesson), probe_(probe), display_(display) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 2, 8, 4);
  layout->setSpacing(2);
  layout->addLayout(buildHeader());
  words_ = new QTextBrowser(this);
  words_->setObjectName("lesson.words");
  words_->setAccessibleName(tr("Words of the step"));
  words_->setToolTip(tr("What the step says"));
  words_->setFrameShape(QFrame::NoFrame);
  words_->setOpenLinks(false);
  words_->viewport()->setAutoFillBackground(false);
  // The strip is as high as wantedHeight() says, or as the person makes it.
  words_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  equation_ = new QWidget(this);
  equation_->setLayout(buildEquation());
  plot_ = new StepSizePlot(this);
  auto* row = new QHBoxLayout;
  row->addWidget(words_, kWordsShare);
  row->addWidget(equation_, kEquationShare);
  row->addWidget(plot_, kPlotShare);
  layout->addLayout(row, 1);
  misses_ = new ElidedLabel(this);
  misses_->setObjectName("lesson.misses");
  misses_->setAccessibleName(tr("How far the printed roots miss"));
  // Until there is a line to show; showMisses() puts the roots one by one here.
  misses_->setToolTip(misses_->accessibleName());
  layout->addWidget(misses_);

  connect(&lesson_, &LessonModel::changed, this, &LessonPanel::showStep);
  connect(&probe_, &Probe::changed, this, &LessonPanel::showValues);
  connect(&display_, &Display::changed, this, &LessonPanel::showSwitches);
  showStep();
}

QToolButton* LessonPanel::addButton(const char* id, const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(id);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to what is looked at
  return button;
}

QLayout* LessonPanel::buildHeader() {
  auto* row = new QHBoxLayout;
  title_ = new QLabel(this);
  title_->setObjectName("lesson.title");
  row->addWidget(title_, 1);
  first_ = addButton("lesson.first", QStringLiteral("|◀"), tr("First step (Home)"));
  back_ = addButton("lesson.back", QStringLiteral("◀"), tr("Step back (Page Up)"));
  next_ = addButton("lesson.next", QStringLiteral("▶"), tr("Next step (Page Down)"));
  stop_ = addButton("lesson.next-stop", QStringLiteral("▶|"),
                    tr("On to the next stop (Shift + Page Down)"));
  again_ = addButton("lesson.again", QStringLiteral("↺"), tr("The scene of this step again"));
  leave_ = addButton("lesson.leave", tr("Leave"), tr("Leave the lesson: back to your own scene"));
  connect(first_, &QToolButton::clicked, &lesson_, &LessonModel::first);
  connect(back_, &QToolButton::clicked, &lesson_, &LessonModel::back);
  connect(next_, &QToolButton::clicked, &lesson_, &LessonModel::next);
  connect(stop_, &QToolButton::clicked, &lesson_, &LessonModel::nextStop);
  connect(again_, &QToolButton::clicked, &lesson_, &LessonModel::showAgain);
  connect(leave_, &QToolButton::clicked, &lesson_, &LessonModel::leave);
  for (QToolButton* button : {first_, back_, next_, stop_, again_, leave_}) row->addWidget(button);
  return row;
}

QLayout* LessonPanel::buildEquation() {
  auto* column = new QVBoxLayout;
  column->setContentsMargins({});
  column->setSpacing(2);
  formula_ = new FormulaView(this);
  formula_->setObjectName("lesson.formula");
  column->addWidget(formula_, 1);
  values_ = new QLabel(this);
  values_->setObjectName("lesson.values");
  values_->setAccessibleName(tr("Values"));
  values_->setToolTip(
      tr("The values of both sides at the probe, and their difference from the digits shown"));
  values_->setTextFormat(Qt::RichText);
  values_->setWordWrap(true);  // else it takes the room of the words
  values_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(values_);
  auto* row = new QHBoxLayout;
  printed_ = addButton("lesson.printed", tr("As printed"), tr("The equation as the thesis has it"));
  corrected_ = addButton("lesson.corrected", tr("Corrected"), tr("The equation as it should be"));
  for (QToolButton* button : {printed_, corrected_}) {
    button->setCheckable(true);
    row->addWidget(button);
  }
  connect(printed_, &QToolButton::clicked, this, [this] {
    lesson_.setPrinted(true);
    showSwitches();
  });
  connect(corrected_, &QToolButton::clicked, this, [this] {
    lesson_.setPrinted(false);
    showSwitches();
  });
  roots_ = new QCheckBox(tr("Printed roots on the curve"), this);
  roots_->setObjectName("lesson.printed-roots");
  roots_->setToolTip(tr("Where (3.13) as printed would put apparent ridges: hollow and dashed"));
  connect(roots_, &QCheckBox::toggled, &display_, &Display::setShowsPrintedRoots);
  row->addWidget(roots_);
  row->addStretch(1);
  column->addLayout(row);
  return column;
}

int LessonPanel::wantedHeight() const {
  if (!lesson_.isOpen()) return sizeHint().height();
  const bool withEquation = lesson_.equation().has_value();
  const QMargins margins = layout()->contentsMargins();
  int room = width() - margins.left() - margins.right();
  if (withEquation) {
    room -= 2 * layout()->spacing();  // between words, equation and plot
    room = room * kWordsShare / (kWordsShare + kEquationShare + kPlotShare);
  }
  QTextDocument words;
  words.setDefaultFont(words_->font());
  words.setTextWidth(room);
  double highest = withEquation ? kEquationHeight * display_.uiScale() : 0.0;
  bool hasMisses = false;
  for (const LessonStep& step : lesson_.lesson().steps) {
    if (step.state.equation.has_value() != withEquation) continue;
    hasMisses |= step.state.equation == DerivationStep::Eq3_13;
    words.setMarkdown(wordsOf(step));
    highest = std::max(highest, words.size().height());
  }
  const int header = leave_->sizeHint().height() + layout()->spacing();
  const int misses = hasMisses ? layout()->spacing() + misses_->sizeHint().height() : 0;
  return margins.top() + header + qCeil(highest) + misses + margins.bottom();
}

void LessonPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (event->oldSize().width() != width()) emit heightWanted();
}

void LessonPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) emit heightWanted();
}

void LessonPanel::showStep() {
  const bool open = lesson_.isOpen();
  const auto equation = lesson_.equation();
  if (open) {
    const LessonStep& step = lesson_.step();
    title_->setText(tr("<b>Step %1 of %2</b>%3")
                        .arg(lesson_.index() + 1)
                        .arg(lesson_.count())
                        .arg(lesson_.isUndone() ? tr(" · undone: your own scene")
                             : step.stop        ? tr(" · stop")
                                                : QString()));
    words_->setMarkdown(wordsOf(step));
  } else {
    title_->setText(tr("No lesson is open"));
    words_->setMarkdown(tr("The **Lesson** menu has four, and opens your own."));
  }
  first_->setEnabled(open && lesson_.index() > 0);
  back_->setEnabled(open && lesson_.index() > 0);
  next_->setEnabled(open && lesson_.index() + 1 < lesson_.count());
  stop_->setEnabled(open && lesson_.hasNextStop());
  again_->setEnabled(open);
  leave_->setEnabled(open);
  equation_->setVisible(equation.has_value());
  plot_->setVisible(equation.has_value() && !textOf(*equation).step.empty());
  formula_->show(equation, lesson_.isPrinted());
  showSwitches();
  showValues();
}

void LessonPanel::showSwitches() {
  const auto equation = lesson_.equation();
  const bool misprinted = equation && textOf(*equation).isMisprinted();
  printed_->setVisible(misprinted);
  corrected_->setVisible(misprinted);
  printed_->setChecked(lesson_.isPrinted());
  corrected_->setChecked(!lesson_.isPrinted());
  roots_->setVisible(equation == DerivationStep::Eq3_13);
  roots_->setChecked(display_.showsPrintedRoots());
  showMisses();
}

void LessonPanel::showMisses() {
  const bool shown = lesson_.equation() == DerivationStep::Eq3_13 && display_.showsPrintedRoots();
  misses_->setVisible(shown);
  if (!shown) return;
  const QString line = missesForPeople(lesson_.printedRoots());
  misses_->setText(line);
  misses_->setToolTip(line + "\n" + eachMissForPeople(lesson_.printedRoots()));
}

void LessonPanel::showValues() {
  const auto equation = lesson_.equation();
  if (!equation) return;
  showMisses();
  const QString values = valuesForPeople(textOf(*equation), lesson_.reading(), lesson_.isPrinted());
  values_->setText(values);
  const std::string_view step = textOf(*equation).step;
  plot_->show(lesson_.sweep(), QString::fromUtf8(step.data(), static_cast<qsizetype>(step.size())));
}

}  // namespace flatland::ui
