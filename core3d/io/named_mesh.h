// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"

namespace flatland {

/// The names of the standard solids (solids.h) as they are typed: "sphere", "gaussian-bump".
std::vector<std::string> solidNames();

/// The standard solid of a name; nullopt if there is none.
std::optional<Solid> solidNamed(std::string_view name);

inline constexpr std::string_view kSolidReference = "solid:";
inline constexpr int kNamedSolidCells = 100;  ///< if a reference does not say
inline constexpr int kFewestNamedCells = 3;   ///< of a reference
inline constexpr int kMostNamedCells = 2000;  ///< 48 million triangles on a globe

/// The mesh that a reference names: a file, or "solid:NAME", "solid:NAME:CELLS",
/// "solid:NAME:CELLS:irregular" (Meshing::cells, Meshing::irregular). Throws InputError as
/// loadMesh, and with the valid names for a solid that does not exist.
BuiltMesh loadNamedMesh(const std::string& reference);

/// What a person calls it: the file without its folder, or the reference to a solid.
std::string nameOfMesh(const std::string& reference);

}  // namespace flatland
