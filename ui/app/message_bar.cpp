// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

namespace flatland::ui {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), symbol_(new QLabel(this)), label_(new QLabel(this)) {
  setObjectName("message");
  setAccessibleName(tr("Message"));
  setFrameShape(QFrame::StyledPanel);
  // Black on a warm yellow or a pale blue reads 15 : 1, in a light theme as in a dark one.
  setStyleSheet(
      "#message { background: #dcebf7; border: 1px solid #6a9fc9; }"
      "#message[error=\"true\"] { background: #fbe8a6; border: 1px solid #c9a227; }"
      "#message QLabel { color: #1a1a1a; }");
  label_->setObjectName("message.text");
  label_->setAccessibleName(tr("Message"));
  label_->setToolTip(tr("What went wrong; the text can be selected"));
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton(this);
  close->setObjectName("message.close");
  close->setIcon(style()->standardIcon(QStyle::SP_DockWidgetCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 5, 5, 5);
  layout->addWidget(symbol_, 0, Qt::AlignTop);
  layout->addWidget(label_, 1);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBar::showError(const QString& text) { show(text, true); }

void MessageBar::showNote(const QString& text) { show(text, false); }

void MessageBar::show(const QString& text, bool isError) {
  const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
  const auto icon = isError ? QStyle::SP_MessageBoxWarning : QStyle::SP_MessageBoxInformation;
  symbol_->setPixmap(style()->standardIcon(icon).pixmap(size, size));
  label_->setText(text);
  setProperty("error", isError);
  style()->unpolish(this);
  style()->polish(this);
  QWidget::show();
}

QString MessageBar::text() const { return label_->text(); }

}  // namespace flatland::ui
