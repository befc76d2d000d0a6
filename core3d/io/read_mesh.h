// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/polygon_soup.h"

namespace flatland {

/// The mesh in a file: PLY, OBJ, STL, OFF, glTF or GLB. The format is known by the content where it
/// has a mark, else by the file's extension. The file is read once and as a whole.
///
/// Throws InputError with the file, the line or byte and the reason: what is not such a file, is
/// cut short, has an index that leads nowhere or a number that is none, has no faces or none with
/// an area. What was passed over or mended stands in the report. Nothing is allocated that the
/// length of the file does not justify.
BuiltMesh loadMesh(const std::filesystem::path& file);

/// The same before it is checked and mended.
PolygonSoup readPolygons(const std::filesystem::path& file);

/// The whole of a regular file. Throws InputError with the system's reason.
std::string readWholeFile(const std::filesystem::path& file);

// The readers themselves, over the bytes of a file. `source` names the file in messages.

/// Ascii and binary of both byte orders; any elements and properties around x, y, z of "vertex";
/// faces
/// ("vertex_indices" or "vertex_index") and triangle strips ("tristrips", -1 begins a new one).
PolygonSoup readPly(std::string_view bytes, const std::string& source);

/// v and f with all forms of index, also negative; records of other kinds are passed over. Faces
/// with less than three corners are left out with a note.
PolygonSoup readObj(std::string_view bytes, const std::string& source);

/// Ascii (also several solids) and binary, told apart by the length that a binary one must have.
/// Every facet has vertices of its own; buildMesh welds them.
PolygonSoup readStl(std::string_view bytes, const std::string& source);

/// Ascii and binary: OFF with any of the prefixes ST, C, N, 4 (homogeneous) and n (if of three
/// dimensions), or without the word; colours are passed over. Lines may be broken anywhere, but
/// have to end after the vertices and after each face.
PolygonSoup readOff(std::string_view bytes, const std::string& source);

/// glTF 2.0 as text or binary (GLB): all meshes of the default scene (without one: of all nodes;
/// without nodes: all meshes) with their nodes' transforms, as triangles, strips and fans; sparse
/// accessors too. Skins and morph targets are passed over. Buffers in other files are read from
/// `folder` and below alone; with an empty folder from nowhere.
PolygonSoup readGltf(std::string_view bytes, const std::string& source,
                     const std::filesystem::path& folder);

}  // namespace flatland
