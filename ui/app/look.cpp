// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/look.h"

#include <QApplication>
#include <QHeaderView>
#include <QStyle>
#include <QTableView>

#include "ui/app/focus_frame.h"
#include "ui/app/outline_style.h"
#include "ui/export/figure_qt.h"

namespace flatland::ui {

namespace {

constexpr int kRowGapPx = 6;  // between the lines of a table

/// The colours a theme sets; the rest of a palette follows from them.
struct ThemeColours {
  QColor window, base, alternate, text, button, highlight, highlightedText, link, faint;
};

QPalette paletteOf(const ThemeColours& c) {
  QPalette palette(c.button, c.window);
  const std::pair<QPalette::ColorRole, QColor> roles[] = {
      {QPalette::Window, c.window},
      {QPalette::Base, c.base},
      {QPalette::AlternateBase, c.alternate},
      {QPalette::WindowText, c.text},
      {QPalette::Text, c.text},
      {QPalette::ButtonText, c.text},
      {QPalette::BrightText, c.text},
      {QPalette::Button, c.button},
      {QPalette::Highlight, c.highlight},
      {QPalette::HighlightedText, c.highlightedText},
      {QPalette::ToolTipBase, c.button},
      {QPalette::ToolTipText, c.text},
      {QPalette::PlaceholderText, c.faint},
      {QPalette::Link, c.link},
      {QPalette::LinkVisited, c.link}};
  for (const auto& [role, colour] : roles) palette.setColor(role, colour);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, c.faint);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, c.faint);
  return palette;
}

QPalette lightPalette() {
  return paletteOf({.window = "#efefef",
                    .base = "#ffffff",
                    .alternate = "#f5f5f5",
                    .text = "#111111",
                    .button = "#f4f4f4",
                    .highlight = "#1f6fb5",
                    .highlightedText = "#ffffff",
                    .link = "#0b57a4",
                    .faint = "#767676"});
}

QPalette darkPalette() {
  const QColor canvas = toQColor(sceneColours(Palette::Dark).background);
  return paletteOf({.window = "#2c2c31",
                    .base = canvas,
                    .alternate = "#27272c",
                    .text = "#f0f0f0",
                    .button = "#42424a",
                    .highlight = "#5aa9e6",
                    .highlightedText = "#101014",
                    .link = "#8cc4f5",
                    .faint = "#9a9aa2"});
}

/// White on black, and yellow for what is picked.
QPalette highContrastPalette() {
  return paletteOf({.window = "#000000",
                    .base = "#000000",
                    .alternate = "#181818",
                    .text = "#ffffff",
                    .button = "#505050",
                    .highlight = "#ffe600",
                    .highlightedText = "#000000",
                    .link = "#9fd3ff",
                    .faint = "#b8b8b8"});
}

QPalette paletteFor(Display::Theme theme, const QPalette& system) {
  switch (theme) {
    case Display::Theme::Light:
      return lightPalette();
    case Display::Theme::Dark:
      return darkPalette();
    case Display::Theme::HighContrast:
      return highContrastPalette();
    case Display::Theme::System:
      break;
  }
  return system;
}

}  // namespace

Look::Look(const Display& display, QObject* parent)
    : QObject(parent),
      display_(display),
      system_(QApplication::palette()),
      systemStyle_(QApplication::style()->objectName()),
      font_(QApplication::font()) {
  new FocusFrame(this);
  connect(&display_, &Display::changed, this, &Look::apply);
  apply();
}

Look::~Look() {
  if (scale_ != 1.0) QApplication::setFont(font_);
  if (theme_ == Display::Theme::System) return;
  QApplication::setStyle(systemStyle_);
  QApplication::setPalette(system_);
}

void Look::apply() {
  if (const Display::Theme theme = display_.theme(); theme != theme_) {
    theme_ = theme;
    const bool dark = theme == Display::Theme::Dark || theme == Display::Theme::HighContrast;
    if (dark) {
      QApplication::setStyle(new OutlineStyle);
    } else {
      QApplication::setStyle(systemStyle_);
    }
    QApplication::setPalette(paletteFor(theme, system_));
  }
  const double scale = display_.uiScale();
  if (scale == scale_) return;
  QFont font = font_;
  if (font.pointSizeF() > 0.0) {
    font.setPointSizeF(font.pointSizeF() * scale);
  } else {
    font.setPixelSize(qRound(font.pixelSize() * scale));
  }
  const double factor = scale / scale_;
  scale_ = scale;
  QApplication::setFont(font);
  scaleTables(factor);
}

void Look::scaleTables(double factor) {
  for (QWidget* widget : QApplication::allWidgets()) {
    auto* table = qobject_cast<QTableView*>(widget);
    if (!table) continue;
    QHeaderView& rows = *table->verticalHeader();
    // From the new type: a table that is hidden has not heard of it yet, and its header would keep
    // the rows as high as the old one.
    rows.setMinimumSectionSize(1);
    rows.setDefaultSectionSize(QFontMetrics(QApplication::font()).height() + kRowGapPx);
    QHeaderView& columns = *table->horizontalHeader();
    for (int i = 0; i < columns.count(); ++i) {
      if (columns.sectionResizeMode(i) == QHeaderView::Interactive) {
        columns.resizeSection(i, qRound(columns.sectionSize(i) * factor));
      }
    }
  }
}

}  // namespace flatland::ui
