// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/dock_title.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/panels/elided_label.h"

namespace flatland::ui {

DockTitle::DockTitle(QDockWidget& dock) : QWidget(&dock), text_(new ElidedLabel(this)) {
  text_->setText(dock.windowTitle());
  text_->setObjectName("dock." + dock.objectName() + ".title");
  QToolButton* floating =
      addButton("float", QStyle::SP_TitleBarNormalButton, tr("Move the panel out of the window"));
  QToolButton* close =
      addButton("close", QStyle::SP_TitleBarCloseButton, tr("Close; the View menu opens it again"));
  connect(floating, &QToolButton::clicked, &dock,
          [&dock] { dock.setFloating(!dock.isFloating()); });
  connect(close, &QToolButton::clicked, &dock, &QDockWidget::close);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(5, 2, 2, 0);
  row->setSpacing(1);
  row->addWidget(text_, 1);
  for (QToolButton* button : buttons_) row->addWidget(button);
  fit();
}

QToolButton* DockTitle::addButton(const char* id, QStyle::StandardPixmap icon, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName("dock." + parent()->objectName() + QLatin1Char('.') + QLatin1String(id));
  button->setIcon(style()->standardIcon(icon, nullptr, this));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);  // the View menu does the same by keys
  buttons_ << button;
  return button;
}

void DockTitle::setText(const QString& text) { text_->setText(text); }

void DockTitle::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) fit();
  QWidget::changeEvent(event);
}

void DockTitle::fit() {
  const int side = fontMetrics().height();
  for (QToolButton* button : buttons_) {
    button->setIconSize({side * 4 / 5, side * 4 / 5});
    button->setFixedSize(side, side);
  }
}

}  // namespace flatland::ui
