// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/focus_frame.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>

namespace flatland::ui {

namespace {

constexpr double kWidthPx = 2.0;

class Frame : public QFocusFrame {
 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QApplication::palette().color(QPalette::Highlight), kWidthPx));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 3.0, 3.0);
  }
};

}  // namespace

FocusFrame::FocusFrame(QObject* parent) : QObject(parent) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

FocusFrame::~FocusFrame() { delete frame_; }

void FocusFrame::follow(QWidget* now) {
  const bool byKeyboard = now && now->window()->testAttribute(Qt::WA_KeyboardFocusChange);
  if (!byKeyboard || now->property("drawsFocus").toBool() || now->isWindow()) {
    if (frame_) frame_->setWidget(nullptr);
    return;
  }
  if (!frame_) {
    frame_ = new Frame;
    frame_->setObjectName("focus-frame");
  }
  frame_->setWidget(now);
}

}  // namespace flatland::ui
