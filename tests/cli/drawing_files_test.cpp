// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of meshes, lists of cameras and fields as files.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core3d/io/cameras_json.h"
#include "core3d/io/drawing_json.h"
#include "core3d/io/fields_text.h"
#include "core3d/io/read_mesh.h"
#include "core3d/mesh/solids.h"
#include "flatland/io/input_error.h"
#include "flatland/io/scene_json.h"
#include "tests/support/xml_check.h"
#include "ui/export/drawing_figure.h"
#include "ui/export/figure_writers.h"
#include "ui/export/scene_record.h"

namespace flatland::ui {
namespace {

using nlohmann::json;
using test::XmlElement;

constexpr double kSvgRounding = 0.00051;  // three decimals

/// Far from the origin and small, so that a mix-up of coordinates shows.
TriangleMesh placedMesh() {
  TriangleMesh mesh;
  mesh.origin = {1e6, -2.0, 0.5};
  mesh.unit = 0.25;
  return mesh;
}

/// Three families, hidden and closed strokes, levels.
Drawing handMade() {
  Drawing drawing;
  drawing.projection.width = 200;
  drawing.projection.height = 100;
  drawing.polylines = {
      {.family = LineFamily::OccludingContours,
       .closed = true,
       .points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
       .screen = {{10, 90}, {60.12345, 90}, {60, 40}},
       .strength = {0, 0, 0}},
      {.family = LineFamily::ApparentRidges,
       .points = {{-1, 0, 0.5f}, {0, 0.25f, 0.5f}},
       .screen = {{100, 50}, {180, 50}},
       .strength = {2.0f, 2.0f}},
      {.family = LineFamily::ApparentRidges,
       .visible = false,
       .points = {{0, 0, 1}, {0, 1, 1}, {0, 1, 0}},
       .screen = {{20, 20}, {30, 20}, {30, 30}},
       .strength = {9, 9, 9}},
      {.family = LineFamily::Isophotes,
       .level = 4,
       .points = {{0, 0, 0}, {0, 0, 1}},
       .screen = {{5, 5}, {6, 6}},
       .strength = {1, 1}},
  };
  return drawing;
}

TEST(DrawingJson, HasEveryStrokeInTheCoordinatesOfTheFile) {
  const TriangleMesh mesh = placedMesh();
  const Drawing drawing = handMade();
  const json read = json::parse(drawingToJson(drawing, mesh, R"({"segments": 7})"));
  EXPECT_EQ(read.size(), 2u);
  EXPECT_EQ(read["stats"]["segments"], 7);
  ASSERT_EQ(read["polylines"].size(), drawing.polylines.size());
  for (std::size_t i = 0; i < drawing.polylines.size(); ++i) {
    const json& stroke = read["polylines"][i];
    const Polyline& line = drawing.polylines[i];
    EXPECT_EQ(stroke["family"], std::string(nameOf(line.family)));
    EXPECT_EQ(stroke["visible"], line.visible);
    EXPECT_EQ(stroke["closed"], line.closed);
    EXPECT_EQ(stroke.contains("level"), line.family == LineFamily::Isophotes);
    ASSERT_EQ(stroke["points"].size(), line.points.size());
    ASSERT_EQ(stroke["screen"].size(), line.points.size());
    ASSERT_EQ(stroke["strength"].size(), line.points.size());
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      EXPECT_EQ(stroke["points"][k][0], 1e6 + 0.25 * line.points[k].x());
      EXPECT_EQ(stroke["points"][k][1], -2.0 + 0.25 * line.points[k].y());
      EXPECT_EQ(stroke["points"][k][2], 0.5 + 0.25 * line.points[k].z());
      EXPECT_EQ(stroke["screen"][k][0], line.screen[k].x());
      EXPECT_EQ(stroke["screen"][k][1], line.screen[k].y());
      EXPECT_EQ(stroke["strength"][k], line.strength[k]);
    }
  }
}

TEST(DrawingJson, OfNothingIsAnEmptyList) {
  const json read = json::parse(drawingToJson(Drawing{}, placedMesh(), "{}"));
  EXPECT_TRUE(read["polylines"].is_array());
  EXPECT_TRUE(read["polylines"].empty());
}

/// The elements by tag, with the id of the group that each path stands in.
struct SvgPath {
  std::string group, classes;
  std::map<std::string, std::string> attributes;
};
std::vector<SvgPath> pathsOf(const std::string& svg) {
  const test::XmlReading reading = test::readXml(svg);
  EXPECT_EQ(reading.error, std::nullopt);
  std::vector<SvgPath> paths;
  std::string group, classes;
  for (const XmlElement& element : reading.elements) {
    if (element.name == "g") {
      group = element.attributes.at("id");
      classes = element.attributes.at("class");
    }
    if (element.name == "path") paths.push_back({group, classes, element.attributes});
  }
  return paths;
}

std::string svgOf(const DrawingFigureOptions& options) {
  return figureToSvg(drawingFigure(handMade(), options), {.title = "t",
                                                          .program = "p",
                                                          .command = "c",
                                                          .sceneJson = "{\"mesh\": \"a.obj\"}",
                                                          .sceneName = "drawing"});
}

/// The numbers of "M1 2 L3 4 Z".
std::vector<double> numbersOf(std::string path) {
  for (char& c : path) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  std::istringstream in(path);
  std::vector<double> numbers;
  for (double number = 0.0; in >> number;) numbers.push_back(number);
  return numbers;
}

TEST(SceneRecord, NamesAMeshWithoutItsFolder) {
  Scene scene;
  const auto meshOf = [&scene](const char* reference) {
    scene.surface.emplace().mesh = reference;
    return json::parse(sceneRecord(scene))["surface"]["mesh"].get<std::string>();
  };
  EXPECT_EQ(meshOf("/somewhere/scans/bust.obj"), "bust.obj");
  EXPECT_EQ(meshOf("solid:torus:40"), "solid:torus:40");
  scene.surface.reset();
  EXPECT_EQ(sceneRecord(scene), sceneToJson(scene));
}

TEST(DrawingSvg, PaintsHiddenStrokesFirstAndOutlinesLast) {
  Drawing drawing;
  drawing.projection.width = drawing.projection.height = 100;
  for (const LineFamily family : allLineFamilies()) {
    for (const bool visible : {true, false}) {
      drawing.polylines.push_back({.family = family,
                                   .visible = visible,
                                   .points = {{0, 0, 0}, {1, 0, 0}},
                                   .screen = {{10, 10}, {90, 90}},
                                   .strength = {1, 1}});
    }
  }
  const Figure figure = drawingFigure(drawing, {.hidden = DrawingFigureOptions::Hidden::Show});
  ASSERT_EQ(figure.groups.size(), 2 * kLineFamilyCount);
  for (std::size_t i = 0; i < 2 * kLineFamilyCount; ++i) {
    EXPECT_EQ(figure.groups[i].id.ends_with("-hidden"), i < kLineFamilyCount) << i;
  }
  const std::size_t last = figure.groups.size() - 1;
  EXPECT_EQ(figure.groups[last].id, "exterior-silhouette-visible");
  EXPECT_EQ(figure.groups[last - 1].id, "boundaries-visible");
  EXPECT_EQ(figure.groups[last - 2].id, "contours-visible");
}

TEST(DrawingSvg, GroupsByFamilyAndVisibilityWithTheCoordinatesOfTheDrawing) {
  const std::vector<SvgPath> paths = pathsOf(svgOf({.hidden = DrawingFigureOptions::Hidden::Dash}));
  ASSERT_EQ(paths.size(), 4u);
  // Hidden below; contours above all.
  EXPECT_EQ(paths[0].group, "apparent-ridges-hidden");
  EXPECT_EQ(paths[0].classes, "lines apparent-ridges hidden");
  EXPECT_EQ(paths[1].group, "isophotes-visible");
  EXPECT_EQ(paths[2].group, "apparent-ridges-visible");
  EXPECT_EQ(paths[3].group, "contours-visible");
  EXPECT_TRUE(paths[0].attributes.contains("stroke-dasharray"));
  EXPECT_FALSE(paths[2].attributes.contains("stroke-dasharray"));
  EXPECT_EQ(paths[3].attributes.at("d").back(), 'Z');
  EXPECT_NE(paths[2].attributes.at("d").back(), 'Z');
  const Drawing drawing = handMade();
  const std::size_t strokeOf[] = {2, 3, 1, 0};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(paths[i].attributes.at("stroke-linejoin"), "round");
    EXPECT_EQ(paths[i].attributes.at("fill"), "none");
    const std::vector<double> numbers = numbersOf(paths[i].attributes.at("d"));
    const auto& screen = drawing.polylines[strokeOf[i]].screen;
    ASSERT_EQ(numbers.size(), 2 * screen.size());
    for (std::size_t k = 0; k < screen.size(); ++k) {
      EXPECT_NEAR(numbers[2 * k], screen[k].x(), kSvgRounding);
      EXPECT_NEAR(numbers[2 * k + 1], screen[k].y(), kSvgRounding);
    }
  }
}

TEST(DrawingSvg, CarriesItsSourceUnderItsName) {
  const std::string svg = svgOf({});
  const test::XmlReading reading = test::readXml(svg);
  ASSERT_EQ(reading.error, std::nullopt);
  bool found = false;
  for (const XmlElement& element : reading.elements) {
    if (element.name != "drawing") continue;
    found = true;
    EXPECT_EQ(json::parse(element.text)["mesh"], "a.obj");
  }
  EXPECT_TRUE(found);
}

TEST(DrawingSvg, HiddenStrokesAreLeftOutOrLikeTheOthers) {
  for (const SvgPath& path : pathsOf(svgOf({.hidden = DrawingFigureOptions::Hidden::Remove}))) {
    EXPECT_EQ(path.group.find("hidden"), std::string::npos);
  }
  const std::vector<SvgPath> shown = pathsOf(svgOf({.hidden = DrawingFigureOptions::Hidden::Show}));
  ASSERT_EQ(shown.size(), 4u);
  EXPECT_EQ(shown[0].group, "apparent-ridges-hidden");
  EXPECT_EQ(shown[0].attributes.at("stroke"), shown[2].attributes.at("stroke"));
  EXPECT_EQ(shown[0].attributes.at("stroke-width"), shown[2].attributes.at("stroke-width"));
  EXPECT_FALSE(shown[0].attributes.contains("stroke-dasharray"));
}

/// Of the visible apparent ridge, whose strength is 2 throughout.
std::map<std::string, std::string> ridgeWith(DrawingFigureOptions options, double threshold) {
  options.widthPx = 2.0;
  options.threshold[static_cast<std::size_t>(LineFamily::ApparentRidges)] = threshold;
  for (const SvgPath& path : pathsOf(svgOf(options))) {
    if (path.group == "apparent-ridges-visible") return path.attributes;
  }
  ADD_FAILURE() << "no apparent ridge";
  return {};
}

/// Height of the level stroke's outline.
double heightOf(const std::map<std::string, std::string>& path) {
  const std::vector<double> numbers = numbersOf(path.at("d"));
  double low = numbers[1], high = numbers[1];
  for (std::size_t i = 1; i < numbers.size(); i += 2) {
    low = std::min(low, numbers[i]);
    high = std::max(high, numbers[i]);
  }
  return high - low;
}

TEST(DrawingStyle, WidthAndColourFollowStrengthOverThreshold) {
  using Style = DrawingFigureOptions::Style;
  const auto width = [](double threshold) {
    return heightOf(ridgeWith({.style = Style::Width}, threshold));
  };
  EXPECT_EQ(ridgeWith({.style = Style::Width}, 0.0).at("stroke-width"), "2");  // no threshold
  EXPECT_NEAR(width(0.5), 2.0, 2 * kSvgRounding);  // four times the threshold: full
  EXPECT_NEAR(width(2.0), 0.6, 2 * kSvgRounding);  // just reaches it: three tenths
  EXPECT_GT(width(1.0), 0.7);
  EXPECT_LT(width(1.0), 1.9);
  EXPECT_EQ(ridgeWith({.style = Style::Fade}, 0.5).at("stroke"), ridgeWith({}, 0.5).at("stroke"));
  const std::string pale = ridgeWith({.style = Style::Fade}, 2.0).at("stroke");
  EXPECT_GT(std::stoi(pale.substr(1, 2), nullptr, 16), 0xA0);
  EXPECT_EQ(ridgeWith({}, 2.0).at("stroke-width"), "2");
}

TEST(DrawingStyle, TaperedStrokesAreFilledOutlinesWithPointedEnds) {
  const auto path = ridgeWith({.style = DrawingFigureOptions::Style::Taper}, 0.5);
  EXPECT_EQ(path.at("fill"), ridgeWith({}, 0.5).at("stroke"));
  EXPECT_FALSE(path.contains("stroke"));
  EXPECT_NEAR(heightOf(path), 2.0, 2 * kSvgRounding);
  // At the ends, x = 100 and x = 180, both sides meet on the line.
  const std::vector<double> numbers = numbersOf(path.at("d"));
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const double toEnd = std::min(numbers[i] - 100.0, 180.0 - numbers[i]);
    if (toEnd < 0.01) {
      EXPECT_NEAR(numbers[i + 1], 50.0, 0.05);
    }
  }
}

TEST(CamerasJson, ReadsCamerasAndTakesTheRestFromTheUsualOne) {
  const Camera usual{.towards = {1, 0, 0}, .up = {0, 0, 1}, .perspectiveDeg = 30};
  const auto cameras = camerasFromJson(R"({"flatland": 1, "cameras": [
      {"name": "front", "view": [0, 0, 2]}, {"perspectiveDeg": null, "zoom": 1.5}, {"up": [0, -3, 0],
       "perspectiveDeg": 45}]})",
                                       "c.json", usual);
  ASSERT_EQ(cameras.size(), 3u);
  EXPECT_EQ(cameras[0].name, "front");
  EXPECT_EQ(cameras[0].camera.towards, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(cameras[0].camera.up, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(cameras[0].camera.perspectiveDeg, 30.0);
  EXPECT_EQ(cameras[1].name, "");
  EXPECT_EQ(cameras[1].camera.towards, Eigen::Vector3d::UnitX());
  EXPECT_EQ(cameras[1].camera.perspectiveDeg, std::nullopt);
  EXPECT_EQ(cameras[1].camera.zoom, 1.5);
  EXPECT_EQ(cameras[2].camera.up, -Eigen::Vector3d::UnitY());
  EXPECT_EQ(cameras[2].camera.perspectiveDeg, 45.0);
}

TEST(CamerasJson, WritesWhatItReads) {
  Camera camera{.towards = {0, 0.6, 0.8}, .up = {0, 1, 0}, .perspectiveDeg = 25, .zoom = 2};
  const Camera first = camera;
  camera.centre = {0.1, -1.0 / 3.0, 0.25};
  const auto read = camerasFromJson(camerasToJson({{"one", first}, {"", camera}}), "c.json", {});
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].name, "one");
  EXPECT_EQ(read[1].name, "");
  EXPECT_EQ(read[0].camera.centre, std::nullopt);
  EXPECT_EQ(read[1].camera.centre, camera.centre);
  EXPECT_LT((read.at(0).camera.towards - camera.towards).norm(), 1e-15);
  EXPECT_EQ(read.at(0).camera.perspectiveDeg, camera.perspectiveDeg);
  EXPECT_EQ(read.at(0).camera.zoom, camera.zoom);
}

TEST(CamerasJson, TellsWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> wrong[] = {
      {R"({"cameras": []})", "missing \"flatland\""},
      {R"({"flatland": 1})", "missing \"cameras\""},
      {R"({"flatland": 2, "cameras": [{}]})", "flatland: expected version 1"},
      {R"({"flatland": 1, "cameras": []})", "no camera"},
      {R"({"flatland": 1, "cameras": [{"view": [0, 0, 0]}]})", "cameras[0].view: a direction"},
      {R"({"flatland": 1, "cameras": [{"view": [1, 2]}]})", "expected 3 numbers"},
      {R"({"flatland": 1, "cameras": [{}, {"veiw": [1, 2, 3]}]})", "cameras[1]: unknown key"},
      {R"({"flatland": 1, "cameras": [{"perspectiveDeg": 179.5}]})", "from 0.1 to 179"},
      {R"({"flatland": 1, "cameras": [{"perspectiveDeg": 0.05}]})", "from 0.1 to 179"},
      {R"({"flatland": 1, "cameras": [{"zoom": 0}]})", "zoom above 0"},
      {R"({"flatland": 1, "cameras": [{"name": "../x"}]})", "cameras[0].name"},
      {R"({"flatland": 1, "cameras": [{"name": "a"}, {"name": "a"}]})", "stands twice"},
      {R"([1])", "expected an object"},
      {"{", "line 1"},
  };
  for (const auto& [text, reason] : wrong) {
    try {
      camerasFromJson(text, "c.json", {});
      ADD_FAILURE() << text << " was read";
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind("c.json", 0), 0u) << what;
      EXPECT_NE(what.find(reason), std::string::npos) << what;
    }
  }
}

/// A torus in a file of other units, far away, with exact fields.
struct PlacedTorus {
  static constexpr double kScale = 1000.0;
  const Solid solid{.kind = SolidKind::Torus, .a = 1.0, .b = 0.4};
  const Eigen::Vector3d shift{5e4, -7e4, 100.0};
  SolidMesh made = meshOf(solid, {.cells = 12, .irregular = true});
  BuiltMesh built;
  SurfaceFields fields;

  PlacedTorus() {
    for (std::size_t i = 0; i < made.soup.positions.size(); ++i) {
      double& x = made.soup.positions[i];
      x = kScale * x + shift[static_cast<Eigen::Index>(i % 3)];
    }
    built = buildMesh(made.soup);
    const double unit = built.mesh.unit / kScale;
    fields.resize(built.mesh.vertexCount());
    for (std::uint32_t v = 0; v < built.mesh.vertexCount(); ++v) {
      SurfacePoint point = exactAt(v);
      point.K *= unit;
      for (double& c : point.C.coefficients) c *= unit * unit;
      fields.set(v, point);
    }
  }

  SurfacePoint exactAt(std::uint32_t v) const {
    return pointAt(solid, made.places[built.mesh.fileVertex[v]]);
  }
};

std::vector<std::string> columnsOf(const std::string& ply, std::size_t& dataStart) {
  std::vector<std::string> columns;
  std::istringstream in(ply);
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    const std::string property = "property double ";
    if (line.rfind(property, 0) == 0) columns.push_back(line.substr(property.size()));
  }
  dataStart = static_cast<std::size_t>(in.tellg());
  return columns;
}

TEST(FieldsPly, IsReadByOurOwnReader) {
  const PlacedTorus torus;
  const std::string ply = fieldsToPly(torus.built.mesh, torus.fields, {});
  const PolygonSoup soup = readPly(ply, "fields.ply");
  ASSERT_EQ(soup.vertexCount(), torus.built.mesh.vertexCount());
  ASSERT_EQ(soup.polygonCount(), torus.built.mesh.triangleCount());
  for (std::uint32_t v = 0; v < soup.vertexCount(); ++v) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(soup.positions[3 * v + static_cast<std::size_t>(axis)],
                torus.built.mesh.positionInFile(v)[axis]);
    }
  }
  for (std::size_t t = 0; t < soup.polygonCount(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(soup.polygon(t)[k], torus.built.mesh.triangles[t][k]);
    }
  }
}

// Held against the exact torus in the unit of the file, seen by the double template.
TEST(FieldsPly, HasTheValuesInTheUnitOfTheFile) {
  constexpr double kFloats = 2e-4;  // fields are stored in single precision
  const PlacedTorus torus;
  const TriangleMesh& mesh = torus.built.mesh;
  const Eigen::Vector3d w = Eigen::Vector3d(1, 2, 3).normalized();
  // Orthographic, and from a place given in the file.
  const Eigen::Vector3d eye = torus.shift + 4000.0 * w;
  for (const bool perspective : {false, true}) {
    SurfaceView view{.towards = w, .eye = {}};
    if (perspective) view.eye = (eye - mesh.origin) / mesh.unit;
    const std::string ply = fieldsToPly(mesh, torus.fields, view);
    std::size_t at = 0;
    const std::vector<std::string> columns = columnsOf(ply, at);
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      std::map<std::string, double> row;
      for (const std::string& column : columns) {
        std::memcpy(&row[column], ply.data() + at, 8);
        at += 8;
      }
      at += 4;
      SurfacePoint exact = torus.exactAt(v);
      const Eigen::Vector3d p(row["x"], row["y"], row["z"]);
      EXPECT_LT((p - (PlacedTorus::kScale * exact.p + torus.shift)).norm(), 0.01);
      exact.K /= PlacedTorus::kScale;
      for (double& c : exact.C.coefficients) c /= PlacedTorus::kScale * PlacedTorus::kScale;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(exact.K);
      EXPECT_NEAR(row["k1"], eigen.eigenvalues()[1], kFloats * exact.K.norm());
      EXPECT_NEAR(row["k2"], eigen.eigenvalues()[0], kFloats * exact.K.norm());
      const Eigen::Vector3d e1(row["e1x"], row["e1y"], row["e1z"]),
          e2(row["e2x"], row["e2y"], row["e2z"]), n(row["nx"], row["ny"], row["nz"]);
      EXPECT_LT((n - exact.n).norm(), kFloats);
      EXPECT_LT((e1.cross(e2) - n).norm(), kFloats);
      EXPECT_NEAR(std::abs(e1.dot(exact.frame * eigen.eigenvectors().col(1))), 1.0, kFloats);

      const Eigen::Vector3d toEye = perspective ? Eigen::Vector3d(eye - p) : w;
      const Eigen::Vector3d direction = toEye.normalized();
      EXPECT_NEAR(row["nw"], exact.n.dot(direction), kFloats);
      if (std::abs(row["nw"]) < 0.1) continue;  // where everything grows, so do the roundings
      const auto seen = apparentCurvature(
          seenFrom(exact, direction, perspective ? std::optional(toEye.norm()) : std::nullopt));
      ASSERT_TRUE(seen);
      EXPECT_NEAR(row["lambda"], seen->lambda, 20 * kFloats * seen->lambda);
      // r has no sign of its own: the terms turn theirs together.
      const double size = std::abs(seen->feature) + std::abs(seen->offset) +
                          std::abs(seen->perspective) + std::pow(seen->lambda, 1.5);
      const double sign =
          std::abs(row["offset"] - seen->offset) + std::abs(row["feature"] - seen->feature) <=
                  std::abs(row["offset"] + seen->offset) + std::abs(row["feature"] + seen->feature)
              ? 1.0
              : -1.0;
      if (seen->relativeGap < 0.1) continue;  // there the direction is not determined
      EXPECT_NEAR(sign * row["feature"], seen->feature, 100 * kFloats * size);
      EXPECT_NEAR(sign * row["offset"], seen->offset, 100 * kFloats * size);
      EXPECT_NEAR(sign * row["perspective"], seen->perspective, 100 * kFloats * size);
    }
  }
}

TEST(FieldsCsv, HasTheSameColumnsAndEmptyFieldsForWhatDoesNotExist) {
  PlacedTorus torus;
  torus.fields.nx[3] = torus.fields.ny[3] = torus.fields.nz[3] = 0.0f;  // normal unknown
  const std::string csv = fieldsToCsv(torus.built.mesh, torus.fields, {});
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line,
            "x,y,z,nx,ny,nz,k1,k2,e1x,e1y,e1z,e2x,e2y,e2z,c111,c112,c122,c222,nw,lambda,feature,"
            "offset,perspective,file_vertex\r");
  std::size_t rows = 0;
  for (; std::getline(in, line); ++rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 23);
    if (rows == 3) {
      EXPECT_NE(line.find(",0,,,,,"), std::string::npos) << line;
    }
  }
  EXPECT_EQ(rows, torus.built.mesh.vertexCount());
}

}  // namespace
}  // namespace flatland::ui
