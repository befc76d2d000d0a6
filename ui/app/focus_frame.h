// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFocusFrame>
#include <QPointer>

namespace flatland::ui {

/// A clear frame around the widget that has the focus, once the keyboard has moved it: what styles
/// draw there is often a hair line. Widgets with the property "drawsFocus" do it themselves.
class FocusFrame : public QObject {
  Q_OBJECT

 public:
  explicit FocusFrame(QObject* parent);
  ~FocusFrame() override;

 private:
  void follow(QWidget* now);

  QPointer<QFocusFrame> frame_;  ///< it goes with the parent of the widget it is around
};

}  // namespace flatland::ui
