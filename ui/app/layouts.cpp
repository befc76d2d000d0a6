// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/layouts.h"

#include <QMainWindow>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <utility>

#include "ui/app/docks.h"
#include "ui/model/display.h"

namespace flatland::ui {

namespace {

constexpr int kVersion = 4;  ///< of saveState(): raise when docks change names

const QStringList kSurfacePanels{"families", "surface", "bridge", "section"};
/// Of a picked point: opened when they are wanted.
const QStringList kPickPanels{"surface-derivation", "triangle"};

QString nameOf(Layouts::Kind kind) {
  switch (kind) {
    case Layouts::Kind::Work:
      return QStringLiteral("work");
    case Layouts::Kind::Surface:
      return QStringLiteral("surface");
    case Layouts::Kind::Picture:
      return QStringLiteral("picture");
    case Layouts::Kind::Projector:
      break;
  }
  return QStringLiteral("projector");
}

constexpr Layouts::Kind kKinds[] = {Layouts::Kind::Work, Layouts::Kind::Surface,
                                    Layouts::Kind::Picture, Layouts::Kind::Projector};

}  // namespace

std::optional<Layouts::Kind> Layouts::kindNamed(const QString& name) {
  for (const Kind kind : kKinds) {
    if (name == nameOf(kind)) return kind;
  }
  return std::nullopt;
}

Layouts::Layouts(QMainWindow& window, Docks& docks, Display& display, QToolBar& pictureBar,
                 QWidget& surface)
    : QObject(&window),
      window_(window),
      docks_(docks),
      display_(display),
      pictureBar_(pictureBar),
      surface_(surface),
      leave_(new QToolButton(window.statusBar())) {
  leave_->setObjectName("projector.leave");
  leave_->setText(tr("Esc: leave"));
  leave_->setToolTip(tr("Back to the window as it was (Esc or F11)"));
  connect(leave_, &QToolButton::clicked, this, [this] { use(beforeProjector_); });
  window.statusBar()->addPermanentWidget(leave_);
  leave_->hide();
  arrange();
}

void Layouts::use(Kind kind) {
  // Who asks for the layout of surfaces has its place shown, empty or not.
  const bool asks = kind == Kind::Surface && current_ != Kind::Projector;
  const bool appears = asks && !std::exchange(emptyWanted_, true) && !surfaceThere_;
  if (kind == current_) {
    if (!appears) return;
    showParts();
    emit changed();
    return;
  }
  states()[current_] = window_.saveState(kVersion);
  const bool wasProjector = current_ == Kind::Projector;
  if (kind == Kind::Projector) {
    beforeProjector_ = current_;
    geometry_ = window_.saveGeometry();
    place_ = window_.geometry();
    windowState_ = window_.windowState();
  }
  current_ = kind;
  display_.setProjector(kind == Kind::Projector);
  leave_->setVisible(kind == Kind::Projector);
  if (kind == Kind::Projector) window_.showFullScreen();
  if (wasProjector) {
    window_.setWindowState(windowState_);
    if (!(windowState_ & Qt::WindowMaximized)) window_.setGeometry(place_);
  }
  enter(kind);
  emit changed();
  emit entered();
}

void Layouts::toggleProjector() {
  use(current_ == Kind::Projector ? beforeProjector_ : Kind::Projector);
}

void Layouts::enter(Kind kind) {
  QByteArray state = states().value(kind);
  if (own_ && state.isEmpty() && kind == Kind::Work) state = states_.value(kind);
  if (state.isEmpty() || !window_.restoreState(state, kVersion)) arrange();
  showParts();
  showLessonPanel();
}

void Layouts::beginLesson() {
  states_[current_] = window_.saveState(kVersion);
  own_ = Own{current_, beforeProjector_, flatBeside_, emptyWanted_};
  enter(current_);
}

void Layouts::endLesson() {
  if (!own_) return;
  const Own own = *std::exchange(own_, std::nullopt);
  lessonStates_.clear();
  lessonOpened_.clear();
  lessonPanel_.clear();
  flatBeside_ = own.flatBeside;
  emptyWanted_ = own.emptyWanted;
  if (current_ != Kind::Projector) {
    current_ = own.current == Kind::Projector ? own.beforeProjector : own.current;
  } else {
    beforeProjector_ = own.current == Kind::Projector ? own.beforeProjector : own.current;
  }
  enter(current_);
  emit changed();
}

void Layouts::setLessonPanel(const QString& id) {
  // The column at the right has its width from the first panel in it.
  const bool isFirst = lessonOpened_.isEmpty() && !id.isEmpty() && current_ != Kind::Work;
  lessonPanel_ = id;
  if (own_ && isFirst) arrange();
  showLessonPanel();
}

void Layouts::showLessonPanel() {
  if (!own_) return;
  for (const QString& opened : lessonOpened_) {
    const bool stays = opened == lessonPanel_ || current_ == Kind::Work;
    if (!stays) docks_.hide(opened.toLatin1().constData());
  }
  if (lessonPanel_.isEmpty()) return;
  docks_.show(lessonPanel_.toLatin1().constData());
  if (!lessonOpened_.contains(lessonPanel_)) lessonOpened_ << lessonPanel_;
}

void Layouts::showParts() {
  pictureBar_.setVisible(current_ == Kind::Picture);
  const bool emptyShown = current_ == Kind::Surface && emptyWanted_;
  surface_.setVisible(emptyShown || (surfaceThere_ && current_ != Kind::Work));
}

void Layouts::setSurfaceThere(bool there) {
  if (there == surfaceThere_) return;
  surfaceThere_ = there;
  if (!there) emptyWanted_ = false;  // its room is the curves'
  showParts();
}

void Layouts::setFlatBeside(bool shows) {
  if (shows == flatBeside_) return;
  flatBeside_ = shows;
  emit changed();
}

void Layouts::arrange() {
  docks_.setScale(display_.uiScale());
  docks_.setEquations(own_ && current_ != Kind::Work);
  if (own_ && current_ != Kind::Work) return arrangeForLesson();
  switch (current_) {
    case Kind::Work:
      docks_.arrangeBut(kSurfacePanels + kPickPanels);
      break;
    case Kind::Surface:
      docks_.arrangeOnly(kSurfacePanels);
      break;
    case Kind::Picture:
      docks_.arrangeOnly({});
      break;
    case Kind::Projector:
      docks_.arrangeOnly({surfaceThere_ ? "families" : "legend"});
      break;
  }
  showParts();
}

void Layouts::arrangeForLesson() {
  QStringList panels{"lesson"};
  if (!lessonPanel_.isEmpty()) panels << lessonPanel_;
  if (current_ == Kind::Projector && !surfaceThere_) panels << "legend";
  if (current_ == Kind::Projector && surfaceThere_ && lessonPanel_.isEmpty()) panels << "families";
  docks_.arrangeOnly(panels);
  showParts();
}

void Layouts::restoreDefault() {
  arrange();
  emit changed();  // what stands in it beside the docks goes by it
  emit entered();
}

void Layouts::restore(const QSettings& settings) {
  for (const Kind kind : kKinds) {
    states_[kind] = settings.value("window/layout-" + nameOf(kind)).toByteArray();
  }
  flatBeside_ = settings.value("window/flat-beside", true).toBool();
  window_.restoreGeometry(settings.value("window/geometry").toByteArray());
  const std::optional<Kind> kind = kindNamed(settings.value("window/layout").toString());
  if (kind && *kind != Kind::Projector) current_ = *kind;
  enter(current_);
  emit changed();
  emit entered();
}

void Layouts::save(QSettings& settings) const {
  const bool projector = current_ == Kind::Projector;
  const Own own = own_.value_or(Own{current_, beforeProjector_, flatBeside_, emptyWanted_});
  settings.setValue("window/flat-beside", own.flatBeside);
  settings.setValue("window/geometry", projector ? geometry_ : window_.saveGeometry());
  const Kind kept = own.current == Kind::Projector ? own.beforeProjector : own.current;
  settings.setValue("window/layout", nameOf(kept));
  for (const Kind kind : kKinds) {
    const bool isShown = !own_ && kind == current_;
    const QByteArray state = isShown ? window_.saveState(kVersion) : states_.value(kind);
    if (!state.isEmpty()) settings.setValue("window/layout-" + nameOf(kind), state);
  }
}

}  // namespace flatland::ui
