// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QUndoCommand>

#include "ui/model/document.h"
#include "ui/model/probe.h"

namespace flatland::ui {

/// Sets from where the scene is seen. Undo and redo are exact also where the camera of a linked
/// surface has turned the view meanwhile, which is no step; obsolete from the start if the view is
/// that already. Commands of one gesture become one step, which vanishes if the gesture
/// ends where it began. Precondition: a distance, if set, is positive and finite.
class SetView : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(SetView)
 public:
  SetView(Document& document, const View& view, int gesture = 0);

  void undo() override { document_.setView(before_); }
  void redo() override { document_.setView(after_); }
  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Document& document_;
  View before_, after_;
  int gesture_;
};

/// The same, with the probe put at a place of the curves there are.
class SetViewAndProbe : public SetView {
 public:
  SetViewAndProbe(Document& document, const View& view, Probe& probe, const Probe::Place& place,
                  int gesture = 0)
      : SetView(document, view, gesture), probe_(probe), place_(place) {}

  void undo() override {
    SetView::undo();
    swapPlace();
  }
  void redo() override {
    SetView::redo();
    swapPlace();
  }

 private:
  void swapPlace();

  Probe& probe_;
  std::optional<Probe::Place> place_;
};

/// Exchanges the whole scene, as Reset to preset does. Obsolete from the start if it is the same.
class ReplaceScene : public QUndoCommand {
 public:
  ReplaceScene(Document& document, Scene scene, const QString& text);

  void undo() override { document_.swapScene(scene_); }
  void redo() override { document_.swapScene(scene_); }

 private:
  Document& document_;
  Scene scene_;
};

/// Puts another surface beside the curves, draws it otherwise, or takes it away (nullopt). The
/// camera of a surface that stays is left alone. Commands of one gesture become one step.
class SetSurface : public QUndoCommand {
 public:
  SetSurface(Document& document, std::optional<SurfaceSetting> surface, const QString& text,
             int gesture = 0);

  void undo() override { document_.swapSurface(surface_); }
  void redo() override { document_.swapSurface(surface_); }
  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;

  /// Of a command that is done: the surface there was before.
  const std::optional<SurfaceSetting>& before() const { return surface_; }

 private:
  Document& document_;
  std::optional<SurfaceSetting> surface_;
  int gesture_;
};

}  // namespace flatland::ui
