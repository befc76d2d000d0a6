// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenu>
#include <QUndoStack>

#include "ui/app/menus.h"
#include "ui/model/new_curves.h"

namespace flatland::ui {

namespace {

struct EditMenusWords {
  Q_DECLARE_TR_FUNCTIONS(EditMenus)
};

/// The undo stack's own actions, which name the step and know when there is none.
void addUndoActions(QMenu& menu, QUndoStack& stack) {
  QAction* undo = stack.createUndoAction(&menu, EditMenusWords::tr("&Undo"));
  undo->setObjectName("edit.undo");
  undo->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Z)});
  undo->setStatusTip(EditMenusWords::tr("Take back the last step"));
  menu.addAction(undo);
  QAction* redo = stack.createRedoAction(&menu, EditMenusWords::tr("&Redo"));
  redo->setObjectName("edit.redo");
  redo->setShortcuts(
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  redo->setStatusTip(EditMenusWords::tr("Do the step again that was taken back"));
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
             EditMenusWords::tr("&Delete Points"),
             EditMenusWords::tr("Remove the selected points"),
             {QKeySequence(Qt::Key_Delete), QKeySequence(Qt::Key_Backspace)}},
            [&edits] { edits.removePoints(); });
  addAction(menu,
            {"edit.select-all",
             EditMenusWords::tr("Select &All"),
             EditMenusWords::tr("Select all points"),
             {QKeySequence::SelectAll}},
            [&selection] { selection.selectAll(); });
}

void buildCurveMenu(QMenu& menu, const MenuParts& parts) {
  EditController& edits = parts.edits;
  addAction(menu,
            {"curve.add",
             EditMenusWords::tr("&Add Curve"),
             EditMenusWords::tr("Add a curve beside those there are"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A)}},
            [&edits] { edits.addCurve(); });
  QMenu& kinds = addSubmenu(menu, "curve.new", EditMenusWords::tr("&New"));
  for (const NewCurve& kind : newCurves()) {
    const QByteArray id = "curve.new." + kind.id.toLatin1();
    addAction(
        kinds,
        {id.constData(), kind.title,
         EditMenusWords::tr("Add such a curve beside those there are; the panel Curve has its "
                            "numbers")},
        [&edits, id = kind.id, docks = parts.docks] {
          edits.addCurve(id);
          for (QDockWidget* dock : docks) {
            if (dock->objectName() != QLatin1String("curve")) continue;
            dock->show();
            dock->raise();
          }
        });
  }
  ImportController& imports = parts.imports;
  addAction(menu,
            {"curve.import-glyph",
             EditMenusWords::tr("Import &Glyph…"),
             EditMenusWords::tr("Add the outline of a letter to this scene"),
             {QKeySequence(Qt::CTRL | Qt::Key_G)}},
            [&imports] { imports.importGlyph(); });
  QAction* remove = addAction(menu,
                              {"curve.remove", EditMenusWords::tr("&Remove Curve"),
                               EditMenusWords::tr("Remove the curve picked last")},
                              [&edits] { edits.removeCurve(); });
  menu.addSeparator();
  QAction* raise =
      addAction(menu,
                {"curve.raise",
                 EditMenusWords::tr("Raise &Degree"),
                 EditMenusWords::tr("One control point more in every piece; the shape stays"),
                 {QKeySequence(Qt::CTRL | Qt::Key_D)}},
                [&edits] { edits.raiseDegree(); });
  QAction* flip =
      addAction(menu,
                {"curve.flip",
                 EditMenusWords::tr("&Flip Normal"),
                 EditMenusWords::tr("Turn the normal round: ridges and valleys change places"),
                 {QKeySequence(Qt::Key_N)}},
                [&edits] { edits.flipNormal(); });
  menu.addSeparator();
  QAction* reset = addAction(menu,
                             {"curve.reset",
                              EditMenusWords::tr("Re&set"),
                              EditMenusWords::tr("Back to where this scene began"),
                              {QKeySequence(Qt::CTRL | Qt::Key_R)}},
                             [&edits] { edits.reset(); });
  Document& document = parts.models.document;
  const auto refresh = [&document, remove, raise, flip, reset] {
    const bool any = !document.scene().curves.empty();
    for (QAction* action : {remove, raise, flip}) action->setEnabled(any);
    reset->setText(document.originName().isEmpty()
                       ? EditMenusWords::tr("Re&set to File as Opened")
                       : EditMenusWords::tr("Re&set to Preset “%1”").arg(document.originName()));
  };
  QObject::connect(&document, &Document::changed, &menu, [refresh](const Change& change) {
    if (change.what == Change::What::Topology || change.what == Change::What::Scene) refresh();
  });
  refresh();
}

}  // namespace flatland::ui
