// SPDX-License-Identifier: MIT
#include "core3d/io/named_mesh.h"

#include <charconv>
#include <filesystem>

#include "core3d/io/read_mesh.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

std::string typedName(std::string name) {
  for (char& c : name) {
    if (c == ' ') c = '-';
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

std::vector<std::string_view> partsOf(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t colon = text.find(':');
    parts.push_back(text.substr(0, colon));
    if (colon == std::string_view::npos) return parts;
    text.remove_prefix(colon + 1);
  }
}

BuiltMesh builtSolid(const std::string& reference) {
  const auto parts = partsOf(std::string_view(reference).substr(kSolidReference.size()));
  const std::optional<Solid> solid = solidNamed(parts[0]);
  if (!solid) {
    std::string known;
    for (const std::string& name : solidNames()) known += (known.empty() ? "" : ", ") + name;
    throw InputError(reference, "", "no such solid; there are " + known);
  }
  Meshing meshing{.cells = kNamedSolidCells};
  if (parts.size() > 1) {
    const char* end = parts[1].data() + parts[1].size();
    const auto [stopped, error] = std::from_chars(parts[1].data(), end, meshing.cells);
    if (error != std::errc() || stopped != end || meshing.cells < kFewestNamedCells ||
        meshing.cells > kMostNamedCells) {
      throw InputError(reference, "",
                       "expected a number of cells from " + std::to_string(kFewestNamedCells) +
                           " to " + std::to_string(kMostNamedCells) + ", found \"" +
                           std::string(parts[1]) + "\"");
    }
  }
  if (parts.size() > 2) meshing.irregular = true;
  if (parts.size() > 3 || (parts.size() > 2 && parts[2] != "irregular")) {
    throw InputError(reference, "",
                     "a solid is solid:NAME, solid:NAME:CELLS or "
                     "solid:NAME:CELLS:irregular");
  }
  return buildMesh(meshOf(*solid, meshing).soup, reference);
}

}  // namespace

std::vector<std::string> solidNames() {
  std::vector<std::string> names;
  for (const Solid& solid : standardSolids()) names.push_back(typedName(solid.name()));
  return names;
}

std::optional<Solid> solidNamed(std::string_view name) {
  for (const Solid& solid : standardSolids()) {
    if (typedName(solid.name()) == name) return solid;
  }
  return std::nullopt;
}

BuiltMesh loadNamedMesh(const std::string& reference) {
  return reference.starts_with(kSolidReference) ? builtSolid(reference) : loadMesh(reference);
}

std::string nameOfMesh(const std::string& reference) {
  if (reference.starts_with(kSolidReference)) return reference;
  return std::filesystem::path(reference).filename().string();
}

}  // namespace flatland
