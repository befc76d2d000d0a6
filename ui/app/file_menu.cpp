// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <map>

#include "ui/app/menus.h"
#include "ui/model/core_words.h"

namespace flatland::ui {

namespace {

struct FileMenuWords {
  Q_DECLARE_TR_FUNCTIONS(FileMenu)
};

/// Filled anew each time it opens, so that files that went away or came back show as they are.
void fillRecent(QMenu& menu, FileController& files) {
  menu.clear();
  const QStringList names = files.recentFiles();
  for (qsizetype i = 0; i < names.size(); ++i) {
    const QString& name = names[i];
    QString label = QFileInfo(name).fileName();
    label.replace('&', "&&");
    const bool exists = QFileInfo::exists(name);
    if (!exists) label = FileMenuWords::tr("%1 (gone)").arg(label);
    QAction* action = addAction(menu,
                                {"file.recent", QStringLiteral("&%1  %2").arg(i + 1).arg(label),
                                 QDir::toNativeSeparators(name)},
                                [&files, name] { files.openFile(name); });
    action->setEnabled(exists);
  }
  if (names.isEmpty()) {
    addAction(menu, {"file.recent.none", FileMenuWords::tr("No recent files"), {}}, [] {
    })->setEnabled(false);
  } else {
    menu.addSeparator();
    addAction(menu,
              {"file.recent.clear", FileMenuWords::tr("&Clear List"),
               FileMenuWords::tr("Forget all recent files")},
              [&files] { files.clearRecentFiles(); });
  }
}

/// One submenu for each group, in the order of the presets.
void fillPresets(QMenu& menu, FileController& files) {
  std::map<std::string, QMenu*> groups;
  for (const Preset& preset : allPresets()) {
    QMenu*& group = groups[preset.group];
    if (!group) {
      group = &addSubmenu(menu, "", coreWords(preset.group));
      group->setObjectName("menu.file.presets." + QString::number(groups.size()));
    }
    addAction(*group, {"file.preset", presetName(preset), coreWords(preset.description)},
              [&files, &preset] { files.startPreset(preset); })
        ->setObjectName("file.preset." + QString::fromStdString(preset.id));
  }
}

}  // namespace

void buildFileMenu(QMenu& menu, const MenuParts& parts) {
  FileController& files = parts.files;
  addAction(menu,
            {"file.new",
             FileMenuWords::tr("&New"),
             FileMenuWords::tr("Start over with the first preset"),
             {QKeySequence::New}},
            [&files] { files.startNew(); });
  addAction(menu,
            {"file.open",
             FileMenuWords::tr("&Open…"),
             FileMenuWords::tr("Open a scene file or an SVG drawing"),
             {QKeySequence::Open}},
            [&files] { files.open(); });
  ImportController& imports = parts.imports;
  addAction(menu,
            {"file.import-svg",
             FileMenuWords::tr("&Import SVG…"),
             FileMenuWords::tr("Add the outlines of a drawing to this scene"),
             {QKeySequence(Qt::CTRL | Qt::Key_I)}},
            [&imports] { imports.importSvg(); });
  QMenu& recent = addSubmenu(menu, "menu.file.recent", FileMenuWords::tr("Open &Recent"));
  QObject::connect(&recent, &QMenu::aboutToShow, &recent,
                   [&recent, &files] { fillRecent(recent, files); });
  fillRecent(recent, files);
  fillPresets(addSubmenu(menu, "menu.file.presets", FileMenuWords::tr("&Presets")), files);
  menu.addSeparator();
  addAction(menu,
            {"file.save",
             FileMenuWords::tr("&Save"),
             FileMenuWords::tr("Save the scene"),
             {QKeySequence::Save}},
            [&files] { files.save(); });
  addAction(menu,
            {"file.save-as",
             FileMenuWords::tr("Save &As…"),
             FileMenuWords::tr("Save the scene under another name"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}},
            [&files] { files.saveAs(); });
  addAction(menu,
            {"file.export", FileMenuWords::tr("&Export…"),
             FileMenuWords::tr("Write the picture as SVG, PDF, PNG or TikZ")},
            parts.exportFigure);
  menu.addSeparator();
  QMainWindow& window = parts.window;
  addAction(menu,
            {"file.quit",
             FileMenuWords::tr("&Quit"),
             FileMenuWords::tr("Close the window"),
             {QKeySequence(Qt::CTRL | Qt::Key_Q)}},
            [&window] { window.close(); });
}

}  // namespace flatland::ui
