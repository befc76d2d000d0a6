// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/core_sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <iterator>
#include <vector>

#include "ui/model/core_words.h"
#include "ui/model/mesh_sentences.h"

namespace flatland::ui {

namespace {

// The first that fits counts, so the more particular one stands first.
constexpr const char* kSentences[] = {
    // flatland/curve/expression.cpp, formula_curve.cpp, families.cpp
    QT_TRANSLATE_NOOP("Core", "\"%1\" is not known: %2"),
    QT_TRANSLATE_NOOP("Core", "%1 needs its argument in ( )"),
    QT_TRANSLATE_NOOP("Core", "%1 needs two arguments with a comma between them"),
    QT_TRANSLATE_NOOP("Core", "%1 takes %2; a decimal is written with a point"),
    QT_TRANSLATE_NOOP("Core", "an operator is missing before \"%1\"; a product is written 2*t"),
    QT_TRANSLATE_NOOP("Core", "\"%1\" cannot stand here"),
    QT_TRANSLATE_NOOP("Core", "the formula is longer than %1 characters"),
    QT_TRANSLATE_NOOP("Core", "the domain must end above %1"),
    QT_TRANSLATE_NOOP("Core", "%1 is beyond 1e50 at t = %2"),
    QT_TRANSLATE_NOOP("Core", "%1 has no finite value at t = %2"),
    QT_TRANSLATE_NOOP("Core", "%1 grows beyond all bounds at t = %2"),
    QT_TRANSLATE_NOOP("Core", "%1 is not a finite number"),
    QT_TRANSLATE_NOOP("Core", "%1 must be from %2 to %3"),
    QT_TRANSLATE_NOOP("Core", "%1 must be a whole number"),
    QT_TRANSLATE_NOOP("Core", "weight %1 is not above 0"),
    // flatland/curve
    QT_TRANSLATE_NOOP("Core", "a degree of %1 is below 1"),
    QT_TRANSLATE_NOOP("Core", "degree %1 is above %2, the highest supported"),
    QT_TRANSLATE_NOOP("Core", "degree %1 with %2 points: %3"),
    QT_TRANSLATE_NOOP("Core",
                      "a closed chain of m pieces needs %1 m points (the first is not repeated)"),
    QT_TRANSLATE_NOOP("Core", "an open chain of m pieces needs %1 m + 1 points"),
    QT_TRANSLATE_NOOP("Core", "a B-spline of degree %1 needs at least %2 points, found %3"),
    QT_TRANSLATE_NOOP("Core", "a Bezier curve needs at least 2 points, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected %1 knots for %2 points of degree %3, found %4"),
    QT_TRANSLATE_NOOP("Core", "expected %1 weights, one for each point, found %2"),
    // flatland/io, ui/import; places in a file
    QT_TRANSLATE_NOOP("Core", "line %1, column %2"),
    QT_TRANSLATE_NOOP("Core", "line %1"),
    QT_TRANSLATE_NOOP("Core", "column %1: %2"),
    QT_TRANSLATE_NOOP("Core", "%1, character %2"),
    QT_TRANSLATE_NOOP("Core", "not valid JSON: %1"),
    QT_TRANSLATE_NOOP("Core", "number %1 is too large for a double"),
    QT_TRANSLATE_NOOP("Core", "the number %1 is too large"),
    QT_TRANSLATE_NOOP("Core", "the key \"%1\" is there twice"),
    QT_TRANSLATE_NOOP("Core", "nested deeper than %1 levels"),
    QT_TRANSLATE_NOOP("Core", "nested deeper than %1"),
    QT_TRANSLATE_NOOP("Core", "missing \"%1\" or \"%2\""),
    QT_TRANSLATE_NOOP("Core", "missing \"%1\""),
    QT_TRANSLATE_NOOP("Core", "unknown key %1; known here: %2"),
    QT_TRANSLATE_NOOP("Core", "a key too many; known here: %1"),
    QT_TRANSLATE_NOOP("Core", "there is no family %1; known: %2"),
    QT_TRANSLATE_NOOP("Core", "expected a whole number, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected one of %1; found %2"),
    QT_TRANSLATE_NOOP("Core", "expected three numbers"),
    QT_TRANSLATE_NOOP("Core", "expected a number above 0, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected a number of at least %1, found %2"),
    QT_TRANSLATE_NOOP("Core", "expected a direction, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected an angle from %1 to %2 degrees, found %3"),
    QT_TRANSLATE_NOOP("Core", "expected a threshold of 0 or above"),
    QT_TRANSLATE_NOOP("Core", "expected a colour like %1, or none"),
    QT_TRANSLATE_NOOP("Core", "expected the index of a curve, from 0"),
    QT_TRANSLATE_NOOP("Core", "expected %1 to %2 cells"),
    QT_TRANSLATE_NOOP("Core", "expected 1 to %1 levels"),
    QT_TRANSLATE_NOOP("Core", "expected a file or solid:NAME"),
    QT_TRANSLATE_NOOP("Core", "expected a share of at most 1"),
    QT_TRANSLATE_NOOP("Core", "\"up\" lies along \"towards\""),
    QT_TRANSLATE_NOOP("Core", "there is one of this name already"),
    QT_TRANSLATE_NOOP("Core", "more than %1 entries"),
    QT_TRANSLATE_NOOP("Core", "more than %1 views"),
    QT_TRANSLATE_NOOP("Core", "\"mesh\": \"swept:\" and \"swept\" belong together"),
    QT_TRANSLATE_NOOP("Core", "came with version 3; write \"flatland\": 3"),
    QT_TRANSLATE_NOOP("Core",
                      "panes, ink, swept and plane came with version 4; write \"flatland\": 4"),
    QT_TRANSLATE_NOOP("Core", "expected a degree of at least 1, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected a distance above 0, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected version 1 to 4, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected 2 numbers [x, y], found %1"),
    QT_TRANSLATE_NOOP("Core", "expected 4 numbers, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected a number after the comma, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected a path command, found %1"),
    QT_TRANSLATE_NOOP("Core", "a path begins with M or m, found %1"),
    QT_TRANSLATE_NOOP("Core", "expected %1, found %2"),
    QT_TRANSLATE_NOOP("Core", "%1 is beyond %2, the largest length supported"),
    QT_TRANSLATE_NOOP("Core", "\"%1\" came with version 2; write \"flatland\": 2"),
    QT_TRANSLATE_NOOP("Core", "has both \"%1\" and \"%2\"; give one"),
    QT_TRANSLATE_NOOP("Core",
                      "version %1 was made by a newer Flatland; this one reads up to version %2"),
    QT_TRANSLATE_NOOP("Core", "cannot be read: %1"),
    QT_TRANSLATE_NOOP("Core", "cannot be written: %1"),
    QT_TRANSLATE_NOOP("Core", "cannot be replaced: %1"),
    QT_TRANSLATE_NOOP("Core", "is not well-formed XML: %1"),
    QT_TRANSLATE_NOOP("Core", "is not SVG: its outermost element is %1"),
    QT_TRANSLATE_NOOP("Core", "has no curve to show; %1"),
    QT_TRANSLATE_NOOP("Core",
                      "has %1 pieces, more than the %2 that the window can follow; flatland "
                      "features takes them all"),
    QT_TRANSLATE_NOOP("Core", "there is no such font here; the nearest names are %1"),
    QT_TRANSLATE_NOOP("Core", "the font has no glyph for %1; %2"),
    QT_TRANSLATE_NOOP("Core", "more than %1 steps"),
    QT_TRANSLATE_NOOP("Core", "no such preset; there are %1"),
    QT_TRANSLATE_NOOP("Core", "no such panel; there are %1"),
    QT_TRANSLATE_NOOP("Core", "no such equation; there are %1"),
    QT_TRANSLATE_NOOP("Core", "\"%1\": %2"),
    // flatland/io/left_out.h, comfortable.cpp, svg_file.cpp, ui/import/glyph.cpp: what an import
    // did
    QT_TRANSLATE_NOOP("Core", "y turned up"),
    QT_TRANSLATE_NOOP("Core", "scaled by %1 and centred"),
    QT_TRANSLATE_NOOP("Core", "centred"),
    QT_TRANSLATE_NOOP("Core", "1 gradient"),
    QT_TRANSLATE_NOOP("Core", "%1 gradients"),
    QT_TRANSLATE_NOOP("Core", "1 pattern"),
    QT_TRANSLATE_NOOP("Core", "%1 patterns"),
    QT_TRANSLATE_NOOP("Core", "1 filter"),
    QT_TRANSLATE_NOOP("Core", "%1 filters"),
    QT_TRANSLATE_NOOP("Core", "1 style rule"),
    QT_TRANSLATE_NOOP("Core", "%1 style rules"),
    QT_TRANSLATE_NOOP("Core", "1 hidden element"),
    QT_TRANSLATE_NOOP("Core", "%1 hidden elements"),
    QT_TRANSLATE_NOOP("Core", "1 clip path"),
    QT_TRANSLATE_NOOP("Core", "%1 clip paths"),
    QT_TRANSLATE_NOOP("Core", "1 mask"),
    QT_TRANSLATE_NOOP("Core", "%1 masks"),
    QT_TRANSLATE_NOOP("Core", "1 text"),
    QT_TRANSLATE_NOOP("Core", "%1 texts"),
    QT_TRANSLATE_NOOP("Core", "1 image"),
    QT_TRANSLATE_NOOP("Core", "%1 images"),
    QT_TRANSLATE_NOOP("Core", "1 foreign object"),
    QT_TRANSLATE_NOOP("Core", "%1 foreign objects"),
    QT_TRANSLATE_NOOP("Core", "1 reference to what is not there"),
    QT_TRANSLATE_NOOP("Core", "%1 references to what is not there"),
    QT_TRANSLATE_NOOP("Core", "1 shape with neither fill nor stroke"),
    QT_TRANSLATE_NOOP("Core", "%1 shapes with neither fill nor stroke"),
    QT_TRANSLATE_NOOP("Core", "1 subpath without length"),
    QT_TRANSLATE_NOOP("Core", "%1 subpaths without length"),
    QT_TRANSLATE_NOOP("Core", "1 segment of zero length"),
    QT_TRANSLATE_NOOP("Core", "%1 segments of zero length"),
    QT_TRANSLATE_NOOP("Core", "1 curve of %1"),
    QT_TRANSLATE_NOOP("Core", "%1 curves of %2"),
    QT_TRANSLATE_NOOP("Core", "1 curve"),
    QT_TRANSLATE_NOOP("Core", "%1 curves"),
};

// Its value is a list with commas, each of which is a clause of its own.
constexpr const char* kLeftOut = QT_TRANSLATE_NOOP("Core", "left out: %1");

struct Sentence {
  const char* english;
  QRegularExpression form;
};

const std::vector<Sentence>& sentences() {
  static const std::vector<Sentence> kForms = [] {
    static const QRegularExpression value(QStringLiteral("%[1-9]"));
    std::vector<Sentence> forms;
    const auto meshes = meshSentences();
    std::vector<const char*> all(meshes.begin(), meshes.end());
    all.insert(all.end(), std::begin(kSentences), std::end(kSentences));
    for (const char* english : all) {
      QStringList words = QString::fromUtf8(english).split(value);
      for (QString& part : words) part = QRegularExpression::escape(part);
      const QString form = words.join(QStringLiteral("(.+?)"));
      forms.push_back(
          {english, QRegularExpression(QRegularExpression::anchoredPattern(form),
                                       QRegularExpression::DotMatchesEverythingOption)});
    }
    return forms;
  }();
  return kForms;
}

QString clausesInWords(const QString& english) {
  const QString comma = QStringLiteral(", ");
  QStringList clauses = english.split(comma);
  for (QString& clause : clauses) clause = coreWords(clause.toStdString());
  return clauses.join(comma);
}

}  // namespace

std::optional<QString> sentenceInWords(const QString& english) {
  static const QString leftOut = QString::fromLatin1(kLeftOut).remove(QStringLiteral("%1"));
  if (english.startsWith(leftOut)) {
    return QCoreApplication::translate("Core", kLeftOut)
        .arg(clausesInWords(english.mid(leftOut.size())));
  }
  for (const Sentence& sentence : sentences()) {
    const QRegularExpressionMatch match = sentence.form.match(english);
    if (!match.hasMatch()) continue;
    QString text = QCoreApplication::translate("Core", sentence.english);
    if (text == QLatin1String(sentence.english)) return std::nullopt;
    // From the last, so that a value that holds a %1 is not filled in again.
    for (int i = match.lastCapturedIndex(); i > 0; --i) {
      const QString slot = QStringLiteral("%%1").arg(i);
      text.replace(slot, coreWords(match.captured(i).toStdString()));
    }
    return text;
  }
  return std::nullopt;
}

QString importForPeople(const ImportedScene& imported) {
  const QString done = clausesInWords(QString::fromStdString(imported.done));
  if (imported.leftOut.empty()) return done;
  return done + QStringLiteral("; ") + coreWords(imported.leftOut);
}

QString errorForPeople(const InputError& error) {
  // what() is source, place and reason, each but the last followed by a colon, if there is one.
  const std::string whole = error.what();
  const std::string tail =
      (error.place().empty() ? std::string() : error.place() + ": ") + error.reason();
  QString text = QString::fromStdString(whole.substr(0, whole.size() - tail.size()));
  if (!error.place().empty()) text += coreWords(error.place()) + QStringLiteral(": ");
  return text + coreWords(error.reason());
}

}  // namespace flatland::ui
