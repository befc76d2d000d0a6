// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings and glyphs: opened, dropped, imported into the scene; and what opening a preset says.
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFontComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>

#include "flatland/io/input_error.h"
#include "tests/ui/support_window.h"
#include "ui/import/glyph.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr char kDrawing[] =
    "<svg xmlns='http://www.w3.org/2000/svg' width='64' height='64'>"
    "<path d='M8 8C8 40 56 40 56 8'/><circle cx='32' cy='32' r='16'/><text>t</text></svg>";

QString whyNot(const std::string& argument) {
  try {
    glyphScene(glyphNamed(argument));
  } catch (const InputError& error) {
    return QString::fromStdString(error.what());
  }
  return "loaded";
}

}  // namespace

class ImportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    drawing_ = driver_->path("drawing.svg");
    write(drawing_, kDrawing);
  }
  void cleanup() { driver_.reset(); }

  void openingADrawingStartsAnUnnamedScene() {
    WindowDriver& d = *driver_;
    d.window().files().openFile(drawing_);
    d.settle();
    checkOpened();
  }

  void droppingADrawingOpensIt() {
    WindowDriver& d = *driver_;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(drawing_)});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&d.window(), &enter);
    QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&d.window(), &drop);
    d.settle();
    checkOpened();
  }

  void importingADrawingIsOneStep() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    whenModal([this](QWidget& dialog) {
      dialog.findChild<QLineEdit*>("fileNameEdit")->setText(drawing_);
      const auto* buttons = dialog.findChild<QDialogButtonBox*>();
      for (QAbstractButton* button : buttons->buttons()) {
        if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) {
          QTest::mouseClick(button, Qt::LeftButton);
          return;
        }
      }
    });
    d.canvasKey(Qt::Key_I, Qt::ControlModifier);
    QCOMPARE(d.scene().curves.size(), before.curves.size() + 2);
    QCOMPARE(d.document().undoStack().count(), 1);
    QVERIFY(d.child<QLabel>("message.text").text().contains("left out: 1 text"));
    // All that came is selected, and nothing else: arrow keys move it as a whole.
    const std::size_t came = controlPoints(d.scene().curves[1].shape).size() +
                             controlPoints(d.scene().curves[2].shape).size();
    QCOMPARE(d.window().selection().points().size(), came);
    const Scene imported = d.scene();
    d.canvasKey(Qt::Key_Right);
    QVERIFY(!(d.scene() == imported));
    QVERIFY(d.scene().curves[0] == before.curves[0]);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == before);
  }

  void aBrokenDrawingIsReportedAndChangesNothing() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    write(drawing_, "<svg><path d='M0 0L1'/></svg>");
    d.window().imports().importSvgFile(drawing_);
    auto& text = d.child<QLabel>("message.text");
    QVERIFY(text.isVisible());
    QVERIFY2(text.text().contains("d, character 7: expected a number"), qPrintable(text.text()));
    QVERIFY(d.scene() == before);
    d.window().files().openFile(drawing_);
    QVERIFY(d.scene() == before);
    QCOMPARE(d.document().undoStack().count(), 0);
  }

  void aDrawingTooLargeForTheWindowIsRefused() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    QByteArray path = "<svg><path d='M0 0";
    for (int i = 0; i < 5001; ++i) path += "l1 " + QByteArray::number(i % 3);
    write(drawing_, path + "'/></svg>");
    d.window().files().openFile(drawing_);
    auto& text = d.child<QLabel>("message.text");
    QVERIFY2(text.text().contains("has 5001 pieces"), qPrintable(text.text()));
    QVERIFY(d.scene() == before);
  }

  void aGlyphIsChosenWithAPreview() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    whenModal([](QWidget& dialog) {
      QCOMPARE(dialog.objectName(), "glyph");
      dialog.findChild<QFontComboBox*>("glyph.family")->setCurrentFont(QFont("DejaVu Sans"));
      auto* character = dialog.findChild<QLineEdit*>("glyph.character");
      auto* import = dialog.findChild<QPushButton*>("glyph.import");
      auto* message = dialog.findChild<QLabel*>("glyph.message");
      character->setFocus();
      character->selectAll();
      QTest::keyClicks(character, "ab");
      QVERIFY(!import->isEnabled());
      QVERIFY2(message->text().contains("one character"), qPrintable(message->text()));
      character->selectAll();
      QTest::keyClicks(character, "8");
      QVERIFY2(message->text().startsWith("3 curves"), qPrintable(message->text()));
      // The preview paints something else than an empty page.
      auto* outline = dialog.findChild<QWidget*>("glyph.outline");
      const QImage picture = outline->grab().toImage();
      int dark = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          dark += picture.pixelColor(x, y) != picture.pixelColor(0, 0);
        }
      }
      QVERIFY(dark > 300);
      QVERIFY(import->isEnabled());
      QTest::mouseClick(import, Qt::LeftButton);
    });
    d.canvasKey(Qt::Key_G, Qt::ControlModifier);
    QCOMPARE(d.scene().curves.size(), before.curves.size() + 3);
    QCOMPARE(d.document().undoStack().count(), 1);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == before);
  }

  void glyphsThatAreNotThere() {
    QVERIFY2(whyNot("glyph:DejaVu Sens:a").contains("the nearest names are DejaVu Sans"),
             qPrintable(whyNot("glyph:DejaVu Sens:a")));
    QVERIFY2(whyNot("glyph:Nimbus:a").contains("Nimbus"), qPrintable(whyNot("glyph:Nimbus:a")));
    QVERIFY(whyNot("glyph:DejaVu Sans").contains("expected glyph:FAMILY:CHARACTER"));
    QVERIFY(whyNot("glyph:DejaVu Sans:").contains("expected one character"));
    QVERIFY(whyNot("glyph:DejaVu Sans:ab").contains("expected one character"));
    QVERIFY(whyNot("glyph:DejaVu Sans: ").contains("has no outline"));
    QVERIFY(whyNot("glyph:DejaVu Sans:U+xyz").contains("expected a code"));
    // Tibetan is in none of the fonts the tests install; others may have it.
    QVERIFY2(whyNot("glyph:Nimbus Sans:U+0F40").contains("no glyph for U+0F40"),
             qPrintable(whyNot("glyph:Nimbus Sans:U+0F40")));
    QCOMPARE(whyNot("glyph:dejavu sans::"), "loaded");  // the colon itself
    QCOMPARE(whyNot("glyph:DejaVu Sans:U+00e9"), "loaded");
  }

  void outlinesAreTheFontsOwn() {
    // TrueType is quadratic, PostScript cubic.
    const Scene quadratic = glyphScene({"DejaVu Sans", U'o'}).scene;
    QCOMPARE(quadratic.curves.size(), std::size_t(2));
    QCOMPARE(quadratic.curves[0].chain().degree(), 2);
    QVERIFY(quadratic.curves[0].chain().closed());
    QCOMPARE(glyphScene({"Nimbus Roman", U'o'}).scene.curves[0].chain().degree(), 3);
    // The right way up: an L has its mass below.
    const Scene upright = glyphScene({"DejaVu Sans", U'L'}).scene;
    double above = 0, below = 0;
    for (const Vec2& p : upright.curves[0].chain().points()) {
      (p.y() > 0 ? above : below) += p.x();
    }
    QVERIFY(below > above);
    // Half units of the em, scaled by a power of two, and straight sides straight.
    for (const Vec2& p : upright.curves[0].chain().points()) {
      QCOMPARE(std::ldexp(p.x(), 20), std::round(std::ldexp(p.x(), 20)));
    }
  }

  void tenFontsGiveMarks() {
    const char* const families[] = {"DejaVu Sans", "DejaVu Sans Mono", "DejaVu Serif", "C059",
                                    "Nimbus Sans", "Nimbus Mono PS",   "Nimbus Roman", "P052",
                                    "URW Bookman", "URW Gothic",       "Z003"};
    for (const char* family : families) {
      for (const char32_t character : {U'a', U'R', U'g', U'&'}) {
        Scene scene = glyphScene({family, character}).scene;
        for (const double angle : {17.0, 90.0}) {
          scene.view.angleDeg = angle;
          const FeatureSet found = findFeatures(scene);
          QVERIFY2(found.complete(), family);
          std::vector<int> silhouettes(scene.curves.size(), 0);
          for (const Mark& mark : found.marks) {
            if (mark.kind == MarkKind::Silhouette) {
              ++silhouettes[static_cast<std::size_t>(mark.curve)];
            }
          }
          if (angle == 90.0) continue;  // upright sides are seen end-on there
          for (const int count : silhouettes) {
            // A contour turns back on the screen as often one way as the other.
            QVERIFY2(count >= 2 && count % 2 == 0, family);
          }
        }
      }
    }
  }

  void aDegenerateCaseSaysWhatIsExpected() {
    WindowDriver& d = *driver_;
    auto& text = d.child<QLabel>("message.text");
    for (const Preset& preset : allPresets()) {
      d.trigger(("file.preset." + preset.id).c_str());
      QVERIFY(d.scene() == preset.scene);
      QCOMPARE(text.isVisible(), !preset.expected.empty());
      if (!preset.expected.empty()) {
        QVERIFY(text.text().contains(QString::fromStdString(preset.expected)));
      }
    }
    QTest::mouseClick(&d.child<QAbstractButton>("message.close"), Qt::LeftButton);
    QVERIFY(!text.isVisible());
  }

 private:
  static void write(const QString& name, const QByteArray& bytes) {
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }

  void checkOpened() {
    WindowDriver& d = *driver_;
    QCOMPARE(d.scene().curves.size(), std::size_t(2));
    QVERIFY(d.document().file().empty());
    QVERIFY(!d.document().isModified());
    QVERIFY2(d.window().windowTitle().contains("drawing.svg"),
             qPrintable(d.window().windowTitle()));
    auto& text = d.child<QLabel>("message.text");
    QVERIFY(text.isVisible());
    QVERIFY2(text.text().contains("2 curves") && text.text().contains("left out: 1 text"),
             qPrintable(text.text()));
  }

  std::unique_ptr<WindowDriver> driver_;
  QString drawing_;
};

QTEST_MAIN(ImportTest)
#include "import_test.moc"
