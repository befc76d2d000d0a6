// SPDX-License-Identifier: GPL-3.0-or-later
// What scene files say of a surface.
#include "flatland/io/read_text.h"
#include "tests/cli/scene_reading.h"
#include "tests/support/temporary_folder.h"

namespace flatland::test {
namespace {

/// A scene of version 3 whose surface has these keys beside the mesh.
std::string surface(const std::string& keys) {
  return R"({"flatland": 3, "curves": [], "surface": {"mesh": "solid:torus")" + keys + "}}";
}

SurfaceSetting anySurface() {
  SurfaceSetting setting;
  setting.mesh = "solid:torus";
  setting.camera.towards = Eigen::Vector3d(1.0, 2.0, -3.0).normalized();
  setting.camera.up = {0.1, 1.0, 0.0};
  setting.camera.centre = {0.1, -0.2, 1.0 / 3.0};
  setting.camera.zoom = 2.5;
  setting.camera.perspectiveDeg = 40.0;
  setting.savedCameras = {{"Side \"A\"", {}}, {"other", setting.camera}};
  setting.families = {{"apparent-ridges", true, 0.7, "#d55e00", 2.2, false},
                      {"valleys", false, 1.0 / 7.0, "", 1.0, true}};
  setting.style = "colours";
  setting.quantity = "offset";
  setting.hidden = "dashed";
  setting.unfiltered = true;
  setting.isophotes = 7;
  setting.heights = 31;
  setting.fitScale = 1.75;
  return setting;
}

TEST(SurfaceJson, ASurfaceSurvives) {
  Scene scene = read(kSmallScene);
  scene.surface = anySurface();
  const std::string text = sceneToJson(scene);
  EXPECT_NE(text.find("\"flatland\": 3"), std::string::npos) << text;
  EXPECT_EQ(read(text), scene) << text;
  EXPECT_EQ(sceneToJson(read(text)), text);
  scene.surface = SurfaceSetting{};
  scene.surface->mesh = "solid:sphere";
  EXPECT_EQ(read(sceneToJson(scene)), scene);
  EXPECT_EQ(read(surface("")).surface->style, SurfaceSetting{}.style);
}

// What is usual for a family is known above; 0 would be another threshold.
TEST(SurfaceJson, AFamilyNeedNotSayMoreThanItsName) {
  const Scene scene = read(surface(R"(, "families": [{"name": "creases"}])"));
  const SurfaceFamily& family = scene.surface->families.at(0);
  EXPECT_FALSE(family.threshold);
  EXPECT_TRUE(family.on && family.fade && family.colour.empty() && family.widthPx == 1.6);
  EXPECT_EQ(read(sceneToJson(scene)), scene);
  const Scene zero = read(surface(R"(, "families": [{"name": "creases", "threshold": 0}])"));
  EXPECT_EQ(zero.surface->families.at(0).threshold, 0.0);
  EXPECT_EQ(read(sceneToJson(zero)), zero);
}

TEST(SurfaceJson, FurtherViewsSweptSurfaceAndPlaneSurvive) {
  Scene scene = read(kSmallScene);
  scene.surface = anySurface();
  using Names = std::vector<std::string>;
  SurfacePane elsewhere{Names{"valleys", "contours"}, "one-ring", "difference", SurfaceCamera{}};
  elsewhere.camera->zoom = 1.0 / 3.0;
  // No families are something else than those of the first view.
  scene.surface->panes = {elsewhere, {Names{}}, {}};
  scene.surface->upAxis = "-z";
  scene.surface->ink = 0.03;
  scene.surface->mesh = kSweptMesh;
  scene.surface->swept = SweptSetting{"revolution", 3, -0.1, 17};
  scene.surface->plane =
      SurfacePlane{{0.1, 0.2, 0.3}, Eigen::Vector3d(1.0, -2.0, 3.0).normalized()};
  const std::string text = sceneToJson(scene);
  EXPECT_NE(text.find("\"flatland\": 4"), std::string::npos) << text;
  EXPECT_EQ(read(text), scene) << text;
  EXPECT_EQ(sceneToJson(read(text)), text);

  const TemporaryFolder folder;
  saveScene(scene, folder.path() / "scene.json");
  EXPECT_EQ(loadScene(folder.path() / "scene.json"), scene);
}

TEST(SurfaceJson, TheMeshGoesWithTheSceneFile) {
  const TemporaryFolder folder;
  Scene scene = read(kSmallScene);
  scene.surface = SurfaceSetting{};
  scene.surface->mesh = (folder.path() / "meshes" / "cow.obj").string();
  const std::filesystem::path file = folder.path() / "scene.json";
  saveScene(scene, file);
  EXPECT_EQ(read(readFile(file, 1 << 20)).surface->mesh, "meshes/cow.obj");
  EXPECT_EQ(loadScene(file).surface->mesh, scene.surface->mesh);
  scene.surface->mesh = "solid:torus";
  saveScene(scene, file);
  EXPECT_EQ(loadScene(file).surface->mesh, "solid:torus");
}

TEST(SurfaceJson, SaysWhatIsWrongWithASurface) {
  const struct {
    std::string text, place, reason;
  } cases[] = {
      {R"({"flatland": 2, "curves": [], "surface": {"mesh": "a.ply"}})", "surface",
       "came with version 3"},
      {R"({"flatland": 3, "curves": [], "surface": {}})", "surface", "missing \"mesh\""},
      {R"({"flatland": 3, "curves": [], "surface": {"mesh": ""}})", "surface.mesh",
       "expected a file"},
      {surface(R"(, "colour": 1)"), "surface", "unknown key \"colour\""},
      {surface(R"(, "camera": {"zoom": 0})"), "surface.camera.zoom", "above 0"},
      {surface(R"(, "camera": {"towards": [0, 0, 0]})"), "surface.camera.towards", "direction"},
      {surface(R"(, "camera": {"towards": [0, 2, 0]})"), "surface.camera", "lies along"},
      {surface(R"(, "camera": {"towards": [1, 2]})"), "surface.camera.towards", "three numbers"},
      {surface(R"(, "camera": {"perspectiveDeg": 179.5})"), "surface.camera.perspectiveDeg",
       "from 0.1 to 179"},
      {surface(R"(, "camera": {"perspectiveDeg": 0})"), "surface.camera.perspectiveDeg",
       "from 0.1 to 179"},
      {surface(R"(, "families": [{"name": "ridges", "threshold": -1}])"),
       "surface.families[0].threshold", "0 or above"},
      {surface(R"(, "families": [{"name": "ridges"}, {"name": "ridges"}])"), "surface.families[1]",
       "of this name"},
      {surface(R"(, "families": [{"name": "ridges", "colour": "red"}])"),
       "surface.families[0].colour", "a colour like"},
      {surface(R"(, "families": [{"name": "ridges", "widthPx": 0}])"),
       "surface.families[0].widthPx", "above 0"},
      {surface(R"(, "isophotes": 0)"), "surface.isophotes", "1 to 1000"},
      {surface(R"(, "ink": 0.1)"), "surface", "came with version 4"},
      {surface(R"(, "ink": 1.1)"), "surface.ink", "at most 1"},
      {surface(R"(, "families": [{"name": "ridge"}])"), "surface.families[0].name",
       "self-intersections, topographic; found ridge"},
      {surface(R"(, "panes": [{"families": ["ridges", "sulci"]}])"), "surface.panes[0].families[1]",
       "topographic; found sulci"},
      {surface(R"(, "panes": [{"derivative": "two-ring"}])"), "surface.panes[0].derivative",
       "expected one of closed-form, one-ring; found two-ring"},
      {surface(R"(, "panes": [{"shows": "all"}])"), "surface.panes[0].shows",
       "expected one of lines, difference; found all"},
      {surface(R"(, "style": "glass")"), "surface.style", "normals, colours; found glass"},
      {surface(R"(, "quantity": "k3")"), "surface.quantity", "expected one of k1, k2, lambda"},
      {surface(R"(, "hidden": "maybe")"), "surface.hidden",
       "expected one of off, dashed, shown; found maybe"},
      {surface(R"(, "upAxis": "z")"), "surface", "came with version 4"},
      {surface(R"(, "upAxis": "w")"), "surface.upAxis", "one of x, -x, y, -y, z, -z; found w"},
      {surface(R"(, "panes": [{}, {}, {}, {}])"), "surface.panes", "more than 3"},
      {surface(R"(, "plane": {"point": [0, 0, 0], "normal": [0, 0, 0]})"), "surface.plane.normal",
       "a direction"},
      {surface(R"(, "swept": {"kind": "extrusion", "amount": 1})"), "surface", "belong together"},
      {surface(R"(, "swept": {"kind": "loft", "amount": 1})"), "surface.swept.kind",
       "one of extrusion, revolution; found loft"},
      {surface(R"(, "swept": {"kind": "extrusion", "amount": 0})"), "surface.swept.amount",
       "above 0"},
      {surface(R"(, "swept": {"kind": "extrusion", "amount": 1, "cells": 2})"),
       "surface.swept.cells", "3 to 1000"},
      {surface(R"(, "fitScale": 0.5)"), "surface.fitScale", "at least 1"},
  };
  for (const auto& one : cases) expectRefused(one.text, one.place, one.reason);
}

}  // namespace
}  // namespace flatland::test
