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

struct Line {
  QString keys, effect;
};
struct Section {
  QString title;
  std::vector<Line> lines;
};

std::vector<Section> leftColumn() {
  return {
      {KeySheet::tr("Points"),
       {{KeySheet::tr("Drag"), KeySheet::tr("Move the point, or the whole curve")},
        {KeySheet::tr("Ctrl + drag"), KeySheet::tr("Along one axis")},
        {KeySheet::tr("Alt + drag"), KeySheet::tr("Leave its handles behind")},
        {KeySheet::tr("Double-click on the curve"), KeySheet::tr("Insert a point, shape kept")},
        {KeySheet::tr("Click, Shift + click"), KeySheet::tr("Select, select more")},
        {KeySheet::tr("Drag on nothing"), KeySheet::tr("Select by rectangle")},
        {KeySheet::tr("Tab, Shift + Tab"), KeySheet::tr("Next, previous point")},
        {KeySheet::tr("Arrow keys"), KeySheet::tr("Move the selected points")},
        {KeySheet::tr("Shift + arrow"), KeySheet::tr("Ten times as far")},
        {KeySheet::tr("Ctrl or Alt + arrow"), KeySheet::tr("A tenth as far")},
        {KeySheet::tr("Delete"), KeySheet::tr("Remove the selected points")},
        {KeySheet::tr("Esc"), KeySheet::tr("Take back a drag; deselect; no probe")}}},
      {KeySheet::tr("Curves"),
       {{KeySheet::tr("Ctrl + Shift + A"), KeySheet::tr("Add a curve")},
        {KeySheet::tr("Ctrl + D"), KeySheet::tr("Raise the degree")},
        {KeySheet::tr("N"), KeySheet::tr("Flip the normal")},
        {KeySheet::tr("Ctrl + R"), KeySheet::tr("Reset")}}},
  };
}

std::vector<Section> rightColumn() {
  return {
      {KeySheet::tr("Viewer"),
       {{KeySheet::tr("Drag the eye"), KeySheet::tr("Turn the view")},
        {KeySheet::tr("Shift + drag"), KeySheet::tr("In steps of 15°")},
        {KeySheet::tr("Ctrl + drag"), KeySheet::tr("Keep the distance (perspective)")},
        {KeySheet::tr("1 2 3 4"), KeySheet::tr("View from 0°, 90°, 180°, 270°")},
        {KeySheet::tr("P"), KeySheet::tr("Perspective on or off")}}},
      {KeySheet::tr("Picture"),
       {{KeySheet::tr("Wheel, pinch"), KeySheet::tr("Zoom at the pointer")},
        {KeySheet::tr("Middle button, Space + drag"), KeySheet::tr("Move the picture")},
        {KeySheet::tr("Two fingers on a trackpad"), KeySheet::tr("Move the picture")},
        {KeySheet::tr("F"), KeySheet::tr("Fit the scene")},
        {KeySheet::tr("C"), KeySheet::tr("Control polygon on or off")},
        {KeySheet::tr("D"), KeySheet::tr("Hidden parts on or off")},
        {KeySheet::tr("F6"), KeySheet::tr("Focus to the next panel")}}},
      {KeySheet::tr("Probe and plots"),
       {{KeySheet::tr("Click on the curve, K"), KeySheet::tr("Put the probe there")},
        {KeySheet::tr("Drag the ring"), KeySheet::tr("Slide it along the curve")},
        {KeySheet::tr(", and ."), KeySheet::tr("Back, forward; Shift ten times")},
        {KeySheet::tr("M, Shift + M"), KeySheet::tr("Next, previous mark")},
        {KeySheet::tr("[ and ]"), KeySheet::tr("Shorter, longer comb")},
        {KeySheet::tr("+ − 0 in a plot"), KeySheet::tr("Zoom, show all")}}},
      {KeySheet::tr("Sweep panel"),
       {{KeySheet::tr("Left, Right"), KeySheet::tr("Turn the view by 1°")},
        {KeySheet::tr("Shift, Ctrl + the same"), KeySheet::tr("By 0.1°, to the next event")},
        {KeySheet::tr("Space"), KeySheet::tr("Turn once around; Esc goes back")}}},
      {KeySheet::tr("Files and steps"),
       {{KeySheet::tr("Ctrl + N, O, S"), KeySheet::tr("New, open, save")},
        {KeySheet::tr("Ctrl + Shift + S"), KeySheet::tr("Save as")},
        {KeySheet::tr("Ctrl + E"), KeySheet::tr("Export the picture")},
        {KeySheet::tr("Ctrl + Z"), KeySheet::tr("Undo")},
        {KeySheet::tr("Ctrl + Shift + Z, Ctrl + Y"), KeySheet::tr("Redo")},
        {KeySheet::tr("H, ?"), KeySheet::tr("This sheet")}}},
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
