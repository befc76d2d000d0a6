// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/study_panel.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "ui/commands/scene_commands.h"
#include "ui/model/paths.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/wrap_row.h"
#include "ui/plot/figure_files.h"

namespace flatland::ui {

namespace {

constexpr int kMostCurves = 100000000;
constexpr int kSlideStepsPerDecade = 20;
constexpr int kSlideLow = -2, kSlideHigh = 4;  // decades of the scale
constexpr View kStudyView{90.0, std::nullopt};

double scaleAt(int slide) {
  return std::pow(10.0, static_cast<double>(slide) / kSlideStepsPerDecade);
}

}  // namespace

StudyPanel::StudyPanel(const CanvasModels& models, QWidget* parent)
    : QWidget(parent), models_(models), view_(new StudyView(source_, models.display, this)) {
  setObjectName("study.panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 2);
  layout->setSpacing(3);
  layout->addWidget(buildForm());
  layout->addWidget(buildTools());
  layout->addWidget(view_, 1);
  state_ = new ElidedLabel(this);
  state_->setObjectName("study.state");
  layout->addWidget(state_);
  setFocusProxy(run_);

  connect(&source_, &StudySource::changed, this, &StudyPanel::showState);
  connect(&source_, &StudySource::progressed, this,
          [this](double share) { progress_->setValue(static_cast<int>(1000.0 * share)); });
  connect(&source_, &StudySource::failed, this, &StudyPanel::said);
  connect(&source_, &StudySource::tableWritten, this, [this](const QString& file) {
    emit said(tr("Wrote %1").arg(QDir::toNativeSeparators(file)));
  });
  connect(view_, &StudyView::examplePicked, this, &StudyPanel::showExample);
  connect(view_, &StudyView::described, this, [this](const QString& text) {
    described_ = text;
    showState();
  });
  showScale();
  showState();
}

QPushButton* StudyPanel::addButton(const char* id, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(id);
  button->setToolTip(tip);
  button->setAccessibleName(text);
  button->setMinimumWidth(button->fontMetrics().horizontalAdvance(text) + 18);
  return button;
}

QWidget* StudyPanel::buildForm() {
  auto* row = new WrapRow(this);
  const auto add = [row](const QString& name, QWidget* field, const char* id, const QString& tip) {
    field->setObjectName(id);
    field->setToolTip(tip);
    row->add(name, field);
  };
  curves_ = new QSpinBox(this);
  curves_->setRange(1, kMostCurves);
  curves_->setValue(20000);
  curves_->setSingleStep(1000);
  points_ = new QSpinBox(this);
  points_->setRange(3, 9);
  points_->setValue(5);
  seed_ = new QLineEdit(QStringLiteral("1"), this);
  scale_ = new QDoubleSpinBox(this);
  scale_->setDecimals(4);
  scale_->setRange(1e-4, 1e6);
  scale_->setValue(1.0);
  scale_->setLocale(QLocale::c());
  scale_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  convention_ = new QComboBox(this);
  convention_->addItem(tr("arc length"));
  convention_->addItem(tr("parameter"));
  convention_->addItem(tr("unnormalised"));
  add(tr("&Curves"), curves_, "study.curves", tr("How many random curves"));
  add(tr("Po&ints"), points_, "study.points", tr("Control points of each curve, 3 to 9"));
  add(tr("&Seed"), seed_, "study.seed", tr("Which random curves: the same seed, the same curves"));
  add(tr("U&nits"), convention_, "study.convention",
      tr("arc length: as derived, without dimension. parameter: derivative of k by t. "
         "unnormalised: also the normal as long as the derivative"));
  add(tr("Sc&ale"), scale_, "study.scale",
      tr("Side of the square the control points are drawn from, for example in pixels"));
  run_ = addButton("study.run", tr("&Run"), tr("Measure the curves; again: stop"));
  connect(run_, &QPushButton::clicked, this, [this] {
    if (source_.isRunning()) {
      source_.cancel();
    } else {
      start();
    }
  });
  row->add(run_);
  return row;
}

QWidget* StudyPanel::buildTools() {
  auto* row = new WrapRow(this);
  diagram_ = new QComboBox(this);
  diagram_->setObjectName("study.diagram");
  diagram_->addItem(tr("Ratio"));
  diagram_->addItem(tr("Displacement"));
  diagram_->addItem(tr("Mixed units"));
  diagram_->setToolTip(
      tr("Ratio: offset term over feature term. Displacement: how far apparent ridges lie from "
         "their ridges. Mixed units: the ratio in three kinds of unit, at any scale"));
  diagram_->setAccessibleName(tr("Diagram"));
  connect(diagram_, &QComboBox::currentIndexChanged, this, [this](int index) {
    view_->setDiagram(static_cast<StudyDiagram>(index));
    showScale();
  });
  slide_ = new QSlider(Qt::Horizontal, this);
  slide_->setObjectName("study.slide");
  slide_->setRange(kSlideLow * kSlideStepsPerDecade, kSlideHigh * kSlideStepsPerDecade);
  slide_->setValue(0);
  slide_->setPageStep(kSlideStepsPerDecade);
  slide_->setToolTip(tr("Side of the square, 0.01 to 10,000: the curves stay, the units change"));
  slide_->setAccessibleName(tr("Scale of the mixed units"));
  connect(slide_, &QSlider::valueChanged, this, &StudyPanel::showScale);
  progress_ = new QProgressBar(this);
  progress_->setObjectName("study.progress");
  progress_->setRange(0, 1000);
  progress_->setAccessibleName(tr("Progress"));
  table_ = addButton("study.table", tr("&Table…"),
                     tr("Measure and write one row per curve as CSV; a file that was interrupted "
                        "is continued"));
  connect(table_, &QPushButton::clicked, this, &StudyPanel::writeTable);
  export_ = addButton("study.export", tr("&Export…"), tr("Write the diagram as a picture"));
  connect(export_, &QPushButton::clicked, this, &StudyPanel::exportPicture);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{diagram_, slide_, progress_, table_, export_}) {
    row->add(widget);
  }
  return row;
}

std::optional<OffsetStudyOptions> StudyPanel::options() const {
  bool isNumber = false;
  OffsetStudyOptions options;
  options.curves = curves_->value();
  options.points = points_->value();
  options.seed = seed_->text().trimmed().toULongLong(&isNumber);
  options.scale = scale_->value();
  options.convention = static_cast<TermConvention>(convention_->currentIndex());
  if (!isNumber || options.whyInvalid()) return std::nullopt;
  return options;
}

void StudyPanel::start() {
  const auto wanted = options();
  if (!wanted) return emit said(tr("The seed must be a whole number from 0"));
  progress_->setValue(0);
  source_.run(*wanted);
}

void StudyPanel::writeTable() {
  const auto wanted = options();
  if (!wanted) return emit said(tr("The seed must be a whole number from 0"));
  // An existing file is never replaced: it is continued, or refused.
  QString name = QFileDialog::getSaveFileName(this, tr("Write the table of the study"),
                                              tr("study.csv"), tr("CSV table (*.csv)"), nullptr,
                                              QFileDialog::DontConfirmOverwrite);
  if (name.isEmpty()) return;
  if (QFileInfo(name).suffix().isEmpty()) name += QStringLiteral(".csv");
  progress_->setValue(0);
  source_.writeTable(*wanted, toPath(name));
}

void StudyPanel::exportPicture() {
  if (!source_.data()) return;
  // While the dialog is open the study may run on: the file is what was shown.
  const QString text =
      exportFigureFile(this, {.suggestedName = tr("study"),
                              .title = "Flatland, offset study",
                              .sceneJson = {},
                              .figure = [figure = view_->figureForFile()] { return figure; }});
  if (!text.isEmpty()) emit said(text);
}

void StudyPanel::showScale() {
  const bool mixed = view_->diagram() == StudyDiagram::Conventions;
  slide_->setVisible(mixed);
  progress_->setVisible(source_.isRunning());  // an empty one looks like a field to type in
  view_->setScale(scaleAt(slide_->value()));
}

void StudyPanel::showState() {
  const bool running = source_.isRunning();
  run_->setText(running ? tr("&Stop") : tr("&Run"));
  table_->setEnabled(!running);
  export_->setEnabled(source_.data() != nullptr);
  if (!running) progress_->reset();
  showScale();
  QString text = described_;
  if (text.isEmpty() && source_.data()) {
    const OffsetSummary& summary = source_.data()->summary;
    text = tr("%1 curves · %2 apparent ridges, %3 births · %4 ridges and valleys, %5 deaths")
               .arg(summary.curves)
               .arg(summary.apparentRidges)
               .arg(summary.births)
               .arg(summary.extrema)
               .arg(summary.deaths);
    if (!source_.data()->isWhole() && !running) text = tr("Stopped: ") + text;
  }
  state_->setText(text);
  state_->setToolTip(text);
}

void StudyPanel::showExample(std::int64_t curve) {
  Scene scene;
  scene.curves.push_back({BezierChain(studyCurve(source_.data()->options, curve))});
  scene.view = kStudyView;
  models_.document.push(std::make_unique<ReplaceScene>(
      models_.document, std::move(scene), tr("Show Curve %1 of the Study").arg(curve)));
  emit said(tr("Curve %1 of the study. Undo brings your curve back.").arg(curve));
}

}  // namespace flatland::ui
