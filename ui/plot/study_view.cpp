// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/study_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOptionFocusRect>
#include <algorithm>

#include "ui/export/figure_qt.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"

namespace flatland::ui {

StudyView::StudyView(const StudySource& source, const Display& display, QWidget* parent)
    : QWidget(parent), source_(source), display_(display) {
  setObjectName("study.view");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Histogram of the study"));
  setToolTip(
      tr("Click a bar: show a curve of it on the canvas. Left, Right and Enter do the same"));
  connect(&source_, &StudySource::changed, this, qOverload<>(&QWidget::update));
  connect(&display_, &Display::changed, this, qOverload<>(&QWidget::update));
}

void StudyView::setDiagram(StudyDiagram diagram) {
  if (diagram == diagram_) return;
  diagram_ = diagram;
  select(std::nullopt);
  update();
}

void StudyView::setScale(double scale) {
  if (scale == scale_) return;
  scale_ = scale;
  update();
}

StudyFigureOptions StudyView::options() const {
  StudyFigureOptions options;
  options.width = width() / display_.uiScale();
  options.height = height() / display_.uiScale();
  options.diagram = diagram_;
  options.palette = themePalette();
  options.words = wordsOfTheWindow();
  options.scale = scale_;
  options.selectedBin = selected_;
  return options;
}

double StudyView::xOfBin(std::size_t bin) const {
  return display_.uiScale() * studyBinX(bin, options());
}

Figure StudyView::figureForFile() const {
  StudyFigureOptions forFile = options();
  forFile.width = StudyFigureOptions{}.width;
  forFile.height = StudyFigureOptions{}.height;
  forFile.palette = Palette::Light;
  forFile.selectedBin.reset();
  return studyFigure(source_.data()->summary, source_.data()->options, forFile);
}

const RatioHistogram* StudyView::histogram() const {
  if (!source_.data() || diagram_ == StudyDiagram::Conventions) return nullptr;
  const OffsetSummary& summary = source_.data()->summary;
  return diagram_ == StudyDiagram::Displacement
             ? &summary.displacement.histogram
             : &summary.ratio(source_.data()->options.convention).histogram;
}

std::int64_t StudyView::exampleOf(std::size_t bin) const {
  if (!histogram()) return -1;
  const OffsetSummary& summary = source_.data()->summary;
  return diagram_ == StudyDiagram::Displacement ? summary.displacementExamples[bin].index
                                                : summary.ratioExamples[bin].index;
}

QString StudyView::describe(std::size_t bin) const {
  const RatioHistogram* shares = histogram();
  if (!shares) return {};
  return tr("%1 to %2: %3 %, for example curve %4")
      .arg(QString::fromStdString(shortNumber(ratioBinStart(bin))),
           QString::fromStdString(shortNumber(ratioBinStart(bin + 1))),
           QString::fromStdString(shortNumber(100.0 * (*shares)[bin])))
      .arg(exampleOf(bin));
}

void StudyView::select(std::optional<std::size_t> bin) {
  if (bin && exampleOf(*bin) < 0) bin.reset();
  if (bin != selected_) {
    selected_ = bin;
    update();
  }
  emit described(selected_ ? describe(*selected_) : QString());
}

// To the next bin that counts anything; from the fullest one if none is selected.
void StudyView::selectNext(int step) {
  const RatioHistogram* shares = histogram();
  if (!shares) return;
  if (!selected_) {
    return select(static_cast<std::size_t>(std::max_element(shares->begin(), shares->end()) -
                                           shares->begin()));
  }
  const auto last = static_cast<std::ptrdiff_t>(shares->size());
  for (auto bin = static_cast<std::ptrdiff_t>(*selected_) + step; bin >= 0 && bin < last;
       bin += step) {
    if (exampleOf(static_cast<std::size_t>(bin)) >= 0) {
      return select(static_cast<std::size_t>(bin));
    }
  }
}

void StudyView::pick() {
  if (selected_) emit examplePicked(exampleOf(*selected_));
}

void StudyView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const SceneColours& colours = sceneColours(themePalette());
  if (!source_.data()) {
    painter.fillRect(rect(), toQColor(colours.background));
    painter.setPen(toQColor(colours.text));
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     source_.isRunning() ? tr("Measuring…")
                                         : tr("How large is the offset term against the feature "
                                              "term, over many random curves? Press Run."));
  } else {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.scale(display_.uiScale(), display_.uiScale());
    paintFigure(painter, studyFigure(source_.data()->summary, source_.data()->options, options()));
    painter.restore();
  }
  if (!hasFocus()) return;
  QStyleOptionFocusRect focus;
  focus.initFrom(this);
  focus.rect = rect().adjusted(1, 1, -1, -1);
  style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
}

void StudyView::mouseMoveEvent(QMouseEvent* event) {
  const auto bin = studyBinAt(event->position().x() / display_.uiScale(), options());
  emit described(bin && exampleOf(*bin) >= 0 ? describe(*bin) : QString());
}

void StudyView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  select(studyBinAt(event->position().x() / display_.uiScale(), options()));
  pick();
}

void StudyView::leaveEvent(QEvent*) {
  emit described(selected_ ? describe(*selected_) : QString());
}

void StudyView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return selectNext(-1);
    case Qt::Key_Right:
      return selectNext(1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return pick();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace flatland::ui
