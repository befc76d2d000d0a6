// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/flat/canvas_models.h"

namespace flatland::ui {

/// The edits of the Edit and Curve menus. What cannot be done is said by `refused` in one sentence,
/// and nothing changes.
class EditController : public QObject {
  Q_OBJECT

 public:
  EditController(const CanvasModels& models, QObject* parent);

  void removePoints();                 ///< the selected ones
  void addCurve();                     ///< in the middle of the canvas, selected
  void addCurve(const QString& kind);  ///< likewise, one of newCurves()
  void removeCurve();                  ///< the current one
  void raiseDegree();
  void flipNormal();
  void reset();  ///< back to the preset or to the file as opened, as one step
  void togglePerspective(bool on);
  void setAngle(double angleDeg);

  static constexpr int kMaxDegree = 8;  ///< beyond it, marks are no longer promised complete

 signals:
  void refused(const QString& reason);

 private:
  void add(SceneCurve curve);

  CanvasModels models_;
};

}  // namespace flatland::ui
