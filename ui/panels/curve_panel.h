// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "ui/flat/canvas_models.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace flatland::ui {

/// The current curve: its kind, and what can be set of it beyond its points: weights, the
/// parameters of a family, typed formulas.
class CurvePanel : public QWidget {
  Q_OBJECT

 public:
  explicit CurvePanel(const CanvasModels& models, QWidget* parent = nullptr);

 signals:
  /// Something cannot be done, or was done with a remark.
  void said(const QString& text);

 private:
  void refresh();
  void build(std::optional<std::size_t> curve);
  void convert();
  QString description(const Curve& curve) const;
  QWidget* weightsEditor(std::size_t curve);

  CanvasModels models_;
  QLabel* heading_;
  QPushButton* convert_;
  QVBoxLayout* room_;  ///< for the editor
  QWidget* editor_ = nullptr;
  std::function<void()> show_;  ///< refreshes the editor
  QString built_;               ///< for which curve and sort the editor was built
};

}  // namespace flatland::ui
