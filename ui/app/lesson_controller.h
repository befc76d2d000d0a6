// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>

class QSplitter;

namespace flatland::ui {

class Docks;
class FlatCanvas;
class Layouts;
class LessonModel;
class LessonPanel;
class SurfaceArea;

/// The window while a lesson is given: the strip as high as its words, the panel a step speaks of,
/// the curves beside a surface only where a step is about them, and keys that reach the surface
/// from the strip and the panels of picked points. What the person had arranged comes back when the
/// lesson is left.
class LessonController : public QObject {
  Q_OBJECT

 public:
  /// All of it outlives the lesson; `centre` holds surface and canvas side by side.
  LessonController(LessonModel& lesson, Layouts& layouts, Docks& docks, LessonPanel& strip,
                   SurfaceArea& surface, FlatCanvas& canvas, QSplitter& centre, QObject* parent);

  /// Lets the surface have the keys that mean something there and that nobody within `panel` takes.
  void lendKeys(QWidget& panel);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void begin();
  void showStep();
  void showStrip();
  void giveFocus();
  void end();

  LessonModel& lesson_;
  Layouts& layouts_;
  Docks& docks_;
  LessonPanel& strip_;
  SurfaceArea& surface_;
  FlatCanvas& canvas_;
  QSplitter& centre_;
  QByteArray shares_;  ///< of surface and canvas, as the person had them
  bool given_ = false;
  bool flatWanted_ = true;
  int stripHeight_ = 0;  ///< 0: it is to be shown
};

}  // namespace flatland::ui
