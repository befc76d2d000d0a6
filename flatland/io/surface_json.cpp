// SPDX-License-Identifier: MIT
#include "flatland/io/surface_json.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "flatland/io/curve_json.h"
#include "flatland/io/input_error.h"
#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/scene/surface_names.h"
#include "flatland/view/perspective.h"

namespace flatland {

namespace {

using nlohmann::json;

constexpr double kNotParallel = 1e-6;  ///< sine of the smallest angle between towards and up
constexpr std::size_t kMostEntries = 1000;
constexpr int kMostLevels = 1000;

Eigen::Vector3d vectorFrom(const JsonNode& node) {
  if (node.listSize("three numbers") != 3) node.fail("expected three numbers");
  Eigen::Vector3d v;
  for (std::size_t k = 0; k < 3; ++k) v(static_cast<Eigen::Index>(k)) = node.at(k).length();
  return v;
}

/// A vector as a unit vector.
Eigen::Vector3d directionFrom(const JsonNode& node) {
  Eigen::Vector3d v = vectorFrom(node);
  const double length = v.norm();
  if (!(length > 0.0)) node.fail("expected a direction, found 0, 0, 0");
  // A direction of unit length is kept to its last bit.
  if (std::abs(length - 1.0) > 1e-12) v /= length;
  return v;
}

double positive(const JsonNode& node, double atLeast = 0.0) {
  const double value = node.length();
  if (value > 0.0 && value >= atLeast) return value;
  node.fail("expected a number " +
            (atLeast > 0.0 ? "of at least " + numberText(atLeast) : "above 0") + ", found " +
            numberText(value));
}

SurfaceCamera cameraFrom(const JsonNode& node) {
  node.allowKeys({"towards", "up", "centre", "zoom", "perspectiveDeg"});
  SurfaceCamera camera;
  if (const auto towards = node.find("towards")) camera.towards = directionFrom(*towards);
  if (const auto up = node.find("up")) camera.up = vectorFrom(*up);
  const double sine = camera.towards.cross(camera.up).norm();
  if (!(sine > kNotParallel * camera.up.norm())) node.fail("\"up\" lies along \"towards\"");
  if (const auto centre = node.find("centre")) camera.centre = vectorFrom(*centre);
  if (const auto zoom = node.find("zoom")) camera.zoom = positive(*zoom);
  const auto angle = node.find("perspectiveDeg");
  if (angle && !angle->value().is_null()) {
    camera.perspectiveDeg = angle->number();
    if (!isPerspective(*camera.perspectiveDeg)) {
      angle->fail("expected an angle from " + numberText(kLeastPerspectiveDeg) + " to " +
                  numberText(kMostPerspectiveDeg) + " degrees, found " +
                  numberText(*camera.perspectiveDeg));
    }
  }
  return camera;
}

/// One of the words of flatland/scene/surface_names.h, or of kUpAxes.
template <class Words>
std::string oneOf(const JsonNode& node, const Words& known) {
  const std::string word = node.text();
  if (std::find(std::begin(known), std::end(known), word) != std::end(known)) return word;
  std::string all;
  for (std::size_t i = 0; i < std::size(known); ++i) {
    all += (i == 0 ? "" : ", ") + std::string(known[i]);
  }
  node.fail("expected one of " + all + "; found " + word);
}

bool isColour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(),
                     [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
}

SurfaceFamily familyFrom(const JsonNode& node) {
  node.allowKeys({"name", "on", "threshold", "colour", "widthPx", "fade"});
  SurfaceFamily family;
  family.name = oneOf(node.at("name"), kLineFamilyNames);
  if (const auto on = node.find("on")) family.on = on->boolean();
  if (const auto threshold = node.find("threshold")) {
    family.threshold = threshold->length();
    if (!(*family.threshold >= 0.0)) threshold->fail("expected a threshold of 0 or above");
  }
  if (const auto colour = node.find("colour")) {
    family.colour = colour->text();
    if (!family.colour.empty() && !isColour(family.colour)) {
      colour->fail("expected a colour like \"#d55e00\", or none");
    }
  }
  if (const auto width = node.find("widthPx")) family.widthPx = positive(*width);
  if (const auto fade = node.find("fade")) family.fade = fade->boolean();
  return family;
}

SurfacePane paneFrom(const JsonNode& node) {
  node.allowKeys({"families", "derivative", "shows", "camera"});
  SurfacePane pane;
  const auto families = node.find("families");
  if (families && !families->value().is_null()) {
    const std::size_t count = families->listSize("a list of names");
    pane.families.emplace();
    for (std::size_t i = 0; i < count; ++i) {
      pane.families->push_back(oneOf(families->at(i), kLineFamilyNames));
    }
  }
  if (const auto derivative = node.find("derivative")) {
    pane.derivative = oneOf(*derivative, kDerivativeNames);
  }
  if (const auto shows = node.find("shows")) pane.shows = oneOf(*shows, kPaneShowsNames);
  const auto camera = node.find("camera");
  if (camera && !camera->value().is_null()) pane.camera = cameraFrom(*camera);
  return pane;
}

SweptSetting sweptFrom(const JsonNode& node) {
  node.allowKeys({"kind", "curve", "amount", "cells"});
  SweptSetting swept;
  swept.kind = oneOf(node.at("kind"), kSweptKindNames);
  if (const auto curve = node.find("curve")) {
    if (curve->wholeNumber() < 0) curve->fail("expected the index of a curve, from 0");
    swept.curve = static_cast<std::size_t>(curve->wholeNumber());
  }
  const JsonNode amount = node.at("amount");
  swept.amount = swept.kind == kSweptKindNames[0] ? positive(amount) : amount.length();
  if (const auto cells = node.find("cells")) {
    swept.cells = cells->wholeNumber();
    if (swept.cells < kFewestSweptCells || swept.cells > kMostSweptCells) {
      cells->fail("expected " + std::to_string(kFewestSweptCells) + " to " +
                  std::to_string(kMostSweptCells) + " cells");
    }
  }
  return swept;
}

SurfacePlane planeFrom(const JsonNode& node) {
  node.allowKeys({"point", "normal"});
  return {vectorFrom(node.at("point")), directionFrom(node.at("normal"))};
}

int levels(const JsonNode& node) {
  const int count = node.wholeNumber();
  if (count < 1 || count > kMostLevels) {
    node.fail("expected 1 to " + std::to_string(kMostLevels) + " levels");
  }
  return count;
}

std::size_t listSize(const JsonNode& node, const char* what) {
  const std::size_t count = node.listSize(what);
  if (count > kMostEntries) node.fail("more than " + std::to_string(kMostEntries) + " entries");
  return count;
}

std::string quoted(const std::string& text, const std::string& path) {
  try {
    return json(text).dump();
  } catch (const json::exception&) {
    throw InputError("the scene", path, "not text in UTF-8");
  }
}

std::string vectorText(const Eigen::Vector3d& v, const std::string& path) {
  return "[" + lengthText(v.x(), path) + ", " + lengthText(v.y(), path) + ", " +
         lengthText(v.z(), path) + "]";
}

std::string cameraText(const SurfaceCamera& camera, const std::string& path) {
  return "{\"towards\": " + vectorText(camera.towards, path) +
         ", \"up\": " + vectorText(camera.up, path) +
         ", \"centre\": " + vectorText(camera.centre, path) +
         ", \"zoom\": " + lengthText(camera.zoom, path) + ", \"perspectiveDeg\": " +
         (camera.perspectiveDeg ? finiteText(*camera.perspectiveDeg, path) : "null") + "}";
}

std::string familyText(const SurfaceFamily& family, const std::string& path) {
  return "{\"name\": " + quoted(family.name, path) + ", \"on\": " + (family.on ? "true" : "false") +
         (family.threshold ? ", \"threshold\": " + lengthText(*family.threshold, path) : "") +
         ", \"colour\": " + quoted(family.colour, path) +
         ", \"widthPx\": " + lengthText(family.widthPx, path) +
         ", \"fade\": " + (family.fade ? "true" : "false") + "}";
}

std::string paneText(const SurfacePane& pane, const std::string& path) {
  std::string families;
  if (pane.families) {
    for (const std::string& name : *pane.families) {
      families += (families.empty() ? "" : ", ") + quoted(name, pathTo(path, "families"));
    }
    families = "[" + families + "]";
  } else {
    families = "null";
  }
  return "{\"families\": " + families + ", \"derivative\": " + quoted(pane.derivative, path) +
         ", \"shows\": " + quoted(pane.shows, path) + ", \"camera\": " +
         (pane.camera ? cameraText(*pane.camera, pathTo(path, "camera")) : "null") + "}";
}

std::string sweptText(const SweptSetting& swept, const std::string& path) {
  return "{\"kind\": " + quoted(swept.kind, path) + ", \"curve\": " + std::to_string(swept.curve) +
         ", \"amount\": " + lengthText(swept.amount, path) +
         ", \"cells\": " + std::to_string(swept.cells) + "}";
}

std::string planeText(const SurfacePlane& plane, const std::string& path) {
  return "{\"point\": " + vectorText(plane.point, path) +
         ", \"normal\": " + vectorText(plane.normal, path) + "}";
}

/// A list with an entry on each line, as the value of a key two levels deep.
template <class Entries, class Text>
std::string listText(const Entries& entries, const Text& textOf) {
  if (entries.empty()) return "[]";
  std::string text = "[";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    text += (i == 0 ? "\n      " : ",\n      ") + textOf(entries[i], i);
  }
  return text + "\n    ]";
}

}  // namespace

SurfaceSetting surfaceFrom(const JsonNode& node) {
  node.allowKeys({"mesh", "camera", "savedCameras", "families", "style", "quantity", "hidden",
                  "unfiltered", "isophotes", "heights", "fitScale", "upAxis", "panes", "ink",
                  "swept", "plane"});
  SurfaceSetting surface;
  surface.mesh = node.at("mesh").text();
  if (surface.mesh.empty()) node.at("mesh").fail("expected a file or solid:NAME");
  if (const auto camera = node.find("camera")) surface.camera = cameraFrom(*camera);
  if (const auto saved = node.find("savedCameras")) {
    const std::size_t count = listSize(*saved, "a list of cameras");
    for (std::size_t i = 0; i < count; ++i) {
      const JsonNode entry = saved->at(i);
      entry.allowKeys({"name", "camera"});
      surface.savedCameras.push_back({entry.at("name").text(), cameraFrom(entry.at("camera"))});
    }
  }
  if (const auto families = node.find("families")) {
    const std::size_t count = listSize(*families, "a list of line families");
    for (std::size_t i = 0; i < count; ++i) {
      SurfaceFamily family = familyFrom(families->at(i));
      for (const SurfaceFamily& before : surface.families) {
        if (before.name == family.name) families->at(i).fail("there is one of this name already");
      }
      surface.families.push_back(std::move(family));
    }
  }
  if (const auto style = node.find("style")) surface.style = oneOf(*style, kSurfaceStyleNames);
  if (const auto quantity = node.find("quantity")) {
    surface.quantity = oneOf(*quantity, kSurfaceQuantityNames);
  }
  if (const auto hidden = node.find("hidden")) surface.hidden = oneOf(*hidden, kHiddenLineNames);
  if (const auto unfiltered = node.find("unfiltered")) surface.unfiltered = unfiltered->boolean();
  if (const auto count = node.find("isophotes")) surface.isophotes = levels(*count);
  if (const auto count = node.find("heights")) surface.heights = levels(*count);
  if (const auto scale = node.find("fitScale")) surface.fitScale = positive(*scale, 1.0);
  if (const auto axis = node.find("upAxis")) surface.upAxis = oneOf(*axis, kUpAxes);
  if (const auto panes = node.find("panes")) {
    const std::size_t count = panes->listSize("a list of views");
    if (count > kMostPanes) panes->fail("more than " + std::to_string(kMostPanes) + " views");
    for (std::size_t i = 0; i < count; ++i) surface.panes.push_back(paneFrom(panes->at(i)));
  }
  if (const auto ink = node.find("ink")) {
    surface.ink = positive(*ink);
    if (*surface.ink > 1.0) ink->fail("expected a share of at most 1");
  }
  if (const auto swept = node.find("swept")) surface.swept = sweptFrom(*swept);
  if ((surface.mesh == kSweptMesh) != surface.swept.has_value()) {
    node.fail("\"mesh\": \"swept:\" and \"swept\" belong together");
  }
  if (const auto plane = node.find("plane")) surface.plane = planeFrom(*plane);
  return surface;
}

bool needsVersion4(const SurfaceSetting& surface) {
  return surface.upAxis != SurfaceSetting{}.upAxis || !surface.panes.empty() || surface.ink ||
         surface.swept || surface.plane;
}

std::string surfaceText(const SurfaceSetting& surface, const std::string& path) {
  const std::string cameras = pathTo(path, "savedCameras"), families = pathTo(path, "families");
  std::string text = "{\n    \"mesh\": " + quoted(surface.mesh, pathTo(path, "mesh")) +
                     ",\n    \"camera\": " + cameraText(surface.camera, pathTo(path, "camera")) +
                     ",\n    \"savedCameras\": " +
                     listText(surface.savedCameras,
                              [&](const SavedCamera& saved, std::size_t i) {
                                const std::string place = pathTo(cameras, i);
                                return "{\"name\": " + quoted(saved.name, place) +
                                       ", \"camera\": " + cameraText(saved.camera, place) + "}";
                              }) +
                     ",\n    \"families\": " +
                     listText(surface.families,
                              [&](const SurfaceFamily& family, std::size_t i) {
                                return familyText(family, pathTo(families, i));
                              }) +
                     ",\n    \"style\": " + quoted(surface.style, path) +
                     ",\n    \"quantity\": " + quoted(surface.quantity, path) +
                     ",\n    \"hidden\": " + quoted(surface.hidden, path) +
                     ",\n    \"unfiltered\": " + (surface.unfiltered ? "true" : "false") +
                     ",\n    \"isophotes\": " + std::to_string(surface.isophotes) +
                     ",\n    \"heights\": " + std::to_string(surface.heights) +
                     ",\n    \"fitScale\": " + lengthText(surface.fitScale, path);
  if (surface.upAxis != SurfaceSetting{}.upAxis) {
    text += ",\n    \"upAxis\": " + quoted(surface.upAxis, path);
  }
  if (!surface.panes.empty()) {
    const std::string panes = pathTo(path, "panes");
    text +=
        ",\n    \"panes\": " + listText(surface.panes, [&](const SurfacePane& pane, std::size_t i) {
          return paneText(pane, pathTo(panes, i));
        });
  }
  if (surface.ink) text += ",\n    \"ink\": " + finiteText(*surface.ink, path);
  if (surface.swept) text += ",\n    \"swept\": " + sweptText(*surface.swept, path);
  if (surface.plane) text += ",\n    \"plane\": " + planeText(*surface.plane, path);
  return text + "\n  }";
}

}  // namespace flatland
