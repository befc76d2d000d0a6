// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/view3d/surface_models.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace flatland::ui {

/// A row that says how far reading a mesh and estimating its curvature have come, with a button to
/// give up, and one to go on with what was given up. Hidden while there is nothing to say.
class SurfaceProgress : public QWidget {
  Q_OBJECT

 public:
  enum class Says {
    All,
    Reading,  ///< for where no surface is shown: a mesh that is being read, nothing else
  };

  /// Its parts are called "surface.progress", or "reading.progress" for Says::Reading.
  SurfaceProgress(const SurfaceModels& models, Says says, QWidget* parent = nullptr);

  /// Whether to be seen when there is something to say; it is, at first.
  void setWanted(bool wanted);

 private:
  void showState();
  QString whatIsWanting() const;
  void setBar(int maximum, int value);

  SurfaceModels models_;
  Says says_;
  bool wanted_ = true;
  QLabel* doing_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  QToolButton* goOn_;
};

}  // namespace flatland::ui
