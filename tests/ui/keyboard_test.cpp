// SPDX-License-Identifier: GPL-3.0-or-later
// The window without a mouse, and for those who do not see it: keys, focus, names of widgets.
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFocusFrame>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QTabBar>
#include <QToolTip>

#include "tests/ui/support_window.h"
#include "ui/app/key_sheet.h"

namespace flatland::ui {

namespace {

/// Widgets that are parts of others and take no name of their own.
bool isPart(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_")) return true;
  if (qobject_cast<const QLineEdit*>(&widget) &&
      (qobject_cast<QAbstractSpinBox*>(widget.parentWidget()) ||
       qobject_cast<QComboBox*>(widget.parentWidget()))) {
    return true;
  }
  return widget.inherits("QTabBar") || widget.inherits("QMenu") || widget.inherits("QHeaderView") ||
         widget.inherits("QScrollBar") || widget.inherits("QComboBoxListView") ||
         widget.inherits("QDockWidgetTitleButton") || widget.inherits("QToolBarExtension") ||
         widget.inherits("QComboBoxPrivateContainer") || widget.inherits("QTableCornerButton") ||
         qobject_cast<const QTabBar*>(widget.parentWidget());
}

bool hasLabel(const QWidget& widget, const QWidget& window) {
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (label->buddy() == &widget) return true;
  }
  return false;
}

/// "&Open…" -> 'O'; none: a null character.
QChar mnemonicOf(const QString& text) {
  for (qsizetype i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '&') continue;
    if (text[i + 1] != '&') return text[i + 1].toUpper();
    ++i;
  }
  return {};
}

QStringList clashesIn(const QMenu& menu) {
  QStringList clashes;
  QMap<QChar, QString> seen;
  for (const QAction* action : menu.actions()) {
    if (action->menu()) clashes += clashesIn(*action->menu());
    const QChar key = mnemonicOf(action->text());
    if (key.isNull()) continue;
    if (seen.contains(key)) {
      clashes << QStringLiteral("%1: %2, %3").arg(menu.objectName(), seen[key], action->text());
    }
    seen[key] = action->text();
  }
  return clashes;
}

}  // namespace

class KeyboardTest : public QObject {
  Q_OBJECT

 private slots:
  void noKeyDoesTwoThings() {
    WindowDriver driver;
    QMap<QString, QString> owners;
    QStringList clashes;
    int keys = 0;
    for (const QAction* action : driver.window().findChildren<QAction*>()) {
      for (const QKeySequence& key : action->shortcuts()) {
        ++keys;
        // A key of a panel counts only while the panel has the focus; one of a menu always.
        const QString text = key.toString();
        if (owners.contains(text) && owners[text] != action->objectName()) {
          clashes << text + ": " + owners[text] + ", " + action->objectName();
        }
        owners[text] = action->objectName();
      }
    }
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join("\n")));
    QVERIFY(keys > 25);
    QVERIFY(owners.contains("F11"));
  }

  void noTwoEntriesOfAMenuHaveTheSameLetter() {
    WindowDriver driver;
    QStringList clashes;
    for (const QAction* action : driver.window().menuBar()->actions()) {
      clashes += clashesIn(*action->menu());
    }
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join("\n")));
  }

  void everyActionHasANameAndATip() {
    WindowDriver driver;
    QStringList faults;
    for (const QMenu* menu : driver.window().findChildren<QMenu*>()) {
      if (menu->objectName() == "status.places") continue;
      for (const QAction* action : menu->actions()) {
        if (action->isSeparator() || action->menu()) continue;
        if (action->objectName().isEmpty()) faults << "no name: " + action->text();
        // Without one of its own an action's tooltip is its text.
        QString plain = action->text();
        plain.remove('&').remove(QStringLiteral("…"));
        const bool told = !action->statusTip().isEmpty() || action->toolTip() != plain;
        if (action->isEnabled() && !told) {
          faults << "no tip: " + action->text();
        }
      }
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join("\n")));
  }

  void everyWidgetThatTakesTheFocusCanBeNamed() {
    WindowDriver driver;
    QStringList faults;
    int widgets = 0;
    for (const QWidget* widget : driver.window().findChildren<QWidget*>()) {
      if (widget->focusPolicy() == Qt::NoFocus || isPart(*widget)) continue;
      ++widgets;
      const QString who =
          QStringLiteral("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
      if (widget->objectName().isEmpty()) {
        const QWidget* parent = widget->parentWidget();
        faults << "no object name: " + who + " in " + (parent ? parent->objectName() : QString());
      }
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      const bool named = !widget->accessibleName().isEmpty() ||
                         (button && !button->text().isEmpty()) ||
                         hasLabel(*widget, driver.window());
      if (!named) faults << "no accessible name: " + who;
      if (widget->objectName() != "canvas" && widget->toolTip().isEmpty()) {
        faults << "no tooltip: " + who;
      }
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join("\n")));
    QVERIFY(widgets > 20);
  }

  void theFocusIsSeenWhereverTheKeyboardTakesIt() {
    WindowDriver driver;
    driver.canvas().setFocus();
    QSet<QWidget*> visited;
    for (int i = 0; i < 60; ++i) {
      driver.key(i % 8 == 0 ? Qt::Key_F6 : Qt::Key_Tab);
      QWidget* now = QApplication::focusWidget();
      QVERIFY(now);
      visited << now;
      QFocusFrame* frame = nullptr;
      for (QWidget* widget : QApplication::allWidgets()) {
        if (widget->objectName() == "focus-frame") frame = qobject_cast<QFocusFrame*>(widget);
      }
      if (now->property("drawsFocus").toBool()) continue;
      QVERIFY(frame);
      QCOMPARE(frame->widget(), now);
      QVERIFY2(frame->isVisible(), qPrintable(now->objectName()));
    }
    QVERIFY2(visited.size() > 8, qPrintable(QString::number(visited.size())));
  }

  void theCanvasDrawsItsFocusInBothThemes() {
    WindowDriver driver;
    for (const auto theme : {Display::Theme::Light, Display::Theme::Dark}) {
      driver.window().display().setTheme(theme);
      driver.window().findChild<QWidget*>("view.angle")->setFocus();
      driver.settle();
      const QColor without = driver.canvas().grab().toImage().pixelColor(1, 100);
      driver.canvas().setFocus(Qt::ShortcutFocusReason);
      driver.settle();
      const QColor with = driver.canvas().grab().toImage().pixelColor(1, 100);
      QVERIFY(without != with);
      QCOMPARE(with, QApplication::palette().color(QPalette::Highlight));
    }
    driver.window().display().setTheme(Display::Theme::System);
  }

  void theCanvasSaysInWordsWhatItShows() {
    WindowDriver driver;
    const QString before = driver.canvas().accessibleDescription();
    QVERIFY2(before.contains("Silhouettes: 2"), qPrintable(before));
    QVERIFY(before.contains("5 control points"));
    QVERIFY(before.contains("0.0°"));
    driver.trigger("view.from.90");
    const QString after = driver.canvas().accessibleDescription();
    QVERIFY(after != before);
    QVERIFY2(after.contains("90.0°"), qPrintable(after));
  }

  void theKeySheetKnowsTheKeysOfTheMenus() {
    WindowDriver driver;
    driver.key(Qt::Key_H);
    auto* sheet = driver.window().findChild<KeySheet*>("keys");
    QVERIFY(sheet && sheet->isVisible());
    QString all;
    for (const QLabel* label : sheet->findChildren<QLabel*>()) all += label->text() + "\n";
    for (const QAction* action : driver.window().findChildren<QAction*>()) {
      if (!action->objectName().contains('.') || action->shortcuts().isEmpty()) continue;
      const QString keys = action->shortcuts().front().toString(QKeySequence::NativeText);
      QVERIFY2(all.contains(keys), qPrintable(action->objectName() + " " + keys));
    }
    driver.key(Qt::Key_Escape);
    QVERIFY(!sheet->isVisible());
  }
};

}  // namespace flatland::ui

QTEST_MAIN(flatland::ui::KeyboardTest)
#include "keyboard_test.moc"
