// SPDX-License-Identifier: GPL-3.0-or-later
// What the libraries say of mesh files, in German: nothing of it is English.
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <cstdlib>
#include <filesystem>

#include "core3d/io/read_mesh.h"
#include "core3d/mesh/mesh_report.h"
#include "flatland/io/scene_json.h"
#include "flatland/io/svg_file.h"
#include "ui/app/language.h"
#include "ui/model/core_sentences.h"
#include "ui/model/core_words.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

/// Words of English sentences that German ones have not.
bool isEnglish(const QString& text) {
  static const QRegularExpression words(
      "\\b(a|and|are|at|be|bytes?|but|corners?|ends?|faces?|facets?|file|has|have|have no|"
      "is|it|its|left|line|missing|no|not|number|of|one|only|out|than|that|the|there|to|"
      "triangles?|uses|value|values|vertex|vertices|which|with|without)\\b");
  static const QRegularExpression quoted("'[^']*'");
  static const QRegularExpression german("\\b(Bytes?|in|was)\\b");
  return QString(text).remove(quoted).remove(german).contains(words);
}

std::filesystem::path dataFolder() {
  const char* asked = std::getenv("FLATLAND_DATA");
  return asked ? std::filesystem::path(asked) : std::filesystem::path(FLATLAND_DATA_FOLDER);
}

}  // namespace

class MeshWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { installLanguage("de"); }

  void englishIsSeen() {
    QVERIFY(isEnglish("the file ends too early"));
    QVERIFY(isEnglish("Zeile 3: a value ist keine Zahl"));
    QVERIFY(!isEnglish("die Datei endet zu früh"));
  }

  /// Those of hostile_meshes_test.
  void reasonsAreGerman() {
    QFile list(FLATLAND_TEST_DATA "/mesh_reasons.txt");
    QVERIFY(list.open(QIODevice::ReadOnly));
    int count = 0;
    while (!list.atEnd()) {
      const QString english = QString::fromUtf8(list.readLine()).trimmed();
      ++count;
      const QString german = coreWords(english.toStdString());
      // What a reader of JSON says of a number is its own.
      QVERIFY2(german != english && !isEnglish(german), qPrintable(english + " -> " + german));
    }
    QVERIFY(count > 80);
  }

  void refusedSurfacesOfScenesAreToldInGerman() {
    const char* const broken[] = {
        R"("mesh": "")",
        R"("camera": {"zoom": 0})",
        R"("camera": {"towards": [0, 0, 0]})",
        R"("camera": {"towards": [0, 2, 0]})",
        R"("camera": {"towards": [1, 2]})",
        R"("camera": {"perspectiveDeg": 0})",
        R"("families": [{"name": "ridge"}])",
        R"("families": [{"name": "ridges"}, {"name": "ridges"}])",
        R"("families": [{"name": "ridges", "threshold": -1}])",
        R"("families": [{"name": "ridges", "colour": "red"}])",
        R"("isophotes": 0)",
        R"("ink": 2)",
        R"("panes": [{}, {}, {}, {}])",
        R"("swept": {"kind": "extrusion", "amount": 1})",
        R"("swept": {"kind": "extrusion", "amount": 1, "curve": -1})",
        R"("swept": {"kind": "extrusion", "amount": 1, "cells": 2})",
        R"("fitScale": 0.5)",
    };
    for (const std::string part : broken) {
      const std::string mesh = part.find("mesh") == 1 ? "" : R"("mesh": "solid:torus", )";
      try {
        sceneFromJson(R"({"flatland": 4, "curves": [], "surface": {)" + mesh + part + "}}", "");
        QFAIL(part.c_str());
      } catch (const InputError& error) {
        const QString german = errorForPeople(error);
        const QString reason = german.mid(german.lastIndexOf(": ") + 2);
        QVERIFY2(!isEnglish(reason) && reason != QString::fromStdString(error.reason()),
                 qPrintable(german));
      }
    }
  }

  void whatIsMendedIsGerman() {
    using Field = std::size_t MeshReport::*;
    const Field fields[] = {&MeshReport::isolatedVertices,   &MeshReport::weldedVertices,
                            &MeshReport::foldedPolygons,     &MeshReport::hugePolygons,
                            &MeshReport::collapsedTriangles, &MeshReport::duplicateTriangles,
                            &MeshReport::strayTriangles,     &MeshReport::turnedTriangles,
                            &MeshReport::invertedPieces,     &MeshReport::flatTriangles,
                            &MeshReport::nonManifoldEdges,   &MeshReport::nonManifoldVertices,
                            &MeshReport::unorientableEdges};
    for (const Field field : fields) {
      for (const std::size_t count : {1u, 2u, 1234u}) {
        MeshReport report;
        report.*field = count;
        QCOMPARE(report.sentences().size(), std::size_t{1});
        const std::string english = report.sentences().front();
        const QString german = coreWords(english);
        QVERIFY2(!isEnglish(german) && german.contains(QString::number(count)),
                 qPrintable(QString::fromStdString(english) + " -> " + german));
      }
    }
  }

  void whatAnImportDidIsGerman() {
    // Of each thing that is left out one, then three.
    const QString one =
        "<defs><linearGradient/><pattern/><filter/></defs>"
        "<g display='none'/><rect width='3' height='3' clip-path='url(#c)' mask='url(#m)'/>"
        "<text/><image/><foreignObject/><use href='#none'/>"
        "<path d='M0 0L1 2' fill='none' stroke='none'/><path d='M1 1L1 1'/>"
        "<path d='M0 0L9 0L9 0L0 9'/>";
    for (const int times : {1, 3}) {
      const QString text =
          "<svg xmlns='http://www.w3.org/2000/svg' width='64' height='64'><style>" +
          QString("a:hover{fill:none}").repeated(times) + "</style>" + one.repeated(times) +
          "</svg>";
      const ImportedScene imported = sceneFromSvg(text.toStdString(), "drawing.svg", {});
      const QString german = importForPeople(imported);
      for (const QString& clause : german.split(QRegularExpression("[,;:] "))) {
        const std::string english = imported.note();
        QVERIFY2(!english.empty() && !isEnglish(clause) &&
                     !QString::fromStdString(english).contains(clause),
                 qPrintable(QString::fromStdString(english) + " -> " + german));
      }
      QCOMPARE(german.count(','), QString::fromStdString(imported.note()).count(','));
      QVERIFY2(german.count(',') >= 14, qPrintable(german));
    }
    QCOMPARE(importForPeople({{}, "3 curves of DejaVu Sans, scaled by 1/16 and centred", {}}),
             QString("3 Kurven aus DejaVu Sans, mit 1/16 skaliert und zentriert"));
    QCOMPARE(importForPeople({{}, "1 curve, y turned up, centred", "left out: 1 text"}),
             QString("1 Kurve, y nach oben gewendet, zentriert; ausgelassen: 1 Text"));
    QCOMPARE(coreWords("has no curve to show; left out: 2 images, 1 mask"),
             coreWords("has no curve to show") + "; ausgelassen: 2 Bilder, 1 Maske");
  }

  /// Every malformed example: why it is refused, or what was mended.
  void messyFilesAreToldInGerman() {
    const std::filesystem::path folder = dataFolder() / "messy";
    if (!std::filesystem::is_directory(folder)) {
      if (qEnvironmentVariable("CI") == "true") QFAIL("no example meshes");
      QSKIP("no example meshes");
    }
    int told = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      QStringList german;
      try {
        for (const std::string& sentence : loadMesh(entry.path()).report.sentences()) {
          german << coreWords(sentence);
        }
      } catch (const InputError& error) {
        german << errorForPeople(error).remove(QString::fromStdString(entry.path().string()));
      }
      for (const QString& sentence : german) {
        ++told;
        QVERIFY2(!isEnglish(sentence), qPrintable(sentence));
      }
    }
    QVERIFY(told > 30);
  }
};

QTEST_GUILESS_MAIN(MeshWordsTest)
#include "mesh_words_test.moc"
