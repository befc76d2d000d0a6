// SPDX-License-Identifier: MIT
#include "core3d/mesh/mesh_report.h"

namespace flatland {

std::vector<std::string> MeshReport::sentences() const {
  std::vector<std::string> all = notes;
  const auto tell = [&all](std::size_t count, const char* one, const char* many, const char* rest) {
    if (count > 0) {
      all.push_back(std::to_string(count) + " " + (count == 1 ? one : many) + " " + rest);
    }
  };
  tell(isolatedVertices, "vertex", "vertices", "without a face left out");
  tell(weldedVertices, "vertex", "vertices", "welded to another at the same place");
  tell(foldedPolygons, "face that crosses itself", "faces that cross themselves",
       "triangulated with overlaps");
  tell(hugePolygons, "very large face", "very large faces", "made a fan, which may fold over");
  tell(collapsedTriangles, "triangle", "triangles", "with two corners at one place left out");
  tell(duplicateTriangles, "triangle", "triangles", "that repeat another left out");
  tell(strayTriangles, "triangle", "triangles", "of pieces without area left out");
  tell(turnedTriangles, "triangle", "triangles", "turned to agree with their neighbours");
  tell(invertedPieces, "piece that was", "pieces that were", "inside out turned outward");
  tell(flatTriangles, "triangle", "triangles", "without area kept");
  tell(nonManifoldEdges, "edge", "edges", "with more than two triangles cut");
  tell(nonManifoldVertices, "vertex", "vertices", "where surfaces touch cut apart");
  tell(unorientableEdges, "edge", "edges", "cut, because the surface has one side only");
  return all;
}

}  // namespace flatland
