// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/lesson_controller.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QKeyEvent>
#include <QScrollBar>
#include <QSplitter>
#include <algorithm>
#include <string_view>

#include "ui/app/docks.h"
#include "ui/app/layouts.h"
#include "ui/flat/canvas.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/view3d/surface_area.h"

namespace flatland::ui {

namespace {

/// The panels that are about the surface alone: a step with one of them needs no curves beside it.
constexpr std::string_view kSurfaceOnly[] = {"surface", "families", "surface-derivation",
                                             "triangle"};

bool isAboutCurves(const LessonState& state) {
  const bool surfaceOnly = std::ranges::find(kSurfaceOnly, state.panel) != std::end(kSurfaceOnly);
  return state.equation || !surfaceOnly;
}

/// True if a text that has the focus scrolls by this key.
bool scrolls(const QAbstractScrollArea& area, int key) {
  const bool upright = key == Qt::Key_Up || key == Qt::Key_Down;
  return upright && area.verticalScrollBar()->maximum() > 0;
}

}  // namespace

LessonController::LessonController(LessonModel& lesson, Layouts& layouts, Docks& docks,
                                   LessonPanel& strip, SurfaceArea& surface, FlatCanvas& canvas,
                                   QSplitter& centre, QObject* parent)
    : QObject(parent),
      lesson_(lesson),
      layouts_(layouts),
      docks_(docks),
      strip_(strip),
      surface_(surface),
      canvas_(canvas),
      centre_(centre) {
  connect(&lesson_, &LessonModel::aboutToStart, this, &LessonController::begin);
  connect(&lesson_, &LessonModel::panelWanted, this, [this](const QString& id) {
    layouts_.setLessonPanel(id);
    showStep();
  });
  connect(&lesson_, &LessonModel::changed, this,
          [this] { lesson_.isOpen() ? showStrip() : end(); });
  connect(&strip_, &LessonPanel::heightWanted, this, &LessonController::showStrip);
  connect(&layouts_, &Layouts::entered, this, [this] {
    stripHeight_ = 0;
    showStrip();
  });
  lendKeys(strip_);
}

void LessonController::begin() {
  shares_ = centre_.saveState();
  given_ = true;
  flatWanted_ = layouts_.showsFlatBeside();
  stripHeight_ = 0;
  layouts_.beginLesson();
}

void LessonController::showStep() {
  // Who puts the curves there, or away, wants them so until another step needs it otherwise.
  const bool flatWanted = isAboutCurves(lesson_.step().state);
  if (flatWanted != flatWanted_) layouts_.setFlatBeside(flatWanted_ = flatWanted);
  // What the step shows may appear only now.
  QMetaObject::invokeMethod(this, &LessonController::giveFocus, Qt::QueuedConnection);
}

void LessonController::showStrip() {
  if (!given_ || !lesson_.isOpen()) return;
  docks_.setHeading("lesson", tr("Lesson: %1").arg(QString::fromStdString(lesson_.lesson().title)));
  const int height = strip_.wantedHeight();
  if (height == stripHeight_) return;
  if (stripHeight_ == 0) docks_.show("lesson");
  if (!strip_.isVisibleTo(strip_.window())) return;  // whoever closed it wants it so
  stripHeight_ = height;
  docks_.setHeight("lesson", height);
}

void LessonController::giveFocus() {
  const QWidget* now = strip_.window()->focusWidget();
  if (surface_.isVisible() && surface_.canvas()) {
    const bool steps = now && now->isVisible() && strip_.isAncestorOf(now);
    if (!steps) surface_.canvas()->setFocus(Qt::OtherFocusReason);
  } else if (!now || !now->isVisible()) {
    canvas_.setFocus(Qt::OtherFocusReason);
  }
}

void LessonController::end() {
  if (!std::exchange(given_, false)) return;
  docks_.setHeading("lesson", {});
  layouts_.endLesson();
  centre_.restoreState(shares_);
  QMetaObject::invokeMethod(this, &LessonController::giveFocus, Qt::QueuedConnection);
}

void LessonController::lendKeys(QWidget& panel) {
  panel.installEventFilter(this);
  for (auto* text : panel.findChildren<QAbstractScrollArea*>()) text->installEventFilter(this);
}

bool LessonController::eventFilter(QObject* watched, QEvent* event) {
  const bool asks = event->type() == QEvent::ShortcutOverride;
  if (!asks && event->type() != QEvent::KeyPress) return false;
  QWidget* view = surface_.canvas();
  if (!view || !view->isVisible()) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const auto* text = qobject_cast<const QAbstractScrollArea*>(watched);
  if (text && scrolls(*text, key.key())) return false;
  const auto send = [&key, view](QEvent::Type type) {
    QKeyEvent copy(type, key.key(), key.modifiers(), key.text(), key.isAutoRepeat(),
                   static_cast<quint16>(key.count()));
    copy.ignore();
    QCoreApplication::sendEvent(view, &copy);
    return copy.isAccepted();
  };
  if (!send(QEvent::ShortcutOverride)) return false;  // means nothing there
  if (asks) {
    event->accept();
  } else {
    send(QEvent::KeyPress);
  }
  return true;
}

}  // namespace flatland::ui
