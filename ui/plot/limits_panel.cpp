// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/limits_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "flatland/io/limits_text.h"
#include "ui/export/scene_record.h"
#include "ui/plot/figure_files.h"
#include "ui/plot/limits_words.h"

namespace flatland::ui {

namespace {

constexpr int kSlideSteps = 1000;

std::optional<LimitSeries> run(LimitExperiment experiment, const Scene& scene, int curve, double t,
                               const JobControl& control) {
  switch (experiment) {
    case LimitExperiment::Turn:
      return turnToSilhouette(scene, curve, t);
    case LimitExperiment::Walk:
      return walkToSilhouette(scene, curve, t);
    case LimitExperiment::Slide:
      break;
  }
  return slideIntoSilhouette(scene, curve, t, [&control] { return !control.isCancelled(); });
}

}  // namespace

LimitsPanel::LimitsPanel(const CanvasModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      turner_(models.document, models.stage),
      view_(new LimitsView(models.display, this)) {
  setObjectName("limits.panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 2);
  layout->setSpacing(3);
  layout->addLayout(buildChoices());
  layout->addLayout(buildSlider());
  layout->addWidget(view_, 1);
  now_ = new QLabel(this);
  now_->setObjectName("limits.now");
  now_->setWordWrap(true);
  now_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  words_ = new QLabel(this);
  words_->setObjectName("limits.words");
  words_->setWordWrap(true);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  layout->addWidget(now_);
  layout->addWidget(words_);
  setFocusProxy(slide_);

  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesScene()) sceneChanged();
  });
  connect(&models_.probe, &Probe::changed, this, &LimitsPanel::sceneChanged);
  connect(&job_, &Job::failed, this, &LimitsPanel::said);
  showSeries(std::nullopt);
  showNow();
}

QLayout* LimitsPanel::buildChoices() {
  experiment_ = new QComboBox(this);
  experiment_->setObjectName("limits.experiment");
  experiment_->addItem(tr("Turn the view"));
  experiment_->addItem(tr("Walk along the curve"));
  experiment_->addItem(tr("A ridge slides in"));
  experiment_->setToolTip(
      tr("Three ways to a silhouette: turn the view at the probe; walk from the probe to the "
         "nearest silhouette; turn the view until an apparent ridge meets a silhouette at an "
         "inflection"));
  experiment_->setAccessibleName(tr("Way to the silhouette"));
  connect(experiment_, &QComboBox::currentIndexChanged, this, &LimitsPanel::sceneChanged);
  law_ = new QComboBox(this);
  law_->setObjectName("limits.law");
  law_->setToolTip(tr("What is drawn"));
  law_->setAccessibleName(tr("Quantity"));
  law_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(law_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index >= 0) view_->setLaw(static_cast<std::size_t>(index));
  });
  export_ = new QPushButton(tr("&Export…"), this);
  export_->setObjectName("limits.export");
  export_->setToolTip(tr("Write the diagram as a picture, or all values as CSV"));
  export_->setMinimumWidth(export_->fontMetrics().horizontalAdvance(export_->text()) + 18);
  connect(export_, &QPushButton::clicked, this, &LimitsPanel::exportDiagram);
  auto* row = new QHBoxLayout;
  row->setSpacing(3);
  row->addWidget(experiment_, 1);
  row->addWidget(law_, 1);
  row->addWidget(export_);
  return row;
}

QLayout* LimitsPanel::buildSlider() {
  slide_ = new QSlider(Qt::Horizontal, this);
  slide_->setObjectName("limits.slide");
  slide_->setRange(0, kSlideSteps);
  slide_->setPageStep(kSlideSteps / 10);
  slide_->setInvertedAppearance(true);  // to the right, towards the silhouette
  slide_->setToolTip(
      tr("n·w at the probe, from 1 (seen head-on) to 0 (silhouette): turns the view"));
  slide_->setAccessibleName(tr("Foreshortening n·w"));
  slide_->installEventFilter(this);
  connect(slide_, &QSlider::sliderPressed, this, [this] { turner_.begin(); });
  connect(slide_, &QSlider::sliderReleased, this, [this] { turner_.end(); });
  connect(slide_, &QSlider::valueChanged, this,
          [this](int value) { turnTo(static_cast<double>(value) / kSlideSteps); });
  nw_ = new QDoubleSpinBox(this);
  nw_->setObjectName("limits.nw");
  nw_->setDecimals(8);
  nw_->setRange(0.0, 1.0);
  nw_->setSingleStep(0.01);
  nw_->setKeyboardTracking(false);
  nw_->setLocale(QLocale::c());
  nw_->setToolTip(slide_->toolTip());
  nw_->setAccessibleName(tr("n·w"));
  connect(nw_, &QDoubleSpinBox::valueChanged, this, &LimitsPanel::turnTo);
  auto* label = new QLabel(tr("&n·w"), this);
  label->setBuddy(slide_);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(label);
  row->addWidget(slide_, 1);
  row->addWidget(nw_);
  return row;
}

// A key that is held down is one gesture, as a drag is.
bool LimitsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == slide_) {
    if (event->type() == QEvent::KeyPress) {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->key() == Qt::Key_Escape && turner_.isActive()) {
        turner_.cancel();
        return true;
      }
      if (key->key() != Qt::Key_Tab && key->key() != Qt::Key_Backtab) turner_.begin();
    }
    if (event->type() == QEvent::FocusOut) turner_.end();
    if (event->type() == QEvent::KeyRelease && !static_cast<QKeyEvent*>(event)->isAutoRepeat()) {
      turner_.end();
    }
  }
  return QWidget::eventFilter(watched, event);
}

std::optional<Probe::Place> LimitsPanel::place() const {
  const auto& curves = models_.document.scene().curves;
  if (const auto& probe = models_.probe.place()) return probe;
  if (curves.empty()) return std::nullopt;
  return Probe::Place{0, 0.5 * pieceCount(curves[0].shape)};
}

void LimitsPanel::turnTo(double nw) {
  const auto at = place();
  if (!at || models_.document.scene().view.distance) return showNow();
  const Jet jet = jetAt(models_.document.scene().curves[at->curve].shape, at->t);
  if (!(jet.d1.squaredNorm() > 0.0)) return showNow();
  models_.probe.setPlace(at);  // so that it is seen where n.w is meant
  turner_.turnTo(
      angleDegWithForeshortening(jet.d1.normalized(), nw, models_.document.scene().view.angleDeg));
  showNow();
}

void LimitsPanel::sceneChanged() {
  waiting_ = true;
  export_->setEnabled(false);  // the diagram is of an earlier scene
  showNow();
  if (isVisible()) start();
}

void LimitsPanel::showEvent(QShowEvent* event) {
  if (waiting_) start();
  QWidget::showEvent(event);
}

void LimitsPanel::start() {
  waiting_ = false;
  const auto at = place();
  if (!at) {
    job_.cancel();
    return showSeries(std::nullopt);
  }
  using Result = std::optional<LimitSeries>;
  const auto experiment = static_cast<LimitExperiment>(experiment_->currentIndex());
  job_.start<Result>(
      [experiment, scene = models_.document.scene(), at = *at](const JobControl& control) {
        return std::optional<Result>(
            run(experiment, scene, static_cast<int>(at.curve), at.t, control));
      },
      [this](const Result& result) { showSeries(result); });
}

void LimitsPanel::showSeries(const std::optional<LimitSeries>& series) {
  export_->setEnabled(series.has_value());
  const QString why =
      experiment_->currentIndex() == static_cast<int>(LimitExperiment::Slide)
          ? tr("This curve has no inflection into which an apparent ridge could slide.")
          : tr("This curve has no silhouette to go to in this view.");
  QStringList names;
  if (series) {
    for (const LimitLaw& law : series->laws) names << nameForPeople(law.quantity);
  }
  QStringList shown;
  for (int i = 0; i < law_->count(); ++i) shown << law_->itemText(i);
  if (names != shown) {
    const QSignalBlocker silent(law_);
    law_->clear();
    law_->addItems(names);
    view_->setLaw(0);
  }
  view_->setSeries(series, why);
  showNow();
}

// The present n.w, and what is known there.
void LimitsPanel::showNow() {
  const auto at = place();
  const bool perspective = models_.document.scene().view.distance.has_value();
  slide_->setEnabled(at && !perspective);
  nw_->setEnabled(at && !perspective);
  words_->setText(explanation());
  view_->setMarkedX(std::nullopt);
  now_->clear();
  if (!at) return;
  const auto terms =
      foreshortenedTerms(models_.document.scene(), static_cast<int>(at->curve), at->t);
  if (!terms) return;
  {
    const QSignalBlocker slideSilent(slide_), boxSilent(nw_);
    slide_->setValue(qRound(terms->nw * kSlideSteps));
    nw_->setValue(terms->nw);
  }
  now_->setText(terms->lambda ? tr("n·w = %1   λ = %2   |feature| %3   |offset| %4")
                                    .arg(terms->nw, 0, 'g', 4)
                                    .arg(*terms->lambda, 0, 'g', 5)
                                    .arg(terms->feature, 0, 'g', 4)
                                    .arg(terms->offset, 0, 'g', 4)
                              : tr("n·w = 0: the silhouette; λ has no value here"));
  now_->setToolTip(now_->text());
  const auto& series = view_->series();
  if (series && series->experiment == LimitExperiment::Turn) view_->setMarkedX(terms->nw);
}

QString LimitsPanel::explanation() const {
  if (models_.document.scene().view.distance) {
    return tr(
        "These limits are those of a viewer infinitely far away; switch perspective off to "
        "turn the view by n·w.");
  }
  const auto& series = view_->series();
  if (!series) return {};
  return explanationOf(series->limitCase);
}

void LimitsPanel::exportDiagram() {
  if (!view_->series() || isStale()) return;
  // While the dialog is open the next series may arrive, or none: all of the file is of this one.
  const QString text = exportFigureFile(
      this, {.suggestedName = tr("limits"),
             .title = "Flatland, limits at a silhouette",
             .sceneJson = sceneRecord(models_.document.scene()),
             .figure = [figure = view_->figureForFile()] { return figure; },
             .table = [series = *view_->series()] { return limitsToCsv({series}); }});
  if (!text.isEmpty()) emit said(text);
}

}  // namespace flatland::ui
