// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace flatland::ui {

/// The one place where the window reports what went wrong, or what to know of the scene just
/// opened: a bar above the canvas that asks for nothing and goes away by its button or with the
/// next success.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  void showNote(const QString& text);  ///< in quieter colours
  QString text() const;

 private:
  void show(const QString& text, bool isError);

  QLabel* symbol_;
  QLabel* label_;
};

}  // namespace flatland::ui
