// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class QLabel;

namespace flatland::ui {

/// Fields and buttons side by side, in as many rows as the width asks for: so a panel needs no
/// scrolling sideways where words are long or type is large. Fields that may grow fill their row.
class WrapRow : public QWidget {
  Q_OBJECT

 public:
  explicit WrapRow(QWidget* parent = nullptr);

  /// At the end; the row becomes its parent.
  void add(QWidget* widget);
  /// A field with its name before it, never parted; it grows.
  void add(const QString& name, QWidget* field);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();

  QList<QWidget*> items_;
};

}  // namespace flatland::ui
