// SPDX-License-Identifier: MIT
#include "flatland/io/svg_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <unordered_map>

#include "flatland/io/comfortable.h"
#include "flatland/io/input_error.h"
#include "flatland/io/left_out.h"
#include "flatland/io/read_text.h"
#include "flatland/io/scene_json.h"
#include "flatland/io/svg_attributes.h"
#include "flatland/io/svg_style.h"

namespace flatland {

namespace {

const Vec2 kDefaultViewport(300.0, 150.0);  // of a drawing that says nothing (CSS)

/// The name without the prefix of SVG itself; names of other vocabularies keep theirs.
std::string_view nameOf(const pugi::xml_node& node) {
  std::string_view name = node.name();
  if (name.substr(0, 4) == "svg:") name.remove_prefix(4);
  return name;
}

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\f";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// A property from the attribute `style`, else as a style sheet has it, else from the attribute of
/// its own name; "" if nothing says it.
std::string_view property(const pugi::xml_node& node, const char* name,
                          std::string_view bySheet = {}) {
  const std::string_view own = svgDeclared(node.attribute("style").value(), name);
  if (!own.empty()) return own;
  return bySheet.empty() ? trimmed(node.attribute(name).value()) : bySheet;
}

/// What an element inherits.
struct State {
  Eigen::Affine2d toPage = Eigen::Affine2d::Identity();
  Vec2 viewport = kDefaultViewport;
  bool filled = true;
  bool stroked = false;
  bool visible = true;
  int depth = 0;
  int uses = 0;
};

class SvgReader {
 public:
  SvgReader(const std::string& text, const std::string& source) : text_(text), source_(source) {}

  ImportedScene read(const SvgOptions& options) {
    const pugi::xml_node root = parse();
    index(root);
    State state;
    state.viewport = sizeOf(root, kDefaultViewport);
    pageHeight_ = state.viewport.y();
    enter(root, state);
    return finished(options);
  }

 private:
  pugi::xml_node parse() {
    if (text_.size() > kLargestSvgBytes) {
      throw InputError(source_, "", "larger than 16 MiB, too large for a drawing");
    }
    if (text_.substr(0, 2) == "\x1f\x8b") {
      throw InputError(source_, "", "is compressed; unpack it first (gunzip -c x.svgz > x.svg)");
    }
    // Entities of the file itself are not expanded, so none can grow.
    const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size());
    if (!result) {
      throw InputError(source_, "line " + std::to_string(lineAt(result.offset)),
                       "is not well-formed XML: " + std::string(result.description()));
    }
    const pugi::xml_node root = document_.document_element();
    if (nameOf(root) != "svg") {
      throw InputError(source_, "",
                       "is not SVG: its outermost element is <" + std::string(root.name()) + ">");
    }
    return root;
  }

  std::size_t lineAt(std::ptrdiff_t offset) const {
    const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(
                                         offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), end, '\n'));
  }

  /// One pass over everything, without recursion: ids, and what is there but cannot be read.
  void index(const pugi::xml_node& root) {
    for (pugi::xml_node node = root; node;) {
      if (node.type() == pugi::node_element) {
        const std::string_view id = node.attribute("id").value();
        if (!id.empty()) ids_.emplace(id, node);
        const std::string_view name = nameOf(node);
        if (isOneOf(name, {"linearGradient", "radialGradient", "meshgradient"})) {
          leftOut_.count("gradient");
        }
        if (name == "style") {
          for (const pugi::xml_node& text : node.children()) sheet_.add(text.value());
        }
        if (isOneOf(name, {"pattern", "filter"})) leftOut_.count(std::string(name));
      }
      if (node.first_child()) {
        node = node.first_child();
        continue;
      }
      while (node && node != root && !node.next_sibling()) node = node.parent();
      node = node && node != root ? node.next_sibling() : pugi::xml_node();
    }
    leftOut_.count("style rule", sheet_.passedOver());
  }

  std::string describe(const pugi::xml_node& node) const {
    const std::string_view id = node.attribute("id").value();
    std::string text = "line " + std::to_string(lineAt(node.offset_debug())) + ", <" + node.name();
    if (!id.empty()) text += " id=\"" + std::string(id.substr(0, 60)) + "\"";
    return text + ">";
  }
  SvgPlace placeOf(const pugi::xml_node& node, const char* attribute) const {
    return {source_, describe(node) + ", " + attribute};
  }
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& reason) const {
    throw InputError(source_, describe(node), reason);
  }

  std::optional<double> length(const pugi::xml_node& node, const char* name, double whole) const {
    const std::string_view text = trimmed(node.attribute(name).value());
    if (text.empty() || text == "auto") return std::nullopt;
    return svgLength(text, whole, placeOf(node, name));
  }
  Vec2 lengths(const pugi::xml_node& node, const char* x, const char* y, const State& state) const {
    return {length(node, x, state.viewport.x()).value_or(0.0),
            length(node, y, state.viewport.y()).value_or(0.0)};
  }
  /// A size, which must not be negative.
  double extent(const pugi::xml_node& node, const char* name, double whole, double absent) const {
    const double value = length(node, name, whole).value_or(absent);
    if (value < 0.0) fail(node, std::string(name) + " is negative");
    return value;
  }

  std::optional<SvgViewBox> viewBoxOf(const pugi::xml_node& node) const {
    const char* text = node.attribute("viewBox").value();
    return *text ? svgViewBox(text, placeOf(node, "viewBox")) : std::nullopt;
  }

  /// Width and height of an <svg> or <symbol>; where one is missing, the view box says.
  Vec2 sizeOf(const pugi::xml_node& node, const Vec2& outer) const {
    const auto box = viewBoxOf(node);
    const Vec2 absent = box ? box->size : outer;
    return {extent(node, "width", outer.x(), absent.x()),
            extent(node, "height", outer.y(), absent.y())};
  }

  /// The content of an <svg> or <symbol>, fitted into a viewport of `state.viewport`.
  void enter(const pugi::xml_node& node, State state) {
    if (const auto box = viewBoxOf(node)) {
      state.toPage = state.toPage * fitViewBox(*box, state.viewport,
                                               node.attribute("preserveAspectRatio").value());
      state.viewport = box->size;
    }
    if (inherit(node, state)) walkChildren(node, state);
  }

  /// Takes over the element's own properties; false if it is not drawn at all.
  bool inherit(const pugi::xml_node& node, State& state) {
    const SvgDrawn sheet =
        sheet_.of({nameOf(node), node.attribute("id").value(), node.attribute("class").value()});
    if (property(node, "display", sheet.display) == "none") {
      leftOut_.count("hidden element");
      return false;
    }
    const std::string_view visibility = property(node, "visibility", sheet.visibility);
    if (!visibility.empty() && visibility != "inherit") state.visible = visibility == "visible";
    const std::string_view fill = property(node, "fill", sheet.fill);
    const std::string_view stroke = property(node, "stroke", sheet.stroke);
    // A rule that was passed over may say otherwise.
    const bool unknown = sheet_.passedOver() > 0 && node.attribute("class");
    if (!fill.empty() && fill != "inherit") state.filled = fill != "none";
    if (!stroke.empty() && stroke != "inherit") state.stroked = stroke != "none";
    if (unknown) state.filled = true;
    for (const auto& [name, what] :
         {std::pair("clip-path", "clip path"), std::pair("mask", "mask")}) {
      const std::string_view value = property(node, name);
      if (!value.empty() && value != "none") leftOut_.count(what);
    }
    if (const pugi::xml_attribute transform = node.attribute("transform")) {
      state.toPage = state.toPage * svgTransform(transform.value(), placeOf(node, "transform"));
    }
    return true;
  }

  void walkChildren(const pugi::xml_node& node, const State& state) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) walk(child, state);
    }
  }

  void walk(const pugi::xml_node& node, State state) {
    const std::string_view name = nameOf(node);
    if (++elements_ > kMostSvgElements)
      fail(node, "more elements to draw than " + std::to_string(kMostSvgElements));
    if (name.find(':') != std::string_view::npos) return;  // notes of the program that drew it
    if (++state.depth > kDeepestSvgNesting)
      fail(node, "nested deeper than " + std::to_string(kDeepestSvgNesting));
    if (isOneOf(name, {"text", "image", "foreignObject"})) {
      leftOut_.count(name == "foreignObject" ? "foreign object" : std::string(name));
      return;
    }
    const bool group = isOneOf(name, {"g", "a", "switch"});
    const bool shape =
        isOneOf(name, {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"});
    if (!group && !shape && name != "svg" && name != "use") return;  // definitions, descriptions
    if (name == "svg") {
      const Vec2 corner = lengths(node, "x", "y", state);
      state.toPage = state.toPage * Eigen::Translation2d(corner);
      state.viewport = sizeOf(node, state.viewport);
      enter(node, state);
      return;
    }
    if (!inherit(node, state)) return;
    if (name == "switch") {
      walkSwitch(node, state);
    } else if (group) {
      walkChildren(node, state);
    } else if (name == "use") {
      use(node, state);
    } else {
      addShape(node, name, state);
    }
  }

  /// Draws the first child that asks for nothing special.
  void walkSwitch(const pugi::xml_node& node, const State& state) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element || child.attribute("requiredExtensions") ||
          nameOf(child) == "foreignObject") {
        continue;
      }
      walk(child, state);
      return;
    }
  }

  void use(const pugi::xml_node& node, State state) {
    std::string_view target = node.attribute("href").value();
    if (target.empty()) target = node.attribute("xlink:href").value();
    const auto found = target.substr(0, 1) == "#" ? ids_.find(target.substr(1)) : ids_.end();
    if (found == ids_.end()) {
      leftOut_.count("reference to what is not there");
      return;
    }
    if (++state.uses > kDeepestSvgUse)
      fail(node,
           "refers to itself, or through more than " + std::to_string(kDeepestSvgUse) + " others");
    state.toPage = state.toPage * Eigen::Translation2d(lengths(node, "x", "y", state));
    const pugi::xml_node& there = found->second;
    if (isOneOf(nameOf(there), {"symbol", "svg"})) {
      const Vec2 own = sizeOf(there, state.viewport);
      state.viewport = {extent(node, "width", state.viewport.x(), own.x()),
                        extent(node, "height", state.viewport.y(), own.y())};
      ++elements_;
      if (++state.depth > kDeepestSvgNesting)
        fail(node, "nested deeper than " + std::to_string(kDeepestSvgNesting));
      enter(there, state);
    } else {
      walk(there, state);
    }
  }

  std::vector<Subpath> subpathsOf(const pugi::xml_node& node, std::string_view name,
                                  const State& state) const {
    const Vec2 whole = state.viewport;
    const double diagonal = whole.norm() / std::sqrt(2.0);
    if (name == "path") {
      return subpathsFromSvg(node.attribute("d").value(), source_, placeOf(node, "d").place);
    }
    if (name == "rect") {
      const Vec2 size(extent(node, "width", whole.x(), 0.0),
                      extent(node, "height", whole.y(), 0.0));
      if (size.minCoeff() == 0.0) return {Subpath{}};
      const auto rx = length(node, "rx", whole.x()), ry = length(node, "ry", whole.y());
      const Vec2 radii(rx.value_or(ry.value_or(0.0)), ry.value_or(rx.value_or(0.0)));
      return {svgRectangle(lengths(node, "x", "y", state), size, radii)};
    }
    if (name == "circle" || name == "ellipse") {
      const Vec2 radii = name == "circle" ? Vec2::Constant(extent(node, "r", diagonal, 0.0))
                                          : Vec2(extent(node, "rx", whole.x(), 0.0),
                                                 extent(node, "ry", whole.y(), 0.0));
      if (radii.minCoeff() == 0.0) return {Subpath{}};
      return {svgEllipse(lengths(node, "cx", "cy", state), radii)};
    }
    if (name == "line") {
      return {
          svgPolyline({lengths(node, "x1", "y1", state), lengths(node, "x2", "y2", state)}, false)};
    }
    return {svgPolyline(svgPoints(node.attribute("points").value(), placeOf(node, "points")),
                        name == "polygon")};
  }

  void addShape(const pugi::xml_node& node, std::string_view name, const State& state) {
    if (!state.visible) {
      leftOut_.count("hidden element");
      return;
    }
    if (!state.filled && !state.stroked) {
      leftOut_.count("shape with neither fill nor stroke");
      return;
    }
    std::vector<Subpath> subpaths = subpathsOf(node, name, state);
    for (const Subpath& subpath : subpaths) segments_ += subpath.segments.size();
    if (segments_ > kMostSvgSegments)
      fail(node, "is where the drawing exceeds " + std::to_string(kMostSvgSegments) +
                     " segments, too many");
    for (Subpath& subpath : subpaths) {
      for (PathSegment& segment : subpath.segments) {
        for (Vec2& p : segment.points) {
          p = state.toPage * p;
          p.y() = pageHeight_ - p.y();
          if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kLargestLength) {
            fail(node, "has coordinates beyond 1e50, the largest supported");
          }
        }
      }
      if (auto chain = chainOf(subpath, notes_)) curves_.push_back({std::move(*chain), false});
    }
  }

  ImportedScene finished(const SvgOptions& options) {
    leftOut_.count("subpath without length", notes_.emptySubpaths);
    leftOut_.count("segment of zero length", notes_.zeroLengthSegments);
    ImportedScene result;
    result.leftOut = leftOut_.text();
    if (curves_.empty()) {
      throw InputError(source_, "",
                       "has no curve to show" +
                           (result.leftOut.empty() ? std::string() : "; " + result.leftOut));
    }
    result.scene.curves = std::move(curves_);
    result.done =
        countText("curve", static_cast<int>(result.scene.curves.size())) + ", y turned up";
    if (options.comfortable) result.done += ", " + makeComfortable(result.scene, source_);
    return result;
  }

  const std::string& text_;
  const std::string& source_;
  pugi::xml_document document_;
  std::unordered_map<std::string_view, pugi::xml_node> ids_;
  LeftOut leftOut_;
  ChainNotes notes_;
  std::vector<SceneCurve> curves_;
  double pageHeight_ = 0.0;
  SvgStyleSheet sheet_;
  int elements_ = 0;
  std::size_t segments_ = 0;
};

}  // namespace

std::string ImportedScene::note() const { return leftOut.empty() ? done : done + "; " + leftOut; }

ImportedScene sceneFromSvg(const std::string& text, const std::string& source,
                           const SvgOptions& options) {
  return SvgReader(text, source).read(options);
}

ImportedScene loadSvg(const std::filesystem::path& file, const SvgOptions& options) {
  return sceneFromSvg(readFile(file, kLargestSvgBytes), file.string(), options);
}

bool isSvgName(const std::string& name) {
  if (name.size() < 4) return false;
  std::string end = name.substr(name.size() - 4);
  for (char& c : end) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return end == ".svg";
}

}  // namespace flatland
