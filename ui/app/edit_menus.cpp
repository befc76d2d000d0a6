// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QMenu>
#include <QUndoStack>

#include "ui/app/menus.h"

namespace flatland::ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("EditMenus", text); }

/// The undo stack's own actions, which name the step and know when there is none.
void addUndoActions(QMenu& menu, QUndoStack& stack) {
  QAction* undo = stack.createUndoAction(&menu, tr("&Undo"));
  undo->setObjectName("edit.undo");
  undo->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Z)});
  undo->setStatusTip(tr("Take back the last step"));
  menu.addAction(undo);
  QAction* redo = stack.createRedoAction(&menu, tr("&Redo"));
  redo->setObjectName("edit.redo");
  redo->setShortcuts(
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  redo->setStatusTip(tr("Do the step again that was taken back"));
  menu.addAction(redo);
}

}  // namespace

void buildEditMenu(QMenu& menu, const MenuParts& parts) {
  EditController& edits = parts.edits;
  Selection& selection = parts.models.selection;
  addUndoActions(menu, parts.models.document.undoStack());
  menu.addSeparator();
  addAction(menu,
            {"edit.delete",
             tr("&Delete Points"),
             tr("Remove the selected points"),
             {QKeySequence(Qt::Key_Delete), QKeySequence(Qt::Key_Backspace)}},
            [&edits] { edits.removePoints(); });
  addAction(
      menu,
      {"edit.select-all", tr("Select &All"), tr("Select all points"), {QKeySequence::SelectAll}},
      [&selection] { selection.selectAll(); });
}

void buildCurveMenu(QMenu& menu, const MenuParts& parts) {
  EditController& edits = parts.edits;
  addAction(menu,
            {"curve.add",
             tr("&Add Curve"),
             tr("Add a curve in the middle of the picture"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A)}},
            [&edits] { edits.addCurve(); });
  QAction* remove =
      addAction(menu, {"curve.remove", tr("&Remove Curve"), tr("Remove the curve picked last")},
                [&edits] { edits.removeCurve(); });
  menu.addSeparator();
  QAction* raise = addAction(menu,
                             {"curve.raise",
                              tr("Raise &Degree"),
                              tr("One control point more in every piece; the shape stays"),
                              {QKeySequence(Qt::CTRL | Qt::Key_D)}},
                             [&edits] { edits.raiseDegree(); });
  QAction* flip = addAction(menu,
                            {"curve.flip",
                             tr("&Flip Normal"),
                             tr("Turn the normal round: ridges and valleys change places"),
                             {QKeySequence(Qt::Key_N)}},
                            [&edits] { edits.flipNormal(); });
  menu.addSeparator();
  QAction* reset = addAction(menu,
                             {"curve.reset",
                              tr("Re&set"),
                              tr("Back to where this scene began"),
                              {QKeySequence(Qt::CTRL | Qt::Key_R)}},
                             [&edits] { edits.reset(); });
  Document& document = parts.models.document;
  const auto refresh = [&document, remove, raise, flip, reset] {
    const bool any = !document.scene().curves.empty();
    for (QAction* action : {remove, raise, flip}) action->setEnabled(any);
    reset->setText(document.originName().isEmpty()
                       ? tr("Re&set to File as Opened")
                       : tr("Re&set to Preset “%1”").arg(document.originName()));
  };
  QObject::connect(&document, &Document::changed, &menu, [refresh](const Change& change) {
    if (change.what == Change::What::Topology || change.what == Change::What::Scene) refresh();
  });
  refresh();
}

}  // namespace flatland::ui
