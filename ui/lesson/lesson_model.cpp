// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_model.h"

#include <algorithm>
#include <utility>

#include "flatland/features/orientation.h"
#include "ui/commands/command_ids.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/unsaved_work.h"

namespace flatland::ui {

namespace {

/// The scene of a step. Told from other commands by its id; never merged.
class ShowLessonStep : public ReplaceScene {
 public:
  /// `from`: the step that was shown before; -1 for the person's own scene.
  ShowLessonStep(Document& document, Scene scene, const QString& text, int from, int to)
      : ReplaceScene(document, std::move(scene), text), from_(from), to_(to) {}
  int id() const override { return kLessonCommandId; }
  int from() const { return from_; }
  int to() const { return to_; }

 private:
  int from_, to_;
};

/// Brings back the person's own scene.
class LeaveLesson : public ReplaceScene {
 public:
  using ReplaceScene::ReplaceScene;
};

bool sameScene(const LessonState& a, const LessonState& b) {
  return a.scene == b.scene && a.viewAngleDeg == b.viewAngleDeg && a.camera == b.camera;
}

bool sameProbe(const LessonState& a, const LessonState& b) {
  return a.probeT == b.probeT && a.probeCurve == b.probeCurve;
}

}  // namespace

LessonModel::LessonModel(Document& document, Probe& probe, Display& display, QObject* parent)
    : QObject(parent), document_(document), probe_(probe), display_(display) {
  connect(&document_, &Document::changed, this, &LessonModel::follow);
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &LessonModel::followUndo);
}

void LessonModel::start(Lesson lesson) {
  leave();
  emit aboutToStart();
  own_ = Own{document_.scene(), probe_.place(), display_.families(), display_.showsPrintedRoots(),
             document_.undoStack().index()};
  lesson_ = std::move(lesson);
  index_ = 0;
  shownFrom_ = -1;
  isUndone_ = false;
  apply(false);
}

bool LessonModel::onlyStepsSince(const Own& own) const {
  const QUndoStack& stack = document_.undoStack();
  bool onlySteps = stack.index() >= own.undoIndex;
  for (int i = own.undoIndex; i < stack.index(); ++i) {
    onlySteps = onlySteps && stack.command(i)->id() == kLessonCommandId;
  }
  return onlySteps;
}

bool LessonModel::hasUnsavedWork() const {
  if (!lesson_) return document_.isModified();
  return document_.isUnsaved(own_->scene, own_->undoIndex);
}

bool LessonModel::hasEdits() const {
  if (!lesson_ || onlyStepsSince(*own_)) return false;
  Scene asTaught = isUndone_ ? own_->scene : sceneOfStep();
  asTaught.view = document_.scene().view;
  return unsavedWork(document_.scene(), asTaught).any();
}

void LessonModel::leave() {
  if (!lesson_) return;
  lesson_.reset();
  const Own own = *std::exchange(own_, std::nullopt);
  QUndoStack& stack = document_.undoStack();
  if (onlyStepsSince(own)) stack.setIndex(own.undoIndex);
  // Where undo went below the start and a step was pushed there, that is no longer the own scene.
  if (!(document_.scene() == own.scene)) {
    document_.push(std::make_unique<LeaveLesson>(document_, own.scene, tr("leave lesson")));
  }
  probe_.setPlace(own.place);
  for (const MarkKind kind : markKindsInLegendOrder()) {
    display_.setShows(kind, contains(own.families, kind));
  }
  display_.setShowsPrintedRoots(own.printedRoots);
  printed_ = false;
  emit surfaceEquationWanted({});
  emit changed();
}

void LessonModel::goTo(int index) {
  if (!lesson_ || index < 0 || index >= count() || index == index_) return;
  const LessonState before = step().state;
  const bool near = std::abs(index - index_) == 1;
  shownFrom_ = isUndone_ ? -1 : index_;
  index_ = index;
  apply(near && !isUndone_ && !step().setsPlace && sameScene(before, step().state) &&
        sameProbe(before, step().state));
}

void LessonModel::nextStop() {
  if (const auto stop = stopAfter(index_)) goTo(*stop);
}

void LessonModel::showAgain() {
  if (!lesson_) return;
  shownFrom_ = isUndone_ ? -1 : index_;
  apply(false);
}

std::optional<int> LessonModel::stopAfter(int index) const {
  for (int i = index + 1; i < count(); ++i) {
    if (lesson_->steps[static_cast<std::size_t>(i)].stop) return i;
  }
  return std::nullopt;
}

Scene LessonModel::sceneOfStep() const {
  const LessonState& state = step().state;
  Scene scene = state.scene ? *state.scene : own_->scene;
  if (state.viewAngleDeg) scene.view.angleDeg = normalizedDeg(*state.viewAngleDeg);
  if (state.camera && scene.surface) scene.surface->camera.towards = *state.camera;
  return scene;
}

void LessonModel::apply(bool keepScene) {
  const LessonState& state = step().state;
  if (!keepScene) {
    Scene scene = sceneOfStep();
    if (!(document_.scene() == scene)) {
      showing_ = true;  // the stack counts the command only after it was done
      document_.push(std::make_unique<ShowLessonStep>(
          document_, std::move(scene), tr("lesson: %1").arg(QString::fromStdString(step().title)),
          shownFrom_, index_));
      showing_ = false;
    }
    stepsDone_ = stepsDone();
    isUndone_ = false;
    if (state.probeT) probe_.setPlace(Probe::Place{state.probeCurve, *state.probeT});
    if (state.pick) emit pickWanted(*state.pick);
  }
  showSettings();
  askForPanels();
}

void LessonModel::askForPanels() {
  emit panelWanted(QString::fromStdString(step().state.panel));
  emit surfaceEquationWanted(QString::fromStdString(step().state.surfaceEquation));
}

/// What a step shows beside its scene.
void LessonModel::showSettings() {
  const LessonState& state = step().state;
  if (state.equation && !probe_.place()) probe_.moveBy(0.0);
  if (state.families) {
    MarkKinds wanted;
    for (const std::string& name : *state.families) {
      wanted.set(static_cast<std::size_t>(*markKindNamed(name)));
    }
    for (const MarkKind kind : markKindsInLegendOrder()) {
      display_.setShows(kind, contains(wanted, kind));
    }
  }
  display_.setShowsPrintedRoots(state.printedRoots);
  printed_ = state.printed;
  emit changed();
}

int LessonModel::stepsDone() const {
  const QUndoStack& stack = document_.undoStack();
  int steps = 0;
  for (int i = own_->undoIndex; i < stack.index(); ++i) {
    if (stack.command(i)->id() == kLessonCommandId) ++steps;
  }
  return steps;
}

/// Undo and redo of a step's scene lead to the step whose scene comes back.
void LessonModel::followUndo() {
  if (!lesson_ || showing_) return;
  const int before = std::exchange(stepsDone_, stepsDone());
  if (stepsDone_ == before) return;
  // Forward the last one done, back the first one undone; it is still on the stack.
  int wanted = stepsDone_ > before ? stepsDone_ - 1 : stepsDone_;
  const QUndoStack& stack = document_.undoStack();
  for (int i = own_->undoIndex; i < stack.count(); ++i) {
    if (stack.command(i)->id() != kLessonCommandId || wanted-- > 0) continue;
    const auto& shown = static_cast<const ShowLessonStep&>(*stack.command(i));
    const int step = stepsDone_ > before ? shown.to() : shown.from();
    isUndone_ = step < 0;
    if (isUndone_) {
      probe_.setPlace(own_->place);
    } else {
      index_ = std::min(step, count() - 1);
      const LessonState& state = this->step().state;
      if (state.probeT) probe_.setPlace(Probe::Place{state.probeCurve, *state.probeT});
      askForPanels();
    }
    return showSettings();
  }
}

/// Another file or preset was opened: there is no own scene to go back to.
void LessonModel::follow(const Change& change) {
  if (!lesson_ || showing_ || change.what != Change::What::Scene ||
      document_.undoStack().count() > 0)
    return;
  for (const MarkKind kind : markKindsInLegendOrder()) {
    display_.setShows(kind, contains(own_->families, kind));
  }
  display_.setShowsPrintedRoots(own_->printedRoots);
  lesson_.reset();
  own_.reset();
  printed_ = false;
  emit changed();
}

void LessonModel::setPrinted(bool printed) {
  const auto step = equation();
  if (printed == printed_ || !step || !textOf(*step).isMisprinted()) return;
  printed_ = printed;
  emit changed();
}

std::optional<DerivationStep> LessonModel::equation() const {
  return lesson_ ? step().state.equation : std::nullopt;
}

std::optional<DerivationPlace> LessonModel::placeOfProbe() const {
  const auto& place = probe_.place();
  if (!place) return std::nullopt;
  const Scene& scene = document_.scene();
  const SceneCurve& curve = scene.curves[place->curve];
  const ViewFrame frame = frameOf(scene.view);
  return DerivationPlace{curve.shape, place->t, frame, normalSide(curve, frame)};
}

std::optional<StepReading> LessonModel::reading() const {
  const auto step = equation();
  const auto place = placeOfProbe();
  if (!step || !place) return std::nullopt;
  return readStep(*step, *place);
}

std::vector<StepDifference> LessonModel::sweep() const {
  const auto step = equation();
  const auto place = placeOfProbe();
  if (!step || !place) return {};
  return stepSizeSweep(*step, *place);
}

}  // namespace flatland::ui
