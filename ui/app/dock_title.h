// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QList>
#include <QStyle>

class QLabel;
class QToolButton;

namespace flatland::ui {

/// The title of a dock, which grows with the application's type as that of the style does not.
/// Dragged, it moves the dock; a double-click lets it float.
class DockTitle : public QWidget {
  Q_OBJECT

 public:
  explicit DockTitle(QDockWidget& dock);

  void setText(const QString& text);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* addButton(const char* id, QStyle::StandardPixmap icon, const QString& tip);
  void fit();

  QLabel* text_;
  QList<QToolButton*> buttons_;
};

}  // namespace flatland::ui
