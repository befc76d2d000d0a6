// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/formula_view.h"

#include <QEvent>
#include <QFile>
#include <QPainter>
#include <QSvgRenderer>
#include <algorithm>

namespace flatland::ui {

namespace {

constexpr double kLargestEnlargement = 1.5;  ///< of the file's size, for a font near 20 px

}  // namespace

FormulaView::FormulaView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

FormulaView::~FormulaView() = default;

QString FormulaView::fileOf(DerivationStep step, bool printed) {
  const DerivationStepText& text = textOf(step);
  return QStringLiteral(":/lesson/formulas/") +
         QString::fromUtf8(text.id.data(), static_cast<qsizetype>(text.id.size())) +
         (printed && text.isMisprinted() ? "-printed.svg" : ".svg");
}

void FormulaView::show(std::optional<DerivationStep> step, bool printed) {
  const QString file = step ? fileOf(*step, printed) : QString();
  if (file == file_) return;
  file_ = file;
  load();
}

void FormulaView::load() {
  renderer_.reset();
  QFile file(file_);
  if (!file_.isEmpty() && file.open(QIODevice::ReadOnly)) {
    // Qt's renderer takes currentColor for black.
    QByteArray svg = file.readAll();
    svg.replace("currentColor", palette().color(QPalette::WindowText).name().toLatin1());
    renderer_ = std::make_unique<QSvgRenderer>(svg);
    if (!renderer_->isValid()) renderer_.reset();
  }
  update();
}

void FormulaView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) load();
  QWidget::changeEvent(event);
}

void FormulaView::paintEvent(QPaintEvent*) {
  if (!renderer_) return;
  const QSizeF natural = renderer_->defaultSize();
  const double largest = kLargestEnlargement * fontMetrics().height() / 17.0;
  const double scale = std::min({width() / natural.width(), height() / natural.height(), largest});
  const QSizeF size = natural * scale;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer_->render(&painter, QRectF(QPointF(0.0, (height() - size.height()) / 2.0), size));
}

}  // namespace flatland::ui
