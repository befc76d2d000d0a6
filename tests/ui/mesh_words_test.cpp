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
