// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/model/surface_study.h"

class QCheckBox;
class QSpinBox;
class QTextBrowser;

namespace flatland::ui {

/// Chapter 4 at the picked point, live while the camera moves: the matrices, and both sides of each
/// equation with their difference, as printed or corrected. The vertex can be typed.
class DerivationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DerivationPanel(SurfaceStudy& study, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {360, 320}; }

  /// Marks an equation by its id ("4.7") and keeps it in sight, as soon as there are numbers and
  /// until somebody scrolls, and as it should be, whatever was looked at as printed before. Empty:
  /// stays where it is.
  void showEquation(const QString& id);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void scrollToWanted();
  QString matrices(const SurfacePlace& place) const;
  QString terms(SurfaceStep step, const SurfacePlace& place) const;
  QString steps(const SurfacePlace& place) const;

  SurfaceStudy& study_;
  QSpinBox* vertex_;
  QCheckBox* printed_;
  QTextBrowser* text_;
  QString wanted_;  ///< the equation to be seen, until somebody scrolls
  QString marked_;  ///< the equation of the step
};

/// "View-dependent curvature" in the person's language.
QString titleForPeople(SurfaceStep step);

}  // namespace flatland::ui
