// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sweep_panel.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "flatland/io/sweep_text.h"
#include "ui/export/scene_record.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/wrap_row.h"
#include "ui/plot/figure_files.h"

namespace flatland::ui {

namespace {

constexpr double kSlowest = 1.0, kFastest = 360.0;  // degrees per second

}  // namespace

SweepPanel::SweepPanel(const CanvasModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      source_(models.document),
      player_(models.document, models.stage),
      view_(new SweepView(models, source_, this)) {
  setObjectName("sweep.panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 2);
  layout->setSpacing(3);
  layout->addWidget(buildTools());
  layout->addWidget(view_, 1);
  state_ = new ElidedLabel(this);
  state_->setObjectName("sweep.state");
  layout->addLayout(buildFooter());
  setFocusProxy(view_);

  connect(&source_, &SweepSource::changed, this, &SweepPanel::showState);
  connect(&source_, &SweepSource::failed, this, &SweepPanel::said);
  connect(view_, &SweepView::hovered, this, [this](const QString& text) {
    hovered_ = text;
    showState();
  });
  connect(view_, &SweepView::playToggled, this, &SweepPanel::togglePlay);
  connect(view_, &SweepView::escaped, &player_, &ViewPlayer::cancel);
  connect(&player_, &ViewPlayer::playingChanged, this,
          [this](bool playing) { play_->setText(playing ? tr("Pause") : tr("Play")); });
  connect(&models_.document, &Document::changed, this, [this] {
    showAngle();
    showState();
  });
  showAngle();
  showState();
}

QToolButton* SweepPanel::addTool(const char* id, const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(id);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the diagram
  return button;
}

QWidget* SweepPanel::buildTools() {
  angle_ = new QDoubleSpinBox(this);
  angle_->setObjectName("sweep.angle");
  angle_->setDecimals(4);
  angle_->setRange(-360.0, 360.0);
  angle_->setKeyboardTracking(false);
  angle_->setLocale(QLocale::c());
  angle_->setSuffix(QStringLiteral("°"));
  angle_->setToolTip(tr("Direction from the curve to the viewer"));
  angle_->setAccessibleName(tr("View angle"));
  connect(angle_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
    ViewTurner(models_.document, models_.stage).turnTo(degrees);
    showAngle();
  });
  speed_ = new QDoubleSpinBox(this);
  speed_->setObjectName("sweep.speed");
  speed_->setDecimals(0);
  speed_->setRange(kSlowest, kFastest);
  speed_->setSingleStep(10.0);
  speed_->setValue(player_.speed());
  speed_->setSuffix(tr("°/s"));
  speed_->setToolTip(tr("How fast the view turns when played"));
  speed_->setAccessibleName(tr("Speed"));
  connect(speed_, &QDoubleSpinBox::valueChanged, &player_, &ViewPlayer::setSpeed);

  auto* row = new WrapRow(this);
  QToolButton* previous =
      addTool("sweep.previous", QStringLiteral("◂"),
              tr("Turn to the previous event of an apparent ridge (Ctrl+Left)"));
  QToolButton* next = addTool("sweep.next", QStringLiteral("▸"),
                              tr("Turn to the next event of an apparent ridge (Ctrl+Right)"));
  connect(previous, &QToolButton::clicked, this, [this] { view_->goToEvent(-1); });
  connect(next, &QToolButton::clicked, this, [this] { view_->goToEvent(1); });
  play_ = addTool("sweep.play", tr("Play"),
                  tr("Turn the view once around (Space); Esc returns to the view before"));
  connect(play_, &QToolButton::clicked, this, &SweepPanel::togglePlay);
  for (QWidget* widget : std::initializer_list<QWidget*>{previous, angle_, next, play_, speed_}) {
    row->add(widget);
  }
  return row;
}

// Below the diagram, so that the panel also fits where type is large.
QLayout* SweepPanel::buildFooter() {
  QToolButton* all = addTool("sweep.all", tr("All"), tr("Show the whole diagram (F)"));
  connect(all, &QToolButton::clicked, view_, &SweepView::showAll);
  export_ = addTool("sweep.export", tr("Export…"),
                    tr("Write the diagram as SVG, PDF, PNG, TikZ or as a CSV table"));
  connect(export_, &QToolButton::clicked, this, &SweepPanel::exportDiagram);
  auto* row = new QHBoxLayout;
  row->setSpacing(3);
  row->addWidget(state_, 1);
  row->addWidget(all);
  row->addWidget(export_);
  return row;
}

void SweepPanel::showEvent(QShowEvent* event) {
  source_.setActive(true);
  QWidget::showEvent(event);
}

void SweepPanel::hideEvent(QHideEvent* event) {
  player_.pause();
  source_.setActive(false);
  QWidget::hideEvent(event);
}

void SweepPanel::togglePlay() {
  if (player_.isPlaying()) {
    player_.pause();
  } else {
    player_.play();
    view_->setFocus();
  }
}

void SweepPanel::showAngle() {
  const QSignalBlocker silent(angle_);  // what is merely shown must not come back as an edit
  angle_->setValue(normalizedDeg(models_.document.scene().view.angleDeg));
}

void SweepPanel::showState() {
  export_->setEnabled(source_.data() != nullptr);
  QStringList parts;
  if (source_.isStale()) parts << tr("Updating…");
  if (models_.document.scene().view.distance) {
    parts << tr("Shown for a viewer infinitely far away, not for this perspective");
  }
  if (!hovered_.isEmpty()) parts << hovered_;
  if (parts.isEmpty() && source_.data()) {
    const Sweep& sweep = source_.data()->sweep;
    const auto folds =
        std::count_if(sweep.events.begin(), sweep.events.end(),
                      [](const SweepEvent& e) { return e.what == SweepEvent::What::Fold; });
    parts << tr("%n births or merges in half a turn", nullptr, static_cast<int>(folds));
    parts << (!sweep.complete   ? tr("not complete")
              : sweep.certified ? tr("certified")
                                : tr("complete"));
    if (!sweep.fine) parts << tr("too many branches: points are coarse");
    const auto& visibility = source_.data()->visibility;
    if (visibility && !visibility->marked) parts << tr("too large: what is hidden is not marked");
  }
  state_->setText(parts.join(tr(" · ")));
  state_->setToolTip(state_->text());
}

void SweepPanel::exportDiagram() {
  // While the dialog is open the next sweep may arrive: all of the file is of this one.
  const std::shared_ptr<const SweepData> shown = source_.data();
  if (!shown) return;
  const QString text =
      exportFigureFile(this, {.suggestedName = tr("sweep"),
                              .title = "Flatland, view sweep",
                              .sceneJson = sceneRecord(shown->scene),
                              .figure = [figure = view_->figureForFile()] { return figure; },
                              .table = [shown] { return sweepToCsv(shown->sweep); }});
  if (!text.isEmpty()) emit said(text);
}

}  // namespace flatland::ui
