// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "flatland/study/derivation.h"

class QSvgRenderer;

namespace flatland::ui {

/// A typeset formula of the derivation, in the text colour of the theme, as large as fits.
class FormulaView : public QWidget {
  Q_OBJECT

 public:
  explicit FormulaView(QWidget* parent = nullptr);
  ~FormulaView() override;

  void show(std::optional<DerivationStep> step, bool printed);
  bool isEmpty() const { return !renderer_; }

  /// The formula's file among the resources.
  static QString fileOf(DerivationStep step, bool printed);

  QSize sizeHint() const override { return {320, 44}; }
  QSize minimumSizeHint() const override { return {160, 32}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void load();

  QString file_;
  std::unique_ptr<QSvgRenderer> renderer_;
};

}  // namespace flatland::ui
