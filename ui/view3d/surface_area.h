// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "ui/view3d/surface_models.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace flatland::ui {

class ColourStrip;
class PaneWidget;
class SurfaceOverlay;

/// The views of the surface side by side, how far reading has come, and what to do where there is
/// no surface. Nothing is read or drawn before it is shown for the first time.
class SurfaceArea : public QWidget {
  Q_OBJECT

 public:
  explicit SurfaceArea(const SurfaceModels& models, QWidget* parent = nullptr);

  /// Of what all views show together.
  QSize viewsSize() const { return views_->size(); }

  /// What shows the surface in a view, and the words over it; null before the area was shown, or if
  /// there are not so many views.
  QWidget* canvas(std::size_t pane = 0) const;
  SurfaceOverlay* overlay(std::size_t pane = 0) const;

  /// Gives the focus to the view that panels are about, as soon as it is there.
  void focusView();

  /// The view that panels are about turns on and on, or none does.
  void setSpinning(bool spins);

  QSize sizeHint() const override { return {720, 560}; }
  QSize minimumSizeHint() const override { return {240, 200}; }

 signals:
  void openWanted();  ///< a mesh, where there is none
  void hint(const QString& text);
  void failed(const QString& reason);
  void spinningChanged(bool spins);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeEmpty();
  void makePanes();
  void addPane();
  void spinOnly(const PaneWidget& pane, bool spins);
  void showState();

  SurfaceModels models_;
  QStackedWidget* pages_;
  QWidget* empty_ = nullptr;
  QLabel* emptyWords_ = nullptr;
  QPushButton* open_ = nullptr;
  QWidget* views_;
  ColourStrip* colours_;
  QGridLayout* grid_;
  std::vector<PaneWidget*> panes_;  ///< owned by views_
  bool shown_ = false;
  bool wantsFocus_ = false;
};

}  // namespace flatland::ui
