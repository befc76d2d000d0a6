// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the window that `flatland shot` takes: everything that was to be drawn is there.
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/support_meshes.h"

using namespace flatland::ui;

class ShotTest : public QObject {
  Q_OBJECT

 private slots:
  /// Marks of a section take so long to be painted that work beside the window ends meanwhile.
  void waitsForTheLinesBesideASection() {
    NEEDS_DATA_MESH(mesh, "boot.obj");
    const QTemporaryDir folder;
    const QString scene = folder.filePath("scene.json"), picture = folder.filePath("window.png");
    QFile file(scene);
    QVERIFY(file.open(QIODevice::WriteOnly));
    const QJsonObject ridges{{"name", "apparent-ridges"}, {"on", false}};
    const QJsonObject contours{{"name", "contours"}, {"colour", "#ff00ff"}, {"widthPx", 3}};
    const QJsonObject plane{{"point", QJsonArray{0, 0, 0}}, {"normal", QJsonArray{0.3, 0.1, 1}}};
    const QJsonObject surface{
        {"mesh", mesh}, {"families", QJsonArray{ridges, contours}}, {"plane", plane}};
    const QJsonObject whole{{"flatland", 4}, {"curves", QJsonArray()}, {"surface", surface}};
    file.write(QJsonDocument(whole).toJson());
    file.close();
    QProcess program;
    program.start(FLATLAND_PROGRAM, {"shot", scene, "-o", picture});
    QVERIFY(program.waitForFinished(60000));
    QVERIFY2(program.exitCode() == 0, program.readAllStandardError());
    const QImage window(picture);
    QCOMPARE(window.size(), QSize(1280, 800));
    int contour = 0;
    for (int y = 0; y < window.height(); ++y) {
      for (int x = 0; x < window.width(); ++x) contour += window.pixel(x, y) == 0xffff00ff ? 1 : 0;
    }
    // The swatch of the family in the panel has 256 pixels.
    QVERIFY2(contour > 1500, qPrintable(QString::number(contour)));
  }
};

QTEST_GUILESS_MAIN(ShotTest)
#include "shot_test.moc"
