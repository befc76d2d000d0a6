// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace flatland {

/// What buildMesh found and did, in counts. Edges and vertices are counted after welding and before
/// anything is cut.
struct MeshReport {
  std::size_t fileVertices = 0;
  std::size_t filePolygons = 0;
  std::vector<std::string> notes;  ///< of the reader, see PolygonSoup::notes

  // Mended.
  std::size_t isolatedVertices = 0;    ///< no face uses them; left out
  std::size_t weldedVertices = 0;      ///< at the place of another one; made one with it
  std::size_t foldedPolygons = 0;      ///< cross themselves: the triangles overlap somewhere
  std::size_t hugePolygons = 0;        ///< too costly to triangulate properly; made a fan
  std::size_t collapsedTriangles = 0;  ///< use one vertex twice; left out
  std::size_t duplicateTriangles = 0;  ///< repeat another one, either way round; left out
  std::size_t strayTriangles = 0;      ///< of pieces without any area; left out
  std::size_t turnedTriangles = 0;     ///< turned round to agree with their neighbours
  std::size_t invertedPieces = 0;      ///< inside out; turned as wholes

  // Left as they are, or cut.
  std::size_t flatTriangles = 0;        ///< three vertices in one line; kept, they carry no weight
  std::size_t nonManifoldEdges = 0;     ///< more than two triangles; cut
  std::size_t nonManifoldVertices = 0;  ///< more than one fan after that; one vertex for each fan
  std::size_t unorientableEdges = 0;    ///< cut, because no winding suits both sides (Moebius)
  std::size_t borderEdges = 0;          ///< one triangle
  std::size_t edges = 0;                ///< all of them, each once
  std::size_t pieces = 0;               ///< connected over edges of two triangles

  /// The same in words, one sentence for everything worth telling; empty for a flawless mesh.
  std::vector<std::string> sentences() const;
};

}  // namespace flatland
