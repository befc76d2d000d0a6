// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_area.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/view3d/colour_strip.h"
#include "ui/view3d/pane_widget.h"
#include "ui/view3d/surface_input.h"

namespace flatland::ui {

namespace {

constexpr std::size_t kColumns = 2;  ///< of views side by side

}  // namespace

SurfaceArea::SurfaceArea(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      pages_(new QStackedWidget(this)),
      empty_(new QLabel(this)),
      progress_(nullptr),
      views_(new QWidget(pages_)),
      colours_(new ColourStrip(models, this)),
      grid_(new QGridLayout(views_)) {
  setObjectName("surface-area");
  progress_ = makeProgress();  // not before its own parts have their initial values
  empty_->setObjectName("surface.empty");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setMargin(24);
  grid_->setContentsMargins({});
  grid_->setSpacing(1);
  pages_->addWidget(empty_);
  pages_->addWidget(views_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  layout->addWidget(progress_);
  layout->addWidget(pages_, 1);
  layout->addWidget(colours_);
  connect(&models_.source, &SurfaceSource::changed, this, &SurfaceArea::showState);
  connect(&models_.source, &SurfaceSource::busyChanged, this, &SurfaceArea::showState);
  connect(&models_.source, &SurfaceSource::progressed, this,
          [this](double share) { setBar(100, qRound(100.0 * share)); });
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (!change.touchesSurface()) return;
    if (shown_) makePanes();
    showState();
  });
  showState();
}

QWidget* SurfaceArea::makeProgress() {
  auto* row = new QWidget(this);
  row->setObjectName("surface.progress");
  doing_ = new QLabel(row);
  bar_ = new QProgressBar(row);
  bar_->setObjectName("surface.progress.bar");
  bar_->setAccessibleName(tr("Progress"));
  cancel_ = new QToolButton(row);
  cancel_->setObjectName("surface.cancel");
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Give up reading; what was there before stays"));
  connect(cancel_, &QToolButton::clicked, this, [this] {
    models_.source.cancel();
    showState();
  });
  goOn_ = new QToolButton(row);
  goOn_->setObjectName("surface.go-on");
  goOn_->setText(tr("Go On"));
  goOn_->setToolTip(tr("Begin again what was given up"));
  connect(goOn_, &QToolButton::clicked, this, [this] { models_.source.goOn(); });
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(doing_);
  layout->addWidget(bar_, 1);
  layout->addWidget(cancel_);
  layout->addWidget(goOn_);
  return row;
}

void SurfaceArea::showEvent(QShowEvent* event) {
  // Not in the middle of a layout.
  if (!shown_) {
    QMetaObject::invokeMethod(
        this,
        [this] {
          shown_ = true;
          makePanes();
          showState();
        },
        Qt::QueuedConnection);
  }
  models_.source.setActive(true);
  QWidget::showEvent(event);
}

void SurfaceArea::makePanes() {
  const std::size_t wanted = models_.views.count();
  while (panes_.size() > wanted) {
    // What it shows is gone, and who is in the middle of an event of it must come out again.
    panes_.back()->input()->setSpinning(false);  // tells the menu
    panes_.back()->hide();
    panes_.back()->deleteLater();
    panes_.pop_back();
  }
  while (panes_.size() < wanted) addPane();
}

void SurfaceArea::addPane() {
  auto* pane = new PaneWidget(models_.of(panes_.size()), views_);
  connect(pane, &PaneWidget::hint, this, &SurfaceArea::hint);
  connect(pane, &PaneWidget::failed, this, &SurfaceArea::failed);
  connect(pane, &PaneWidget::spinningChanged, this,
          [this, pane](bool spins) { spinOnly(*pane, spins); });
  grid_->addWidget(pane, static_cast<int>(panes_.size() / kColumns),
                   static_cast<int>(panes_.size() % kColumns));
  panes_.push_back(pane);
  pane->show();
}

QWidget* SurfaceArea::canvas(std::size_t pane) const {
  return pane < panes_.size() ? panes_[pane]->canvas() : nullptr;
}

SurfaceOverlay* SurfaceArea::overlay(std::size_t pane) const {
  return pane < panes_.size() ? panes_[pane]->overlay() : nullptr;
}

void SurfaceArea::setSpinning(bool spins) {
  for (const PaneWidget* pane : panes_) {
    if (!spins) pane->input()->setSpinning(false);
  }
  const std::size_t active = models_.views.active();
  if (spins && active < panes_.size()) panes_[active]->input()->setSpinning(true);
}

void SurfaceArea::spinOnly(const PaneWidget& pane, bool spins) {
  for (const PaneWidget* other : panes_) {
    if (other == &pane || !spins) continue;
    const QSignalBlocker quiet(other->input());
    other->input()->setSpinning(false);
  }
  emit spinningChanged(spins);
}

QString SurfaceArea::whatIsWanting() const {
  const auto& surface = models_.source.surface();
  if (!surface) return tr("The mesh was not read");
  if (!surface->fields) return tr("No lines: curvature was not estimated");
  if (surface->swept) return tr("A coarse mesh: the fine one was not made");
  return tr("The lines are those of the smoothness before");
}

void SurfaceArea::setBar(int maximum, int value) {
  // A bar of Qt paints at once, and the window with it: the document may be in the middle of a
  // change that not everything to be painted knows of yet.
  bar_->setUpdatesEnabled(false);
  bar_->setRange(0, maximum);
  bar_->setValue(value);
  bar_->setUpdatesEnabled(true);
}

void SurfaceArea::showState() {
  const bool there = !panes_.empty() && models_.source.surface();
  pages_->setCurrentWidget(there ? views_ : empty_);
  const auto& setting = models_.document.scene().surface;
  colours_->setVisible(there && setting && styleOf(*setting) == SurfaceStyle::Colours);
  const bool busy = models_.source.isBusy();
  const bool givenUp = models_.source.isGivenUp();
  progress_->setVisible(busy || givenUp);
  const bool begins = busy && bar_->isHidden();
  bar_->setVisible(busy);
  cancel_->setVisible(busy);
  goOn_->setVisible(givenUp);
  if (givenUp) doing_->setText(whatIsWanting());
  if (busy) {
    const bool reading = models_.source.isReading();
    doing_->setText(reading ? tr("Reading the mesh") : tr("Estimating curvature"));
    cancel_->setToolTip(reading ? tr("Give up reading; what was there before stays")
                                : tr("Give up estimating; lines that were there before stay, a new "
                                     "mesh has none. Go On begins again."));
    // How long reading takes is not known.
    if (reading) {
      setBar(0, 0);
    } else if (bar_->maximum() == 0 || begins) {
      setBar(100, 0);
    }
  }
  empty_->setText(
      setting ? QString::fromStdString(surfaceName(setting->mesh))
              : tr("No surface yet. Open a mesh (PLY, OBJ, STL, OFF, glTF) by Surface > Open Mesh, "
                   "drop one here, or take one of Surface > Solids."));
}

}  // namespace flatland::ui
