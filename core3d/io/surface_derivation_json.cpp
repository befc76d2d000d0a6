// SPDX-License-Identifier: MIT
#include "core3d/io/surface_derivation_json.h"

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

std::string surfaceDerivationToJson(const SurfaceDerivation& derivation) {
  ordered_json root{{"flatland", 1}, {"place", placeJson(derivation)}};
  if (derivation.place) root["matrices"] = matricesJson(*derivation.place);
  std::string text = root.dump(1);
  text.resize(text.rfind('\n'));  // open again
  return text + ",\n \"steps\": " + derivationStepsJson(derivation.rows) + "\n}\n";
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

}  // namespace flatland
