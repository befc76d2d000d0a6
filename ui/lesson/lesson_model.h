// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "flatland/io/lesson_text.h"
#include "ui/model/display.h"
#include "ui/model/document.h"
#include "ui/model/probe.h"

namespace flatland::ui {

/// The lesson that is being given: which step, as printed or corrected, and what the step's
/// equation says at the probe. A step that shows a scene does so by one command that undo takes
/// back; the person's own scene, probe and shown families come back when the lesson is left.
class LessonModel : public QObject {
  Q_OBJECT

 public:
  LessonModel(Document& document, Probe& probe, Display& display, QObject* parent = nullptr);

  /// Leaves the lesson there is, if any, and shows the first step.
  void start(Lesson lesson);

  /// Back to the person's own scene. If only steps of the lesson were done since, undo goes back to
  /// before them and the document is as unmodified as it was; else the own scene comes back by one
  /// more command, so that edits made in the lesson can be undone to.
  void leave();

  /// Whether the person's own scene, which comes back when the lesson is left, is unsaved.
  bool hasUnsavedWork() const;
  const Scene& ownScene() const { return own_ ? own_->scene : document_.scene(); }
  /// How many steps of the undo stack lead to it.
  int ownUndoIndex() const { return own_ ? own_->undoIndex : document_.undoStack().index(); }
  /// Whether a lesson is open and there is work in the scene of its step that would be lost; where
  /// it is looked at from is none.
  bool hasEdits() const;

  bool isOpen() const { return lesson_.has_value(); }
  /// Precondition for the next three: isOpen().
  const Lesson& lesson() const { return *lesson_; }
  const LessonStep& step() const { return lesson_->steps[static_cast<std::size_t>(index_)]; }
  int index() const { return index_; }
  int count() const { return lesson_ ? static_cast<int>(lesson_->steps.size()) : 0; }

  /// Steps out of range are not gone to. Next to a step of the same scene and view, what was
  /// dragged stays dragged, unless the step itself names its scene, view or probe.
  void goTo(int index);
  void next() { goTo(index_ + 1); }
  void back() { goTo(index_ - 1); }
  void first() { goTo(0); }
  void nextStop();
  bool hasNextStop() const { return stopAfter(index_).has_value(); }
  /// The scene and probe of this step, whatever was dragged.
  void showAgain();

  /// The step's scene was undone: the person's own one is shown.
  bool isUndone() const { return isUndone_; }

  /// The equation of the step as the thesis prints it; only where it is misprinted.
  bool isPrinted() const { return printed_; }
  void setPrinted(bool printed);

  std::optional<DerivationStep> equation() const;

  /// At the probe, computed anew at each call; empty without equation or probe.
  std::optional<StepReading> reading() const;
  std::vector<StepDifference> sweep() const;
  /// Of the scene there is.
  const PrintedRoots& printedRoots() const { return document_.printedRoots(); }

 signals:
  /// The lesson, its step or the variant is another.
  void changed();
  /// A lesson starts: nothing of the window has changed yet.
  void aboutToStart();
  /// A step was gone to that asks for this dock in front; empty: for none.
  void panelWanted(const QString& id);
  /// The equation of kSurfaceEquations of the step that is gone to, empty for none.
  void surfaceEquationWanted(const QString& id);
  /// A step picks a point of the surface, which may not have been read yet.
  void pickWanted(const flatland::LessonPick& pick);

 private:
  struct Own {
    Scene scene;
    std::optional<Probe::Place> place;
    MarkKinds families;
    bool printedRoots;
    int undoIndex;
  };

  Scene sceneOfStep() const;
  void apply(bool keepScene);
  void showSettings();
  void askForPanels();
  void followUndo();
  int stepsDone() const;
  void follow(const Change& change);
  bool onlyStepsSince(const Own& own) const;
  std::optional<int> stopAfter(int index) const;
  std::optional<DerivationPlace> placeOfProbe() const;

  Document& document_;
  Probe& probe_;
  Display& display_;
  std::optional<Lesson> lesson_;
  std::optional<Own> own_;
  int index_ = 0;
  bool printed_ = false;
  int stepsDone_ = 0;   ///< commands of the lesson that are done
  int shownFrom_ = -1;  ///< the step from which the next is shown; -1: the own scene
  bool isUndone_ = false;
  bool showing_ = false;  ///< a step is just putting its scene in place
};

}  // namespace flatland::ui
