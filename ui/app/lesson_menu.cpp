// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include "ui/app/menus.h"

namespace flatland::ui {

namespace {

struct LessonMenuWords {
  Q_DECLARE_TR_FUNCTIONS(LessonMenu)
};

void fillRecent(QMenu& menu, LessonFiles& files) {
  menu.clear();
  for (const QString& name : files.recentFiles()) {
    QAction* action = addAction(menu,
                                {"lesson.recent", QFileInfo(name).fileName().replace('&', "&&"),
                                 QDir::toNativeSeparators(name)},
                                [&files, name] { files.openFile(name); });
    action->setEnabled(QFileInfo::exists(name));
  }
  if (menu.isEmpty()) {
    addAction(menu, {"lesson.recent.none", LessonMenuWords::tr("No recent lessons"), {}}, [] {
    })->setEnabled(false);
  }
}

}  // namespace

void buildLessonMenu(QMenu& menu, const MenuParts& parts) {
  LessonFiles& files = parts.lessons;
  LessonModel& lesson = parts.lesson;
  for (const LessonFiles::Shipped& shipped : files.shipped()) {
    addAction(menu, {"lesson.shipped", shipped.title, LessonMenuWords::tr("Start this lesson")},
              [&files, shipped] { files.openFile(shipped.file); })
        ->setObjectName("lesson.shipped." + QFileInfo(shipped.file).completeBaseName());
  }
  addAction(menu,
            {"lesson.open", LessonMenuWords::tr("Open &Lesson…"),
             LessonMenuWords::tr("Open a lesson of your own")},
            [&files] { files.open(); });
  QMenu* recent = menu.addMenu(LessonMenuWords::tr("Open &Recent Lesson"));
  recent->setObjectName("menu.lesson.recent");
  QObject::connect(recent, &QMenu::aboutToShow, recent,
                   [recent, &files] { fillRecent(*recent, files); });
  menu.addSeparator();
  const QList<QAction*> steps{
      addAction(menu,
                {"lesson.step.next",
                 LessonMenuWords::tr("&Next Step"),
                 LessonMenuWords::tr("On to the next step"),
                 {QKeySequence(Qt::Key_PageDown)}},
                [&lesson] { lesson.next(); }),
      addAction(menu,
                {"lesson.step.back",
                 LessonMenuWords::tr("Step &Back"),
                 LessonMenuWords::tr("Back to the step before"),
                 {QKeySequence(Qt::Key_PageUp)}},
                [&lesson] { lesson.back(); }),
      addAction(menu,
                {"lesson.step.stop",
                 LessonMenuWords::tr("Next &Stop"),
                 LessonMenuWords::tr("On to the next step that is a stop"),
                 {QKeySequence(Qt::SHIFT | Qt::Key_PageDown)}},
                [&lesson] { lesson.nextStop(); }),
      addAction(menu,
                {"lesson.step.first",
                 LessonMenuWords::tr("&First Step"),
                 LessonMenuWords::tr("Back to the beginning"),
                 {QKeySequence(Qt::Key_Home)}},
                [&lesson] { lesson.first(); }),
      addAction(menu,
                {"lesson.step.again", LessonMenuWords::tr("Scene of This Step &Again"),
                 LessonMenuWords::tr("The scene as the lesson has it, whatever was dragged")},
                [&lesson] { lesson.showAgain(); }),
      addAction(menu,
                {"lesson.step.leave", LessonMenuWords::tr("Lea&ve Lesson"),
                 LessonMenuWords::tr("Back to your own scene")},
                [&lesson] { lesson.leave(); })};
  const auto refresh = [steps, &lesson] {
    for (QAction* action : steps) action->setEnabled(lesson.isOpen());
  };
  QObject::connect(&lesson, &LessonModel::changed, &menu, refresh);
  refresh();
}

}  // namespace flatland::ui
