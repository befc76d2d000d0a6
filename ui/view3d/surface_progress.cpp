// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_progress.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace flatland::ui {

SurfaceProgress::SurfaceProgress(const SurfaceModels& models, Says says, QWidget* parent)
    : QWidget(parent),
      models_(models),
      says_(says),
      doing_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QToolButton(this)),
      goOn_(new QToolButton(this)) {
  const QString id = says == Says::All ? QStringLiteral("surface") : QStringLiteral("reading");
  setObjectName(id + ".progress");
  bar_->setObjectName(id + ".progress.bar");
  bar_->setAccessibleName(tr("Progress"));
  cancel_->setObjectName(id + ".cancel");
  cancel_->setText(tr("Cancel"));
  connect(cancel_, &QToolButton::clicked, this, [this] {
    models_.source.cancel();
    showState();
  });
  goOn_->setObjectName(id + ".go-on");
  goOn_->setText(tr("Go On"));
  goOn_->setToolTip(tr("Begin again what was given up"));
  connect(goOn_, &QToolButton::clicked, this, [this] { models_.source.goOn(); });
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(doing_);
  layout->addWidget(bar_, 1);
  layout->addWidget(cancel_);
  layout->addWidget(goOn_);
  connect(&models_.source, &SurfaceSource::changed, this, &SurfaceProgress::showState);
  connect(&models_.source, &SurfaceSource::busyChanged, this, &SurfaceProgress::showState);
  connect(&models_.source, &SurfaceSource::progressed, this,
          [this](double share) { setBar(100, qRound(100.0 * share)); });
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showState();
  });
  showState();
}

void SurfaceProgress::setWanted(bool wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  showState();
}

QString SurfaceProgress::whatIsWanting() const {
  const auto& surface = models_.source.surface();
  if (!surface) return tr("The mesh was not read");
  if (!surface->fields) return tr("No lines: curvature was not estimated");
  if (surface->swept) return tr("A coarse mesh: the fine one was not made");
  return tr("The lines are those of the smoothness before");
}

void SurfaceProgress::setBar(int maximum, int value) {
  // A bar of Qt paints at once, and the window with it: the document may be in the middle of a
  // change that not everything to be painted knows of yet.
  bar_->setUpdatesEnabled(false);
  bar_->setRange(0, maximum);
  bar_->setValue(value);
  bar_->setUpdatesEnabled(true);
}

void SurfaceProgress::showState() {
  const bool reading = models_.source.isReading();
  const bool busy = says_ == Says::All ? models_.source.isBusy() : reading;
  const bool givenUp = says_ == Says::All && models_.source.isGivenUp();
  setVisible(wanted_ && (busy || givenUp));
  const bool begins = busy && bar_->isHidden();
  bar_->setVisible(busy);
  cancel_->setVisible(busy);
  goOn_->setVisible(givenUp);
  if (givenUp) doing_->setText(whatIsWanting());
  cancel_->setToolTip(reading || says_ == Says::Reading
                          ? tr("Give up reading; what was there before stays")
                          : tr("Give up estimating; lines that were there before stay, a new "
                               "mesh has none. Go On begins again."));
  if (!busy) return;
  doing_->setText(reading ? tr("Reading the mesh") : tr("Estimating curvature"));
  // How long reading takes is not known.
  if (reading) {
    setBar(0, 0);
  } else if (bar_->maximum() == 0 || begins) {
    setBar(100, 0);
  }
}

}  // namespace flatland::ui
