// SPDX-License-Identifier: GPL-3.0-or-later
// Contact sheets: every example mesh as contours alone, with suggestive contours, with ridges and
// valleys, and with apparent ridges, at equal ink; and how much of the apparent ridges' length lies
// in strokes, ours against the one-ring method at equal ink. Run by ./dev contact-sheets.
//
//   contact_sheets VIEWS MESHES OUT [NAME...]
//
// VIEWS lists the meshes with their views (contact_sheets.txt), MESHES is the folder they lie in,
// OUT the folder for the sheets; with NAMEs only these meshes.
#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/io/read_mesh.h"
#include "flatland/io/atomic_file.h"
#include "ui/export/drawing_figure.h"
#include "ui/export/figure_qt.h"

namespace {

using namespace flatland;
using namespace flatland::ui;
namespace fs = std::filesystem;

constexpr double kWidth = 800.0, kHeight = 600.0;  // px of a drawing
constexpr double kShrink = 0.36;                   // on the sheets
constexpr double kLinePx = 1.9;                    // in the drawing, so that it stays a line there
constexpr double kCaptionPx = 16.0;
constexpr int kColumns = 4;
constexpr std::size_t kRows = 7;  // meshes on a sheet

struct Subject {
  std::string file;
  Camera camera;
};

std::vector<Subject> subjectsOf(const std::string& views) {
  std::ifstream in(views);
  if (!in) throw std::runtime_error("cannot read " + views);
  std::vector<Subject> subjects;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    Subject subject;
    Camera& camera = subject.camera;
    fields >> subject.file >> camera.towards.x() >> camera.towards.y() >> camera.towards.z() >>
        camera.up.x() >> camera.up.y() >> camera.up.z();
    if (!fields) throw std::runtime_error(views + ": not a mesh with view and up: " + line);
    camera.towards.normalize();
    camera.width = kWidth;
    camera.height = kHeight;
    subjects.push_back(subject);
  }
  return subjects;
}

LineOptions linesWith(std::initializer_list<LineFamily> families) {
  LineOptions lines;
  for (const LineFamily family : families) lines[family] = true;
  return lines;
}

/// What is said of a mesh: apparent ridges alone, ours against the one-ring method.
struct Shares {
  double oneRingInk, oneRing, oursInk, ours;
  std::size_t oneRingStrokes, oursStrokes;
};

Shares sharesOf(Draughtsman& ours, Draughtsman& oneRing, const Projection& projection) {
  LineOptions lines = linesWith({LineFamily::ApparentRidges});
  StrokeOptions strokes;
  LineOptions practised = lines;
  practised.derivative = RidgeDerivative::OneRing;
  const Drawing rough = oneRing.draw(projection, practised, strokes);
  if (rough.stats.ink > 0.0) strokes.ink = rough.stats.ink;
  const Drawing fine = ours.draw(projection, lines, strokes);
  return {rough.stats.ink,  rough.stats.share,      fine.stats.ink,
          fine.stats.share, rough.polylines.size(), fine.polylines.size()};
}

/// The four drawings of a mesh. The last has the program's own thresholds, the others its ink.
std::vector<Drawing> drawingsOf(Draughtsman& draughtsman, const Projection& projection) {
  using enum LineFamily;
  StrokeOptions strokes;
  const auto draw = [&](std::initializer_list<LineFamily> more) {
    LineOptions lines = linesWith(more);
    lines[OccludingContours] = lines[Boundaries] = true;
    return draughtsman.draw(projection, lines, strokes);
  };
  Drawing apparent = draw({ApparentRidges});
  strokes.ink = apparent.stats.ink;
  Drawing suggestive = draw({SuggestiveContours});
  Drawing ridges = draw({Ridges, Valleys});
  strokes.ink.reset();
  std::vector<Drawing> all;
  all.push_back(draw({}));
  all.push_back(std::move(suggestive));
  all.push_back(std::move(ridges));
  all.push_back(std::move(apparent));
  return all;
}

struct Row {
  std::string file;
  std::vector<Drawing> drawings;
};

void saveSheet(const std::vector<Row>& rows, const fs::path& file) {
  const char* const columns[kColumns] = {"contours", "+ suggestive contours",
                                         "+ ridges and valleys", "+ apparent ridges"};
  const double width = kShrink * kWidth, height = kShrink * kHeight + kCaptionPx;
  QImage image(static_cast<int>(kColumns * width),
               static_cast<int>(height * static_cast<double>(rows.size())),
               QImage::Format_Grayscale8);
  image.fill(Qt::white);
  QPainter painter(&image);
  QFont font("DejaVu Sans");
  font.setPixelSize(11);
  painter.setFont(font);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].drawings.size(); ++c) {
      const Drawing& drawing = rows[r].drawings[c];
      DrawingFigureOptions options{.widthPx = kLinePx, .transparent = true};
      painter.save();
      painter.translate(static_cast<double>(c) * width, static_cast<double>(r) * height);
      painter.drawText(QPointF(6, 12),
                       QString::fromStdString((c == 0 ? rows[r].file + "  " : "") + columns[c]) +
                           QString("  %1 %").arg(100 * drawing.stats.ink, 0, 'f', 1));
      painter.translate(0, kCaptionPx);
      painter.scale(kShrink, kShrink);
      paintFigure(painter, drawingFigure(drawing, options));
      painter.restore();
    }
  }
  painter.end();
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG", 0);
  writeFileAtomically(file, buffer.data().toStdString());
  std::fprintf(stderr, "%s\n", file.filename().c_str());
}

void run(const std::vector<std::string>& arguments) {
  const fs::path meshes = arguments[1], out = arguments[2];
  fs::create_directories(out);
  std::vector<Row> rows;
  int sheets = 0;
  std::puts(
      "mesh                    triangles | one-ring: ink   share strokes | ours: ink   share "
      "strokes");
  for (const Subject& subject : subjectsOf(arguments[0])) {
    if (arguments.size() > 3 &&
        std::find(arguments.begin() + 3, arguments.end(), subject.file) == arguments.end()) {
      continue;
    }
    const BuiltMesh built = loadMesh(meshes / subject.file);
    const Projection projection = projectionOf(subject.camera, built.mesh);
    const SurfaceFields fields = estimateFields(built.mesh);
    Draughtsman ours(built.mesh, fields);
    {
      const SurfaceFields rough =
          estimateFields(built.mesh, {.estimator = FieldEstimator::OneRing});
      Draughtsman oneRing(built.mesh, rough);
      const Shares s = sharesOf(ours, oneRing, projection);
      std::printf("%-23s %9zu |       %6.4f %7.2f %7zu | %6.4f %9.2f %7zu\n", subject.file.c_str(),
                  built.mesh.triangleCount(), s.oneRingInk, s.oneRing, s.oneRingStrokes, s.oursInk,
                  s.ours, s.oursStrokes);
      std::fflush(stdout);
    }
    rows.push_back({subject.file, drawingsOf(ours, projection)});
    if (rows.size() == kRows) {
      saveSheet(rows, out / ("meshes-" + std::to_string(++sheets) + ".png"));
      rows.clear();
    }
  }
  if (!rows.empty()) saveSheet(rows, out / ("meshes-" + std::to_string(++sheets) + ".png"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("contact_sheets VIEWS MESHES OUT [NAME...]\n", stderr);
    return 2;
  }
  const QGuiApplication application(argc, argv);
  try {
    run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "contact_sheets: %s\n", error.what());
    return 1;
  }
  return 0;
}
