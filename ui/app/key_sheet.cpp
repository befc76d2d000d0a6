// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/key_sheet.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <vector>

namespace flatland::ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("KeySheet", text); }

struct Line {
  QString keys, effect;
};
struct Section {
  QString title;
  std::vector<Line> lines;
};

std::vector<Section> leftColumn() {
  return {
      {tr("Points"),
       {{tr("Drag"), tr("Move the point, or the whole curve")},
        {tr("Ctrl + drag"), tr("Along one axis")},
        {tr("Alt + drag"), tr("Leave its handles behind")},
        {tr("Double-click on the curve"), tr("Insert a point, shape kept")},
        {tr("Click, Shift + click"), tr("Select, select more")},
        {tr("Drag on nothing"), tr("Select by rectangle")},
        {tr("Tab, Shift + Tab"), tr("Next, previous point")},
        {tr("Arrow keys"), tr("Move the selected points")},
        {tr("Shift + arrow"), tr("Ten times as far")},
        {tr("Ctrl or Alt + arrow"), tr("A tenth as far")},
        {tr("Delete"), tr("Remove the selected points")},
        {tr("Esc"), tr("Take back a drag; deselect")}}},
      {tr("Curves"),
       {{tr("Ctrl + Shift + A"), tr("Add a curve")},
        {tr("Ctrl + D"), tr("Raise the degree")},
        {tr("N"), tr("Flip the normal")},
        {tr("Ctrl + R"), tr("Reset")}}},
  };
}

std::vector<Section> rightColumn() {
  return {
      {tr("Viewer"),
       {{tr("Drag the eye"), tr("Turn the view")},
        {tr("Shift + drag"), tr("In steps of 15°")},
        {tr("Ctrl + drag"), tr("Keep the distance (perspective)")},
        {tr("1 2 3 4"), tr("View from 0°, 90°, 180°, 270°")},
        {tr("P"), tr("Perspective on or off")}}},
      {tr("Picture"),
       {{tr("Wheel, pinch"), tr("Zoom at the pointer")},
        {tr("Middle button, Space + drag"), tr("Move the picture")},
        {tr("Two fingers on a trackpad"), tr("Move the picture")},
        {tr("F"), tr("Fit the scene")},
        {tr("C"), tr("Control polygon on or off")},
        {tr("D"), tr("Hidden parts on or off")},
        {tr("F6"), tr("Focus to the next panel")}}},
      {tr("Files and steps"),
       {{tr("Ctrl + N, O, S"), tr("New, open, save")},
        {tr("Ctrl + Shift + S"), tr("Save as")},
        {tr("Ctrl + E"), tr("Export the picture")},
        {tr("Ctrl + Z"), tr("Undo")},
        {tr("Ctrl + Shift + Z, Ctrl + Y"), tr("Redo")},
        {tr("H, ?"), tr("This sheet")}}},
  };
}

QWidget* makeColumn(const std::vector<Section>& sections) {
  auto* column = new QWidget;
  auto* grid = new QGridLayout(column);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(3);
  int row = 0;
  for (const Section& section : sections) {
    auto* title = new QLabel(section.title);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    title->setContentsMargins(0, row == 0 ? 0 : 10, 0, 2);
    grid->addWidget(title, row++, 0, 1, 2);
    for (const Line& line : section.lines) {
      grid->addWidget(new QLabel(line.keys), row, 0);
      grid->addWidget(new QLabel(line.effect), row++, 1);
    }
  }
  grid->setRowStretch(row, 1);
  return column;
}

}  // namespace

KeySheet::KeySheet(QWidget* parent) : QDialog(parent) {
  setObjectName("keys");
  setWindowTitle(tr("Keys and gestures"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(28);
  columns->addWidget(makeColumn(leftColumn()));
  columns->addWidget(makeColumn(rightColumn()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns);
  layout->addWidget(buttons);
}

void KeySheet::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_H || event->key() == Qt::Key_Question) {
    reject();
  } else {
    QDialog::keyPressEvent(event);
  }
}

}  // namespace flatland::ui
