// SPDX-License-Identifier: GPL-3.0-or-later
// Files, the unsaved-changes question, export, the key sheet, and what a new session remembers.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>

#include "flatland/io/scene_json.h"
#include "tests/ui/support_window.h"
#include "ui/app/app.h"
#include "ui/commands/scene_commands.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

void writeFile(const QString& name, const QByteArray& bytes) {
  QFile file(name);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

QByteArray readFile(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Clicks a button of the message box that the next action opens.
void answer(QMessageBox::StandardButton button, bool* asked) {
  *asked = false;
  whenModal([button, asked](QWidget& dialog) {
    auto* box = qobject_cast<QMessageBox*>(&dialog);
    QVERIFY(box);
    *asked = true;
    QTest::mouseClick(box->button(button), Qt::LeftButton);
  });
}

}  // namespace

class FilesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    before_ = driver_->scene();
  }
  void cleanup() { driver_.reset(); }

  void theQuestionSaysWhatTookThePlaceOfTheScene() {
    WindowDriver& d = *driver_;
    QString said;
    const auto ask = [&] {
      whenModal([&said](QWidget& dialog) {
        auto* box = qobject_cast<QMessageBox*>(&dialog);
        QVERIFY(box);
        said = box->text();
        QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
      });
      QVERIFY(!d.window().close());
    };
    d.document().push(std::make_unique<ReplaceScene>(d.document(), presets()[2].scene,
                                                     "Show Curve 7 of the Study"));
    ask();
    QVERIFY2(said.contains("took the place") && said.contains("Show Curve 7"), qPrintable(said));
    d.document().undoStack().undo();
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(30, 10));
    ask();
    QVERIFY2(said == "Save this scene?", qPrintable(said));
  }

  void saveAndReopen() {
    WindowDriver& d = *driver_;
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(33, 17));
    d.drag(d.atHandle(), d.atHandle() + QPoint(-20, -70));
    const Scene mine = d.scene();
    const QString name = d.path("mine.json");
    typeFileName(name);
    d.canvasKey(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(QFile::exists(name));
    QVERIFY(!d.window().isWindowModified());
    QVERIFY(d.window().windowTitle().contains("mine.json"));
    QVERIFY(loadScene(name.toStdString()) == mine);
    d.canvasKey(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(!(d.scene() == mine));
    typeFileName(name);
    d.canvasKey(Qt::Key_O, Qt::ControlModifier);
    QVERIFY(d.scene() == mine);
    QCOMPARE(d.document().undoStack().count(), 0);
  }

  void saveAsAddsTheSuffix() {
    WindowDriver& d = *driver_;
    typeFileName(d.path("plain"));
    d.trigger("file.save-as");
    QVERIFY(QFile::exists(d.path("plain.json")));
    QVERIFY(!QFile::exists(d.path("plain")));
  }

  void failedOpenChangesNothing() {
    WindowDriver& d = *driver_;
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(33, 17));
    const Scene mine = d.scene();
    writeFile(d.path("bad.json"), "{\"flatland\": 1,\n \"curves\": [{\"bezier\": [[0, 0], [1]]}]}");
    bool asked = false;
    answer(QMessageBox::Discard, &asked);
    d.window().files().openFile(d.path("bad.json"));
    d.settle();
    QVERIFY(asked);
    QVERIFY(d.scene() == mine);
    QVERIFY(d.document().isModified());
    QCOMPARE(d.document().undoStack().count(), 1);
    auto& message = d.child<QLabel>("message.text");
    QVERIFY(message.isVisible());
    QVERIFY2(message.text().contains("curves[0].bezier[1]"), qPrintable(message.text()));
    QVERIFY(message.text().contains("bad.json"));
    QTest::mouseClick(&d.child<QAbstractButton>("message.close"), Qt::LeftButton);
    QVERIFY(!message.isVisible());
  }

  void failedSaveKeepsTheDocumentModified() {
    WindowDriver& d = *driver_;
    d.trigger("curve.flip");
    QVERIFY(!d.window().files().saveTo(d.path("no/such/folder/scene.json")));
    QVERIFY(d.document().isModified());
    QVERIFY(d.child<QLabel>("message.text").isVisible());
  }

  void cancelKeepsUnsavedWork() {
    WindowDriver& d = *driver_;
    d.trigger("curve.flip");
    const Scene mine = d.scene();
    bool asked = false;
    for (const char* action : {"file.new", "file.quit"}) {
      answer(QMessageBox::Cancel, &asked);
      d.trigger(action);
      QVERIFY2(asked, action);
      QVERIFY(d.scene() == mine);
      QVERIFY(d.window().isVisible());
    }
    answer(QMessageBox::Discard, &asked);
    d.trigger("file.new");
    QVERIFY(asked);
    QVERIFY(d.scene() == defaultScene());
  }

  void saveFromTheQuestion() {
    WindowDriver& d = *driver_;
    QVERIFY(d.window().files().saveTo(d.path("kept.json")));
    d.trigger("curve.flip");
    const Scene mine = d.scene();
    bool asked = false;
    answer(QMessageBox::Save, &asked);
    d.trigger("file.new");
    QVERIFY(asked);
    QVERIFY(loadScene(d.path("kept.json").toStdString()) == mine);
    QVERIFY(d.scene() == defaultScene());
  }

  void unchangedAsksNothing() {
    WindowDriver& d = *driver_;
    d.trigger("file.new");
    d.window().close();
    QVERIFY(!d.window().isVisible());
  }

  void dropOpensAFile() {
    WindowDriver& d = *driver_;
    const Scene other = presets().back().scene;
    saveScene(other, d.path("dropped.json").toStdString());
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(d.path("dropped.json"))});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&d.window(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&d.window(), &drop);
    d.settle();
    QVERIFY(d.scene() == other);
  }

  void presetsOpen() {
    WindowDriver& d = *driver_;
    for (const Preset& preset : presets()) {
      d.trigger(("file.preset." + preset.id).c_str());
      QVERIFY(d.scene() == preset.scene);
      QVERIFY(!d.document().isModified());
      QVERIFY(d.window().windowTitle().contains(QString::fromStdString(preset.name)));
    }
  }

  void recentFilesThatAreGone() {
    WindowDriver& d = *driver_;
    QVERIFY(d.window().files().saveTo(d.path("first.json")));
    QVERIFY(d.window().files().saveTo(d.path("second.json")));
    QCOMPARE(d.window().files().recentFiles(),
             QStringList({d.path("second.json"), d.path("first.json")}));
    QFile::remove(d.path("first.json"));
    auto& menu = d.child<QMenu>("menu.file.recent");
    emit menu.aboutToShow();
    QVERIFY(menu.actions().at(0)->isEnabled());
    QVERIFY(!menu.actions().at(1)->isEnabled());
    d.window().files().openFile(d.path("first.json"));
    QVERIFY(d.child<QLabel>("message.text").isVisible());
    QCOMPARE(d.window().files().recentFiles(), QStringList({d.path("second.json")}));
  }

  void keySheet() {
    WindowDriver& d = *driver_;
    d.canvasKey(Qt::Key_H);
    auto& sheet = d.child<QWidget>("keys");
    QVERIFY(sheet.isVisible());
    QVERIFY(QTest::qWaitForWindowActive(&sheet));
    QTest::keyClick(&sheet, Qt::Key_Escape);
    QVERIFY(!sheet.isVisible());
    d.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&d.window()));
    d.canvas().setFocus();
    QTest::keyClick(&d.canvas(), Qt::Key_Question, Qt::ShiftModifier);
    QVERIFY(d.child<QWidget>("keys").isVisible());  // made anew, for the size there is now
  }

  void exportWritesEveryFormat_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<QByteArray>("beginning");
    QTest::newRow("SVG") << 0 << "svg" << QByteArray("<?xml");
    QTest::newRow("PDF") << 1 << "pdf" << QByteArray("%PDF");
    QTest::newRow("PNG") << 2 << "png" << QByteArray("\x89PNG");
    QTest::newRow("TikZ") << 3 << "tex" << QByteArray("%");
  }
  void exportWritesEveryFormat() {
    QFETCH(int, format);
    QFETCH(QString, suffix);
    QFETCH(QByteArray, beginning);
    WindowDriver& d = *driver_;
    const QString name = d.path("picture." + suffix);
    whenModal([format, name](QWidget& dialog) {
      dialog.findChild<QComboBox*>("export.format")->setCurrentIndex(format);
      dialog.findChild<QComboBox*>("export.unit")->setCurrentIndex(0);
      dialog.findChild<QDoubleSpinBox*>("export.width")->setValue(10.0);
      dialog.findChild<QDoubleSpinBox*>("export.height")->setValue(5.0);
      dialog.findChild<QDoubleSpinBox*>("export.dpi")->setValue(254.0);
      typeFileName(name);
      QTest::mouseClick(dialog.findChild<QAbstractButton*>("export.go"), Qt::LeftButton);
    });
    d.canvasKey(Qt::Key_E, Qt::ControlModifier);
    const QByteArray bytes = readFile(name);
    QVERIFY2(bytes.startsWith(beginning), bytes.left(40).constData());
    if (suffix == "png") {
      const QImage image(name);
      QVERIFY(std::abs(image.width() - 1000) <= 1 && std::abs(image.height() - 500) <= 1);
    }
    QVERIFY(!d.document().isModified());
    // Remembered for the next time.
    bool seen = false;
    whenModal([format, &seen](QWidget& dialog) {
      seen = dialog.findChild<QComboBox*>("export.format")->currentIndex() == format &&
             dialog.findChild<QDoubleSpinBox*>("export.width")->value() == 10.0;
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    d.canvasKey(Qt::Key_E, Qt::ControlModifier);
    QVERIFY(seen);
  }

  void unitsKeepTheSize() {
    WindowDriver& d = *driver_;
    bool seen = false;
    whenModal([&seen](QWidget& dialog) {
      auto* unit = dialog.findChild<QComboBox*>("export.unit");
      auto* width = dialog.findChild<QDoubleSpinBox*>("export.width");
      unit->setCurrentIndex(0);
      width->setValue(25.4);
      unit->setCurrentIndex(1);
      seen = width->value() == 960.0;
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    d.trigger("file.export");
    QVERIFY(seen);
  }

  void nextSessionLooksTheSame() {
    WindowDriver& d = *driver_;
    d.child<QDockWidget>("points").close();
    d.window().display().setShows(MarkKind::Flat, true);
    d.window().resize(1100, 700);
    d.settle();
    d.window().close();
    MainWindow next(defaultScene(), "preset", &d.settings());
    next.show();
    QVERIFY(QTest::qWaitForWindowExposed(&next));
    QVERIFY(!next.findChild<QDockWidget*>("points")->isVisible());
    QVERIFY(next.findChild<QDockWidget*>("marks")->isVisible());
    QVERIFY(next.display().shows(MarkKind::Flat));
    QCOMPARE(next.size(), QSize(1100, 700));
  }

 private:
  std::unique_ptr<WindowDriver> driver_;
  Scene before_;
};

QTEST_MAIN(FilesTest)
#include "files_test.moc"
