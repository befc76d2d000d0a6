// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_area.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/view3d/colour_strip.h"
#include "ui/view3d/pane_widget.h"
#include "ui/view3d/surface_input.h"
#include "ui/view3d/surface_progress.h"

namespace flatland::ui {

namespace {

constexpr std::size_t kColumns = 2;  ///< of views side by side

}  // namespace

SurfaceArea::SurfaceArea(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      pages_(new QStackedWidget(this)),
      empty_(new QLabel(this)),
      views_(new QWidget(pages_)),
      colours_(new ColourStrip(models, this)),
      grid_(new QGridLayout(views_)) {
  setObjectName("surface-area");
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
  layout->addWidget(new SurfaceProgress(models_, SurfaceProgress::Says::All, this));
  layout->addWidget(pages_, 1);
  layout->addWidget(colours_);
  connect(&models_.source, &SurfaceSource::changed, this, &SurfaceArea::showState);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (!change.touchesSurface()) return;
    if (shown_) makePanes();
    showState();
  });
  showState();
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

void SurfaceArea::showState() {
  const bool there = !panes_.empty() && models_.source.surface();
  pages_->setCurrentWidget(there ? views_ : empty_);
  const auto& setting = models_.document.scene().surface;
  colours_->setVisible(there && setting && styleOf(*setting) == SurfaceStyle::Colours);
  empty_->setText(
      setting ? QString::fromStdString(surfaceName(setting->mesh))
              : tr("No surface yet. Open a mesh (PLY, OBJ, STL, OFF, glTF) by Surface > Open Mesh, "
                   "drop one here, or take one of Surface > Solids."));
}

}  // namespace flatland::ui
