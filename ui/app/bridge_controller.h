// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/flat/canvas_models.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

class Docks;
class SectionPanel;

/// From curves to surfaces and back, as the menu asks for it.
class BridgeController : public QObject {
  Q_OBJECT

 public:
  BridgeController(const CanvasModels& models, Docks& docks, SectionPanel& section,
                   QObject* parent);

  /// Makes the selected curve, or the first, the surface.
  void sweep(SweptSurface::Kind kind);

  void cutAlongView();
  void cutAlongRidge();
  void openSection();

 signals:
  void surfaceWanted();  ///< there is something new to look at on it
  void curvesWanted();   ///< a section came into flatland
  void said(const QString& text);

 private:
  CanvasModels models_;
  Docks& docks_;
  SectionPanel& section_;
};

}  // namespace flatland::ui
