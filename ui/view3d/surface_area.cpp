// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_area.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

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
      views_(new QWidget(pages_)),
      colours_(new ColourStrip(models, this)),
      grid_(new QGridLayout(views_)) {
  setObjectName("surface-area");
  empty_ = makeEmpty();
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

QWidget* SurfaceArea::makeEmpty() {
  auto* page = new QWidget(this);
  emptyWords_ = new QLabel(page);
  emptyWords_->setObjectName("surface.empty");
  emptyWords_->setAlignment(Qt::AlignCenter);
  emptyWords_->setWordWrap(true);
  open_ = new QPushButton(tr("&Open Mesh..."), page);
  open_->setObjectName("surface.empty.open");
  open_->setToolTip(tr("Choose a file with a mesh"));
  connect(open_, &QPushButton::clicked, this, &SurfaceArea::openWanted);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(24, 24, 24, 24);
  layout->addStretch(1);
  layout->addWidget(emptyWords_);
  layout->addWidget(open_, 0, Qt::AlignHCenter);
  layout->addStretch(1);
  return page;
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
  emptyWords_->setText(
      setting ? QString::fromStdString(surfaceName(setting->mesh))
              : tr("No surface yet. Open a mesh (PLY, OBJ, STL, OFF, glTF), drop one here, or take "
                   "one of Surface > Solids."));
  open_->setHidden(setting.has_value());
  const std::size_t active = models_.views.active();
  if (!there || active >= panes_.size() || !std::exchange(wantsFocus_, false)) return;
  panes_[active]->canvas()->setFocus(Qt::OtherFocusReason);
}

void SurfaceArea::focusView() {
  wantsFocus_ = true;
  showState();
}

}  // namespace flatland::ui
