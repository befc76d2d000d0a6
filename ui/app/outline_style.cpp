// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/outline_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace flatland::ui {

namespace {

/// Between text and background: at least 3 : 1 in both dark themes, and quieter than text.
QColor edgeColour(const QPalette& palette) {
  const QColor text = palette.color(QPalette::WindowText);
  const QColor window = palette.color(QPalette::Window);
  const auto mix = [](int a, int b) { return (3 * a + 2 * b) / 5; };
  return {mix(text.red(), window.red()), mix(text.green(), window.green()),
          mix(text.blue(), window.blue())};
}

void drawEdge(QPainter& painter, const QStyleOption& option, double radius) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(edgeColour(option.palette), 1.0));
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
  painter.restore();
}

}  // namespace

OutlineStyle::OutlineStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

void OutlineStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                 QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  switch (element) {
    case PE_IndicatorCheckBox:
    case PE_PanelButtonCommand:
    case PE_FrameLineEdit:
      drawEdge(*painter, *option, 2.0);
      break;
    case PE_IndicatorRadioButton:
      drawEdge(*painter, *option, 0.5 * option->rect.height());
      break;
    default:
      break;
  }
}

void OutlineStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                      QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (control == CC_SpinBox || control == CC_ComboBox) drawEdge(*painter, *option, 2.0);
}

}  // namespace flatland::ui
