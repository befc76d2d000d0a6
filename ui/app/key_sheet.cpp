// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/key_sheet.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <vector>

namespace flatland::ui {

namespace {

constexpr int kBesidePx = 60;  // margins and scroll bar

struct Line {
  QString keys, effect;
};
struct Section {
  QString title;
  std::vector<Line> lines;
};

/// What the mouse does, and the keys that belong to the canvas and are in no menu.
std::vector<Section> gestures() {
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
        {KeySheet::tr("Esc"),
         KeySheet::tr("Take back a drag; deselect; no probe; leave projector")}}},
      {KeySheet::tr("Viewer"),
       {{KeySheet::tr("Drag the eye"), KeySheet::tr("Turn the view")},
        {KeySheet::tr("Shift + drag"), KeySheet::tr("In steps of 15°")},
        {KeySheet::tr("Ctrl + drag"), KeySheet::tr("Keep the distance (perspective)")}}},
      {KeySheet::tr("Picture"),
       {{KeySheet::tr("Wheel, pinch, Ctrl + wheel"), KeySheet::tr("Zoom at the pointer")},
        {KeySheet::tr("Middle button, Space + drag"), KeySheet::tr("Move the picture")},
        {KeySheet::tr("Two fingers on a trackpad"), KeySheet::tr("Move the picture")}}},
      {KeySheet::tr("Probe and plots"),
       {{KeySheet::tr("Click on the curve"), KeySheet::tr("Put the probe there")},
        {KeySheet::tr("Drag the ring"), KeySheet::tr("Slide it along the curve")},
        {KeySheet::tr("+ − 0 in a plot"), KeySheet::tr("Zoom, show all")}}},
      {KeySheet::tr("Surface"),
       {{KeySheet::tr("Drag, Ctrl + drag"), KeySheet::tr("Turn, roll")},
        {KeySheet::tr("Shift + drag, middle button"), KeySheet::tr("Move")},
        {KeySheet::tr("1 3 7, 9"), KeySheet::tr("Front, right, top; opposite side")},
        {KeySheet::tr("Click; P"), KeySheet::tr("Pick the point there, in the middle")},
        {KeySheet::tr("5, F, R, Space"), KeySheet::tr("Perspective, fit, reset, spin")},
        {KeySheet::tr("[ ], C"), KeySheet::tr("Move the plane; arrow keys turn it")}}},
      {KeySheet::tr("Sweep panel"),
       {{KeySheet::tr("Left, Right"), KeySheet::tr("Turn the view by 1°")},
        {KeySheet::tr("Shift, Ctrl + the same"), KeySheet::tr("By 0.1°, to the next event")},
        {KeySheet::tr("Space"), KeySheet::tr("Turn once around; Esc goes back")}}},
  };
}

QString plainText(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

/// The keys of a menu, its menus included, as the actions have them: so the sheet cannot go stale.
void addLines(const QMenu& menu, std::vector<Line>& lines) {
  for (const QAction* action : menu.actions()) {
    if (action->menu()) addLines(*action->menu(), lines);
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) {
      const QString text = key.toString(QKeySequence::NativeText);
      if (!keys.contains(text)) keys << text;
    }
    if (!keys.isEmpty()) lines.push_back({keys.join(", "), plainText(action->text())});
  }
}

std::vector<std::vector<Section>> columnsOf(const QMainWindow& window) {
  std::vector<std::vector<Section>> columns{gestures(), {}, {}};
  for (const QAction* entry : window.menuBar()->actions()) {
    Section section{plainText(entry->text()), {}};
    addLines(*entry->menu(), section.lines);
    const bool view = entry->menu()->objectName() == QLatin1String("menu.view");
    if (!section.lines.empty()) columns[view ? 2 : 1].push_back(std::move(section));
  }
  return columns;
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

KeySheet::KeySheet(QMainWindow* window) : QDialog(window) {
  setObjectName("keys");
  setWindowTitle(tr("Keys and gestures"));
  auto* sheet = new QWidget;
  auto* columns = new QHBoxLayout(sheet);
  columns->setSpacing(28);
  // As many beside each other as the window has room for, the rest below.
  const int room = window->width() - kBesidePx;
  QVBoxLayout* last = nullptr;
  int used = 0;
  for (const std::vector<Section>& sections : columnsOf(*window)) {
    QWidget* column = makeColumn(sections);
    const int wide = column->sizeHint().width() + columns->spacing();
    if (!last || used + wide <= room) {
      last = new QVBoxLayout;
      columns->addLayout(last);
      used += wide;
    }
    last->addWidget(column);
  }
  auto* area = new QScrollArea(this);
  area->setObjectName("keys.sheet");
  area->setAccessibleName(windowTitle());
  area->setToolTip(tr("H, ? and Esc close this sheet"));
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(sheet);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* close = buttons->button(QDialogButtonBox::Close);
  close->setObjectName("keys.close");
  close->setToolTip(area->toolTip());
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(area);
  layout->addWidget(buttons);
  const QSize wanted = sheet->sizeHint() + QSize(kBesidePx, 80);
  resize(wanted.boundedTo(window->size() - QSize(8, 40)));
}

void KeySheet::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_H || event->key() == Qt::Key_Question) {
    reject();
  } else {
    QDialog::keyPressEvent(event);
  }
}

}  // namespace flatland::ui
