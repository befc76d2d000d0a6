// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/glyph.h"

#include <QFontDatabase>
#include <QPainterPath>
#include <QRawFont>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "flatland/io/comfortable.h"
#include "flatland/io/input_error.h"
#include "flatland/io/left_out.h"
#include "flatland/io/svg_path.h"

namespace flatland::ui {

namespace {

constexpr char kPrefix[] = "glyph:";
constexpr int kNamesShown = 3;
constexpr qsizetype kFamiliesAsked = 300;

/// How many letters must be changed, put in or taken out to make one name the other.
int editDistance(const QString& a, const QString& b) {
  std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = static_cast<int>(j);
  for (qsizetype i = 0; i < a.size(); ++i) {
    int diagonal = row[0]++;
    for (std::size_t j = 1; j < row.size(); ++j) {
      const int change = diagonal + (a[i] == b[static_cast<qsizetype>(j) - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// The family of this name in upper or lower case. Where two foundries have one of the same name,
/// Qt calls them "Nimbus Roman [urw]" and so on; without the bracket the first of them is meant.
QStringList::const_iterator familyNamed(const QString& name, const QStringList& families) {
  const auto found = [&](const auto& nameOf) {
    return std::find_if(families.begin(), families.end(), [&](const QString& family) {
      return nameOf(family).compare(name, Qt::CaseInsensitive) == 0;
    });
  };
  const auto exact = found([](const QString& family) { return family; });
  if (exact != families.end()) return exact;
  return found([](const QString& family) { return family.left(family.indexOf(" [")); });
}

std::string nearestFamilies(const QString& name, QStringList families) {
  const QString asked = name.toLower();
  // A name that holds the one asked for, or the reverse, is nearer than any misspelling.
  const auto farness = [&](const QString& family) {
    const QString known = family.toLower();
    const bool within = !asked.isEmpty() && (known.contains(asked) || asked.contains(known));
    return editDistance(asked, known) - (within ? 100 : 0);
  };
  std::stable_sort(families.begin(), families.end(),
                   [&](const QString& a, const QString& b) { return farness(a) < farness(b); });
  return families.mid(0, kNamesShown).join(", ").toStdString();
}

QString codeOf(char32_t character) {
  return QStringLiteral("U+%1")
      .arg(static_cast<uint>(character), 4, 16, QLatin1Char('0'))
      .toUpper();
}

/// The font of the family itself, at one pixel per unit of its em; nothing put in for it.
QRawFont rawFont(const QString& family) {
  QFont font(family);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setStyleStrategy(QFont::NoFontMerging);
  QRawFont raw = QRawFont::fromFont(font);
  if (raw.isValid() && raw.unitsPerEm() > 0.0) raw.setPixelSize(raw.unitsPerEm());
  return raw;
}

std::string familiesWith(char32_t character, const QStringList& families) {
  QStringList having;
  for (const QString& family : families.mid(0, kFamiliesAsked)) {
    const QRawFont raw = rawFont(family);
    if (!raw.isValid() || !raw.supportsCharacter(static_cast<uint>(character))) continue;
    having.append(family);
    if (having.size() == kNamesShown) break;
  }
  return having.isEmpty() ? "nor has any other font here"
                          : "these have: " + having.join(", ").toStdString();
}

/// The quadratic curve that Qt stored as this cubic, if it was one: TrueType outlines are, with
/// control points at whole or half units.
std::optional<Vec2> quadraticHandle(const Bezier& cubic) {
  const auto& p = cubic.points;
  const Vec2 third = p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0];
  const double size = std::max((p[3] - p[0]).norm(), (p[1] - p[0]).norm());
  if (third.norm() > 1e-9 * size) return std::nullopt;
  const Vec2 handle = 0.5 * (3.0 * p[1] - p[0]);
  const Vec2 halves = (2.0 * handle).array().round() / 2.0;
  return (handle - halves).norm() <= 1e-6 * size ? halves : handle;
}

std::vector<Subpath> subpathsOf(const QPainterPath& path) {
  std::vector<Subpath> subpaths;
  Vec2 at = Vec2::Zero();
  // Qt's y points down.
  const auto point = [&](int i) { return Vec2(path.elementAt(i).x, -path.elementAt(i).y); };
  for (int i = 0; i < path.elementCount(); ++i) {
    const QPainterPath::Element element = path.elementAt(i);
    if (element.isMoveTo()) {
      at = point(i);
      subpaths.push_back({at, {}, true});
      continue;
    }
    std::vector<Vec2> points{at, point(i)};
    if (element.isCurveTo()) {
      points.push_back(point(++i));
      points.push_back(point(++i));
    }
    at = points.back();
    subpaths.back().segments.push_back({std::move(points)});
  }
  return subpaths;
}

/// Quadratic where all curves are: the font's own control points again.
void lowerDegree(std::vector<Subpath>& subpaths) {
  for (const Subpath& subpath : subpaths) {
    for (const Bezier& segment : subpath.segments) {
      if (segment.degree() == 3 && !quadraticHandle(segment)) return;
    }
  }
  for (Subpath& subpath : subpaths) {
    for (Bezier& segment : subpath.segments) {
      if (segment.degree() != 3) continue;
      segment = {{segment.points[0], *quadraticHandle(segment), segment.points[3]}};
    }
  }
}

}  // namespace

std::string GlyphName::argument() const {
  return kPrefix + (family + ":" + QString::fromUcs4(&character, 1)).toStdString();
}

GlyphName glyphNamed(const std::string& argument) {
  const QString text = QString::fromStdString(argument).mid(QString(kPrefix).size());
  // A family's name has no colon; the character may be one.
  const qsizetype colon = text.indexOf(':');
  const auto fail = [&](const char* reason) { throw InputError(argument, "", reason); };
  if (colon <= 0) fail("expected glyph:FAMILY:CHARACTER, for example glyph:DejaVu Sans:a");
  const QString letter = text.mid(colon + 1);
  GlyphName name{text.left(colon).trimmed()};
  if (letter.size() > 2 && letter.startsWith("U+", Qt::CaseInsensitive)) {
    bool isCode = false;
    name.character = letter.mid(2).toUInt(&isCode, 16);
    if (!isCode || name.character > 0x10FFFF) fail("expected a code such as U+0061 after U+");
    return name;
  }
  const QList<uint> codes = letter.toUcs4();
  if (codes.size() != 1) fail("expected one character after the family's name");
  name.character = codes.front();
  return name;
}

ImportedScene glyphScene(const GlyphName& name) {
  const std::string source = name.argument();
  const QStringList families = QFontDatabase::families();
  const auto known = familyNamed(name.family, families);
  if (known == families.end()) {
    throw InputError(source, "",
                     families.isEmpty() ? "there are no fonts here"
                                        : "there is no such font here; the nearest names are " +
                                              nearestFamilies(name.family, families));
  }
  const QRawFont font = rawFont(*known);
  if (!font.isValid() || !(font.unitsPerEm() > 0.0)) {
    throw InputError(source, "", "is a font without outlines");
  }
  const QList<quint32> glyphs = font.glyphIndexesForString(QString::fromUcs4(&name.character, 1));
  if (glyphs.size() != 1 || glyphs.front() == 0) {
    throw InputError(source, "",
                     "the font has no glyph for " + codeOf(name.character).toStdString() + "; " +
                         familiesWith(name.character, families));
  }
  std::vector<Subpath> subpaths = subpathsOf(font.pathForGlyph(glyphs.front()));
  lowerDegree(subpaths);
  ChainNotes notes;
  ImportedScene result;
  for (const Subpath& subpath : subpaths) {
    if (auto chain = chainOf(subpath, notes))
      result.scene.curves.push_back({std::move(*chain), false});
  }
  if (result.scene.curves.empty()) throw InputError(source, "", "has no outline, it is blank");
  LeftOut leftOut;
  leftOut.count("segment of zero length", notes.zeroLengthSegments);
  result.leftOut = leftOut.text();
  result.done = countText("curve", static_cast<int>(result.scene.curves.size())) + " of " +
                font.familyName().toStdString() + ", " + makeComfortable(result.scene, source);
  return result;
}

}  // namespace flatland::ui
