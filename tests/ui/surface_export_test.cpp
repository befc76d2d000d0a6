// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that exports the surface, its key, and closing the window meanwhile.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <cmath>

#include "tests/ui/support_export.h"
#include "ui/app/export_settings.h"
#include "ui/view3d/surface_area.h"

using namespace flatland;
using namespace flatland::ui;

class SurfaceExportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<ExportDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void aNameWithoutSuffixGetsThatOfTheFormat() {
    for (const char* suffix : {"svg", "tex", "png", "csv", "json"}) {
      const QString name = driver_->path(QStringLiteral("of-") + suffix);
      driver_->exportAs(suffix, name);
      QTRY_VERIFY2_WITH_TIMEOUT(QFile::exists(name + "." + suffix), suffix,
                                ExportDriver::kPatienceMs);
    }
    QVERIFY(!QImage(driver_->path("of-png.png")).isNull());
  }

  void exportsHaveTheSizeAskedFor() {
    const auto size = [](QWidget& dialog) {
      chosen(dialog, "export.unit", static_cast<int>(ExportSettings::Unit::Centimetres));
      dialog.findChild<QDoubleSpinBox*>("export.width")->setValue(12.7);
      dialog.findChild<QDoubleSpinBox*>("export.height")->setValue(7.62);
      dialog.findChild<QDoubleSpinBox*>("export.dpi")->setValue(200.0);
    };
    const QString png = driver_->path("size.png"), svg = driver_->path("size.svg");
    driver_->exportAs("png", png, size);
    QVERIFY(ExportDriver::comes(png));
    const QImage image(png);
    QCOMPARE(image.size(), QSize(1000, 600));
    QCOMPARE(qRound(image.dotsPerMeterX() * 0.0254), 200);
    driver_->exportAs("svg", svg, size);
    QVERIFY(ExportDriver::comes(svg));
    QVERIFY(textOf(svg).contains("width=\"480\" height=\"288\""));
    // What was asked for is there the next time, in the shape of the panel.
    const QSize panel = driver_->window().surfaceArea().viewsSize();
    double width = 0.0, height = 0.0;
    QString suffix;
    whenModal([&](QWidget& dialog) {
      width = dialog.findChild<QDoubleSpinBox*>("export.width")->value();
      height = dialog.findChild<QDoubleSpinBox*>("export.height")->value();
      suffix = dialog.findChild<QComboBox*>("export.format")->currentData().toString();
      qobject_cast<QDialog*>(&dialog)->reject();
    });
    driver_->trigger("surface.export");
    QCOMPARE(suffix, QStringLiteral("svg"));
    QCOMPARE(width, 12.7);
    QVERIFY(std::abs(height / width - 1.0 * panel.height() / panel.width()) < 0.01);
  }

  void coloursAreThoseAskedFor() {
    for (const Palette palette : {Palette::Light, Palette::Dark, Palette::HighContrast}) {
      const auto colours = [palette](QWidget& dialog) {
        chosen(dialog, "export.colours", static_cast<int>(palette));
      };
      const Rgb ground = sceneColours(palette).background;
      const QString png = driver_->path(QString::number(static_cast<int>(palette)) + ".png");
      driver_->exportAs("png", png, colours);
      QVERIFY(ExportDriver::comes(png));
      QCOMPARE(QImage(png).pixel(2, 2), qRgb(ground.r, ground.g, ground.b));
      const QString svg = driver_->path(QString::number(static_cast<int>(palette)) + ".svg");
      driver_->exportAs("svg", svg, colours);
      QVERIFY(ExportDriver::comes(svg));
      QVERIFY(textOf(svg).contains("fill=\"" + QByteArray::fromStdString(toHex(ground)) + "\""));
    }
  }

  /// The key of exports is that of the view worked with last.
  void theKeyExportsTheViewWorkedWith() {
    const auto asked = [this](QWidget& view) {
      QString name;
      QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(15, view.height() - 15));
      driver_->window().activateWindow();
      if (!QTest::qWaitForWindowActive(&driver_->window())) return name;
      whenModal([&name](QWidget& dialog) {
        name = dialog.objectName();
        qobject_cast<QDialog*>(&dialog)->reject();
      });
      driver_->key(Qt::Key_E, Qt::ControlModifier);
      return name;
    };
    QWidget& surface = *driver_->window().surfaceArea().canvas();
    QCOMPARE(asked(surface), QStringLiteral("surface-export"));
    QCOMPARE(asked(driver_->canvas()), QStringLiteral("export"));
    QCOMPARE(asked(surface), QStringLiteral("surface-export"));
    driver_->trigger("surface.close");
    QCOMPARE(asked(driver_->canvas()), QStringLiteral("export"));
  }

  void closingWaitsForTheExport() {
    const QString svg = driver_->path("late.svg"), csv = driver_->path("later.csv");
    driver_->exportAs("svg", svg);
    driver_->exportTo(csv, {});
    discardChanges();
    QVERIFY(driver_->window().close());
    QVERIFY(textOf(svg).contains("</svg>"));
    QVERIFY(!textOf(csv).isEmpty());
  }

  void aFailedExportKeepsTheWindowOpen() {
    const QString svg = driver_->path("nowhere/late.svg");
    SurfaceExporter& exporter = driver_->window().surfaces().exporter();
    exporter.exportTo(svg, {320, 240});
    QVERIFY(exporter.isBusy());
    QVERIFY(!driver_->window().close());
    QVERIFY(driver_->window().isVisible());
    QVERIFY(driver_->child<QLabel>("message.text").text().contains("late.svg"));
    // Told once, it closes.
    discardChanges();
    QVERIFY(driver_->window().close());
  }

 private:
  /// Answers the question about unsaved work that closing asks.
  static void discardChanges() {
    whenModal([](QWidget& box) {
      QTest::mouseClick(qobject_cast<QMessageBox*>(&box)->button(QMessageBox::Discard),
                        Qt::LeftButton);
    });
  }

  std::unique_ptr<ExportDriver> driver_;
};

QTEST_MAIN(SurfaceExportTest)
#include "surface_export_test.moc"
