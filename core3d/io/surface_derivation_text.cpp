// SPDX-License-Identifier: MIT
#include "core3d/io/surface_derivation_text.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace flatland {

namespace {

using nlohmann::ordered_json;
using Lesson = TriangleLesson;

ordered_json vectorJson(const Eigen::VectorXd& v) {
  ordered_json list = ordered_json::array();
  for (const double x : v) list.push_back(x);
  return list;
}

ordered_json matrixJson(const Eigen::Matrix2d& m) {
  return {{m(0, 0), m(0, 1)}, {m(1, 0), m(1, 1)}};
}

ordered_json placeJson(const SurfaceDerivation& d) {
  ordered_json place{{"vertex", d.fileVertex}, {"at", vectorJson(d.inFile)}, {"size", d.size}};
  if (!d.place) return place;
  const SurfacePoint& point = d.place->point;
  place["normal"] = vectorJson(point.n);
  place["t1"] = vectorJson(point.frame.col(0));
  place["t2"] = vectorJson(point.frame.col(1));
  place["towardsViewer"] = vectorJson(d.place->w);
  place["screenRight"] = vectorJson(d.place->ux);
  place["screenUp"] = vectorJson(d.place->uy);
  place["distance"] = d.place->distance ? ordered_json(*d.place->distance) : nullptr;
  return place;
}

ordered_json matricesJson(const SurfacePlace& place) {
  const SurfaceMatrices m = surfaceMatrices(place);
  ordered_json json{{"K", matrixJson(m.K)},
                    {"C", place.point.C.coefficients},
                    {"wT", vectorJson(m.wT)},
                    {"nw", m.nw},
                    {"P", matrixJson(m.P)}};
  if (!m.seen) return json;
  json["inverseP"] = matrixJson(m.inverseP);
  json["Q"] = matrixJson(m.Q);
  json["QtQ"] = matrixJson(m.QtQ);
  json["lambda"] = m.seen->lambda;
  json["otherLambda"] = m.otherLambda;
  json["tA"] = vectorJson(m.tA);
  json["r"] = vectorJson(m.seen->r);
  json["feature"] = m.seen->feature;
  json["offset"] = m.seen->offset;
  json["perspective"] = m.seen->perspective;
  return json;
}

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

ordered_json cornerJson(const TriangleMesh& mesh, const Lesson::Corner& corner) {
  ordered_json ring = ordered_json::array();
  for (std::size_t i = 0; i < corner.ring.size(); ++i) {
    ring.push_back({{"at", vectorJson(mesh.origin + mesh.unit * corner.ring[i])},
                    {"lambda", corner.ringLambda[i]}});
  }
  return {{"vertex", mesh.fileVertex[corner.vertex]},
          {"at", vectorJson(mesh.origin + mesh.unit * corner.at)},
          {"nw", corner.nw},
          {"lambda", corner.lambda},
          {"tA", vectorJson(corner.tangent)},
          {"halfDerivative", corner.derivative},
          {"flipped", corner.flipped},
          {"growing", vectorJson(corner.growing)},
          {"ring", std::move(ring)},
          {"ringHalfDerivative", corner.ringDerivative}};
}

ordered_json pieceJson(const TriangleMesh& mesh, const Lesson::Piece& piece) {
  ordered_json tests = ordered_json::array();
  for (const Lesson::Piece::Test& test : piece.tests) {
    tests.push_back({{"corner", test.corner},
                     {"foot", vectorJson(mesh.origin + mesh.unit * test.foot)},
                     {"cosine", test.cosine},
                     {"passes", test.passes}});
  }
  return {{"from", vectorJson(mesh.origin + mesh.unit * piece.a)},
          {"to", vectorJson(mesh.origin + mesh.unit * piece.b)},
          {"strength", piece.strength},
          {"tests", std::move(tests)},
          {"isMaximum", piece.isMaximum},
          {"fall", piece.fall},
          {"standsOut", piece.standsOut},
          {"drawn", piece.drawn}};
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

std::string surfaceDerivationToJson(const SurfaceDerivation& derivation) {
  ordered_json root{{"flatland", 1}, {"place", placeJson(derivation)}};
  if (derivation.place) root["matrices"] = matricesJson(*derivation.place);
  std::string text = root.dump(1);
  text.resize(text.rfind('\n'));  // open again
  return text + ",\n \"steps\": " + derivationStepsJson(derivation.rows) + "\n}\n";
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

std::string triangleLessonToJson(const TriangleMesh& mesh, const TriangleLesson& lesson) {
  ordered_json root{{"flatland", 1},
                    {"triangle", mesh.filePolygon[lesson.triangle]},
                    {"verdict", nameOf(lesson.verdict)},
                    {"drawn", lesson.drawn},
                    {"threshold", lesson.threshold},
                    {"corners", ordered_json::array()},
                    {"crossings", ordered_json::array()},
                    {"pieces", ordered_json::array()}};
  for (const Lesson::Corner& corner : lesson.corners) {
    root["corners"].push_back(cornerJson(mesh, corner));
  }
  for (const Lesson::Crossing& crossing : lesson.crossings) {
    root["crossings"].push_back({{"corner", crossing.corner},
                                 {"t", crossing.t},
                                 {"thesisT", crossing.thesisT},
                                 {"at", vectorJson(mesh.origin + mesh.unit * crossing.at)},
                                 {"strength", crossing.strength}});
  }
  for (const Lesson::Piece& piece : lesson.pieces) root["pieces"].push_back(pieceJson(mesh, piece));
  return root.dump(1) + "\n";
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
