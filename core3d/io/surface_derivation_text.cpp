// SPDX-License-Identifier: MIT
#include "core3d/io/surface_derivation_text.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace flatland {

namespace {

using Lesson = TriangleLesson;

/// As printf, appended.
[[gnu::format(printf, 2, 3)]] void add(std::string& text, const char* format, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  text.append(buffer, static_cast<std::size_t>(std::min<int>(length, sizeof buffer - 1)));
}

void addMatrix(std::string& text, const char* name, const Eigen::Matrix2d& m) {
  add(text, "  %-5s = ( %.6g  %.6g ; %.6g  %.6g )\n", name, m(0, 0), m(0, 1), m(1, 0), m(1, 1));
}

void addMatrices(std::string& text, const SurfacePlace& place) {
  const SurfaceMatrices m = surfaceMatrices(place);
  const auto& c = place.point.C.coefficients;
  addMatrix(text, "K", m.K);
  add(text, "  C     = %.6g  %.6g  %.6g  %.6g\n", c[0], c[1], c[2], c[3]);
  add(text, "  w_T   = %.6g  %.6g,  n.w = %.6g\n", m.wT.x(), m.wT.y(), m.nw);
  addMatrix(text, "P", m.P);
  if (!m.seen) return;
  addMatrix(text, "P^-1", m.inverseP);
  addMatrix(text, "Q", m.Q);
  addMatrix(text, "Q^T Q", m.QtQ);
  add(text, "  lambda = %.6g (the other eigenvalue %.6g)\n", m.seen->lambda, m.otherLambda);
  add(text, "  t_A   = %.6g  %.6g on the screen, over r = %.6g  %.6g\n", m.tA.x(), m.tA.y(),
      m.seen->r.x(), m.seen->r.y());
  add(text, "  1/2 D lambda = feature %.6g + offset %.6g", m.seen->feature, m.seen->offset);
  if (place.distance) add(text, " + perspective %.6g", m.seen->perspective);
  text += "\n";
}

}  // namespace

SurfaceDerivation surfaceDerivationAt(const TriangleMesh& mesh, const SurfaceFields& fields,
                                      const SurfaceView& view, const Eigen::Vector3d& right,
                                      std::uint32_t vertex) {
  SurfaceDerivation d{mesh.fileVertex[vertex],
                      mesh.positionInFile(vertex),
                      fields.size * mesh.unit,
                      surfacePlaceAt(mesh, fields, view, right, vertex),
                      {}};
  for (int i = 0; i < kSurfaceStepCount; ++i) {
    const auto step = static_cast<SurfaceStep>(i);
    DerivationRow row{textOf(step), {StepAnswer::NoNormal, {}, {}}, {}};
    if (d.place) {
      row.reading = readStep(step, *d.place);
      row.sweep = stepSizeSweep(step, *d.place);
    }
    d.rows.push_back(std::move(row));
  }
  return d;
}

std::string surfaceDerivationToText(const SurfaceDerivation& d) {
  std::string text;
  add(text,
      "Vertex %u of the file, at %.6g, %.6g, %.6g. Lengths in units of the surface's size, "
      "%.6g there.\n",
      d.fileVertex, d.inFile.x(), d.inFile.y(), d.inFile.z(), d.size);
  if (d.place) addMatrices(text, *d.place);
  return text + "\n" + derivationToText(d.rows);
}

std::string triangleLessonToText(const TriangleMesh& mesh, const TriangleLesson& lesson) {
  std::string text;
  add(text, "Triangle of face %u of the file\n\n(a) the derivative of lambda along t_A\n",
      mesh.filePolygon[lesson.triangle]);
  for (int k = 0; k < 3; ++k) {
    const Lesson::Corner& corner = lesson.corners[static_cast<std::size_t>(k)];
    add(text, "  corner %d  vertex %u: lambda %.6g, half derivative %.6g, by the ring %.6g\n", k,
        mesh.fileVertex[corner.vertex], corner.lambda, corner.derivative, corner.ringDerivative);
  }
  text += "(b) t_A turned to where lambda grows\n";
  for (int k = 0; k < 3; ++k) {
    const Lesson::Corner& corner = lesson.corners[static_cast<std::size_t>(k)];
    const Eigen::Vector3d& r = corner.growing;
    add(text, "  corner %d  %s: %.4f, %.4f, %.4f\n", k, corner.flipped ? "flipped" : "as it came",
        r.x(), r.y(), r.z());
  }
  text += "(c) crossings\n";
  if (lesson.crossings.empty()) text += "  none\n";
  for (const Lesson::Crossing& crossing : lesson.crossings) {
    add(text, "  on edge %d-%d at %.4f (by the derivatives alone %.4f), strength %.6g\n",
        crossing.corner, (crossing.corner + 1) % 3, crossing.t, crossing.thesisT,
        crossing.strength);
  }
  text += "(d) perpendiculars\n";
  for (const Lesson::Piece& piece : lesson.pieces) {
    for (const Lesson::Piece::Test& test : piece.tests) {
      add(text, "  corner %d  cosine %.4f: %s\n", test.corner, test.cosine,
          test.passes ? "towards the line" : "away from it");
    }
    add(text, "  so it is a %s of lambda; strength %.6g, threshold %.6g; it falls by %.3g\n",
        piece.isMaximum ? "maximum" : "minimum", piece.strength, lesson.threshold, piece.fall);
  }
  add(text, "\nVerdict: %s. Drawn: %s%s\n", std::string(nameOf(lesson.verdict)).c_str(),
      lesson.drawn ? "yes" : "no",
      lesson.followsNeighbour() ? ", as the triangle before it on the line" : "");
  return text;
}

}  // namespace flatland
