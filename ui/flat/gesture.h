// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <Qt>
#include <memory>

#include "ui/flat/hit_test.h"

class QPainter;

namespace flatland::ui {

/// The pointer at one moment of a gesture.
struct Pointer {
  QPointF at;  ///< pixels of the canvas
  Qt::KeyboardModifiers modifiers;
};

/// What a pressed button does until it is let go, one object from press to release. A gesture acts
/// on the models only; it ends with either finish() or cancel(), and cancel() leaves the scene as
/// it was before the press (what had been undone can then no longer be redone). It is dropped
/// without either if it does not survive a change.
class Gesture {
  Q_DECLARE_TR_FUNCTIONS(Gesture)
 public:
  virtual ~Gesture() = default;

  virtual void move(const Pointer& pointer) = 0;
  virtual void finish(const Pointer& pointer) = 0;
  virtual void cancel() = 0;

  /// What goes on, for the status line.
  virtual QString status() const = 0;

  /// What belongs to the gesture itself, on top of the canvas: its numbers, its rubber band.
  virtual void paint(QPainter& painter) const = 0;

  /// False once the document has changed under it in a way it cannot follow.
  virtual bool survives(const Change& change) const {
    return change.what == Change::What::Points || change.what == Change::What::View ||
           change.what == Change::What::File;
  }
};

/// The gesture that pressing the left button on `target` begins; never null.
std::unique_ptr<Gesture> beginGesture(const CanvasModels& models, const Target& target,
                                      const Pointer& pressed, const QSizeF& canvas);

/// Moves the canvas under the pointer: middle button, or Space and left.
std::unique_ptr<Gesture> beginPan(const CanvasModels& models, const Pointer& pressed);

/// The words for what pressing and dragging on `target` would do.
QString describe(const CanvasModels& models, const Target& target);

}  // namespace flatland::ui
