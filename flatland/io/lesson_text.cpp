// SPDX-License-Identifier: MIT
#include "flatland/io/lesson_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "flatland/features/features.h"
#include "flatland/io/json_text.h"
#include "flatland/io/read_text.h"
#include "flatland/io/scene_json.h"
#include "flatland/io/utf8.h"

namespace flatland {

namespace {

using nlohmann::json;

/// Runs of lines with their numbers from 1; no '\r' at their ends.
struct Line {
  std::string text;
  std::size_t number;
};

std::vector<Line> linesOf(const std::string& text) {
  std::vector<Line> lines;
  std::size_t start = text.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0;
  while (start < text.size()) {
    std::size_t end = text.find('\n', start);
    if (end == std::string::npos) end = text.size();
    std::string line = text.substr(start, end - start);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back({std::move(line), lines.size() + 1});
    start = end + 1;
  }
  return lines;
}

std::string trimmed(const std::string& text) {
  const char* const kBlank = " \t\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool isBlank(const std::string& text) { return trimmed(text).empty(); }

/// Where a block stands in the file: its fence, and the keys of its object.
class BlockPlace {
 public:
  /// `body` is valid JSON on the lines that it has in the file.
  BlockPlace(std::size_t fence, const std::string& body) : fence_(fence) {
    std::size_t line = 1;
    int depth = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
      const char c = body[i];
      if (c == '\n') ++line;
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      if (c != '"') continue;
      const std::size_t open = i;
      for (++i; body[i] != '"'; ++i) {
        if (body[i] == '\\') ++i;
      }
      const std::size_t next = body.find_first_not_of(" \t\r\n", i + 1);
      if (depth != 1 || next == std::string::npos || body[next] != ':') continue;
      lines_[json::parse(body.substr(open, i + 1 - open)).get<std::string>()] = line;
    }
  }

  std::string ofBlock() const { return "line " + std::to_string(fence_); }
  std::string of(const std::string& key) const {
    const auto at = lines_.find(key);
    return at == lines_.end() ? ofBlock() : "line " + std::to_string(at->second);
  }

 private:
  std::size_t fence_;
  std::map<std::string, std::size_t> lines_;
};

/// The value of a block under one key, with the place for errors.
class Entry {
 public:
  Entry(const json& value, std::string key, const BlockPlace& place, const std::string& source)
      : value_(value), key_(std::move(key)), place_(place.of(key_)), source_(source) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(source_, place_, "\"" + key_ + "\": " + reason);
  }
  std::string text() const {
    if (!value_.is_string()) fail("expected a text");
    return value_.get<std::string>();
  }
  bool boolean() const {
    if (!value_.is_boolean()) fail("expected true or false");
    return value_.get<bool>();
  }
  double number() const {
    if (!value_.is_number()) fail("expected a number");
    return value_.get<double>();
  }
  const json& value() const { return value_; }

 private:
  const json& value_;
  std::string key_;
  std::string place_;
  const std::string& source_;
};

Scene presetScene(const Entry& entry) {
  const std::string id = entry.text();
  std::string known;
  for (const Preset& preset : presets()) {
    if (preset.id == id) return preset.scene;
    known += (known.empty() ? "" : ", ") + preset.id;
  }
  entry.fail("no such preset; there are " + known);
}

Scene writtenScene(const Entry& entry) {
  try {
    return sceneFromJson(entry.value().dump(), "");
  } catch (const InputError& error) {
    entry.fail(error.place() + ": " + error.reason());
  }
}

std::vector<std::string> familiesFrom(const Entry& entry) {
  if (!entry.value().is_array()) entry.fail("expected a list of kinds of mark");
  std::vector<std::string> families;
  for (const json& name : entry.value()) {
    if (!name.is_string() || !markKindNamed(name.get<std::string>())) {
      entry.fail("no kind of mark: " + name.dump());
    }
    families.push_back(name.get<std::string>());
  }
  return families;
}

/// One of the names that there are of a thing, called `what`.
template <class Names>
std::string nameFrom(const Entry& entry, const Names& names, const std::string& what) {
  const std::string id = entry.text();
  std::string known;
  for (const std::string_view name : names) {
    if (name == id) return id;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  entry.fail("no such " + what + "; there are " + known);
}

void readProbe(const Entry& entry, LessonState& state) {
  const auto whole = [&](const json& value) {
    return value.is_number_unsigned() && value.get<std::size_t>() < 1000000U;
  };
  const json& value = entry.value();
  if (value.is_number()) {
    state.probeT = value.get<double>();
    state.probeCurve = 0;
  } else if (value.is_array() && value.size() == 2 && whole(value[0]) && value[1].is_number()) {
    state.probeCurve = value[0].get<std::size_t>();
    state.probeT = value[1].get<double>();
  } else {
    entry.fail("expected t, or [curve, t]");
  }
}

Eigen::Vector3d cameraFrom(const Entry& entry) {
  const json& value = entry.value();
  Eigen::Vector3d towards = Eigen::Vector3d::Zero();
  bool good = value.is_array() && value.size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) {
    good = value[i].is_number();
    if (good) towards(static_cast<Eigen::Index>(i)) = value[i].get<double>();
  }
  const double length = towards.norm();
  if (!good || !(length > 0.0)) entry.fail("expected a direction [x, y, z]");
  return towards / length;
}

LessonPick pickFrom(const Entry& entry) {
  const json& value = entry.value();
  constexpr std::uint64_t kMost = 0xffffffff;
  for (const bool isTriangle : {false, true}) {
    const char* name = isTriangle ? "triangle" : "vertex";
    if (!value.is_object() || value.size() != 1 || !value.contains(name)) continue;
    const json& number = value[name];
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > kMost) break;
    return {isTriangle, number.get<std::uint32_t>()};
  }
  entry.fail("expected {\"vertex\": N} or {\"triangle\": N}, N from 0");
}

DerivationStep equationFrom(const Entry& entry) {
  const std::string id = entry.text();
  const auto step = derivationStepNamed(id);
  if (step) return *step;
  std::string known;
  for (int i = 0; i < kDerivationStepCount; ++i) {
    known += (i == 0 ? "" : ", ") + std::string(textOf(static_cast<DerivationStep>(i)).id);
  }
  entry.fail("no such equation; there are " + known);
}

/// Puts what a block says over the state of the step before.
void apply(const json& block, const BlockPlace& place, const std::string& source,
           LessonStep& step) {
  if (!block.is_object()) throw InputError(source, place.ofBlock(), "expected an object { ... }");
  if (block.contains("scene") && block.contains("preset")) {
    throw InputError(source, place.ofBlock(),
                     "the block has both \"scene\" and \"preset\"; give one");
  }
  LessonState& state = step.state;
  for (const char* key : {"preset", "scene", "viewAngleDeg", "probe", "camera", "pick"}) {
    step.setsPlace = step.setsPlace || block.contains(key);
  }
  for (const auto& [key, value] : block.items()) {
    const Entry entry(value, key, place, source);
    if (key == "preset" || key == "scene") {
      state.scene = key == "preset" ? presetScene(entry) : writtenScene(entry);
      if (!block.contains("viewAngleDeg")) state.viewAngleDeg.reset();
      if (!block.contains("probe")) state.probeT.reset();
      if (!block.contains("camera")) state.camera.reset();
      if (!block.contains("pick")) state.pick.reset();
      if (!block.contains("surfaceEquation")) state.surfaceEquation.clear();
    } else if (key == "viewAngleDeg") {
      state.viewAngleDeg = entry.number();
    } else if (key == "probe") {
      readProbe(entry, state);
    } else if (key == "camera") {
      state.camera = cameraFrom(entry);
    } else if (key == "pick") {
      state.pick = pickFrom(entry);
    } else if (key == "families") {
      state.families = familiesFrom(entry);
    } else if (key == "equation") {
      state.equation.reset();
      if (!value.is_null()) state.equation = equationFrom(entry);
      if (!block.contains("printed")) state.printed = false;
    } else if (key == "printed") {
      state.printed = entry.boolean();
    } else if (key == "printedRoots") {
      state.printedRoots = entry.boolean();
    } else if (key == "panel") {
      state.panel = nameFrom(entry, kLessonPanels, "panel");
    } else if (key == "surfaceEquation") {
      state.surfaceEquation.clear();
      if (!value.is_null()) {
        state.surfaceEquation = nameFrom(entry, kSurfaceEquations, "equation of a surface");
      }
    } else if (key == "stop") {
      step.stop = entry.boolean();
    } else {
      entry.fail(
          "unknown key; known are preset, scene, viewAngleDeg, probe, camera, pick, families, "
          "equation, printed, printedRoots, surfaceEquation, panel, stop");
    }
  }
  const bool needsSurface = block.contains("camera") || block.contains("pick");
  if (needsSurface && !(state.scene && state.scene->surface)) {
    throw InputError(source, place.of(block.contains("camera") ? "camera" : "pick"),
                     "\"camera\" and \"pick\" are for a scene of the lesson with a surface");
  }
  if (state.printed && !(state.equation && textOf(*state.equation).isMisprinted())) {
    throw InputError(source, place.of("printed"),
                     "\"printed\" is for an equation the thesis misprints: 3.10 to 3.13, "
                     "footnote, 4.7, 4.8");
  }
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& source)
      : lines_(linesOf(text)), source_(source) {}

  Lesson read() {
    for (; at_ < lines_.size(); ++at_) {
      const Line& line = lines_[at_];
      if (line.text.rfind("```", 0) == 0) {
        readFence();
      } else if (line.text.rfind("## ", 0) == 0) {
        beginStep(line);
      } else if (line.text.rfind("# ", 0) == 0) {
        if (!lesson_.title.empty()) fail(line, "a second title; steps begin with \"## \"");
        lesson_.title = trimmed(line.text.substr(2));
      } else if (lesson_.steps.empty()) {
        if (!isBlank(line.text)) {
          fail(line, lesson_.title.empty() ? "a lesson begins with its title, \"# ...\""
                                           : "text before the first step, \"## ...\"");
        }
      } else {
        lesson_.steps.back().text += line.text + "\n";
      }
    }
    finishStep();
    if (lesson_.title.empty()) throw InputError(source_, "", "no title, \"# ...\"");
    if (lesson_.steps.empty()) throw InputError(source_, "", "no step, \"## ...\"");
    return std::move(lesson_);
  }

 private:
  [[noreturn]] void fail(const Line& line, const std::string& reason) const {
    throw InputError(source_, "line " + std::to_string(line.number), reason);
  }

  void beginStep(const Line& line) {
    if (lesson_.title.empty()) fail(line, "a lesson begins with its title, \"# ...\"");
    if (lesson_.steps.size() == kMostLessonSteps) {
      fail(line, "more than " + std::to_string(kMostLessonSteps) + " steps");
    }
    finishStep();
    LessonStep step;
    step.title = trimmed(line.text.substr(3));
    if (step.title.empty()) fail(line, "a step without a title");
    if (!lesson_.steps.empty()) step.state = lesson_.steps.back().state;
    lesson_.steps.push_back(std::move(step));
    hasBlock_ = false;
  }

  void finishStep() {
    if (!lesson_.steps.empty()) lesson_.steps.back().text = trimmed(lesson_.steps.back().text);
  }

  void readFence() {
    const Line& open = lines_[at_];
    const bool ours = trimmed(open.text.substr(3)) == "flatland";
    if (ours && lesson_.steps.empty()) fail(open, "a block before the first step");
    if (ours && hasBlock_) fail(open, "a second block in one step");
    // Lines before stand as empty ones, so that the place in an error is that in the file.
    std::string body(ours ? open.number : 0, '\n');
    const std::size_t first = at_;
    for (++at_; at_ < lines_.size() && trimmed(lines_[at_].text) != "```"; ++at_) {
      body += lines_[at_].text + "\n";
    }
    if (at_ == lines_.size()) fail(lines_[first], "the block is not closed by ```");
    if (!ours) {
      if (lesson_.steps.empty()) fail(open, "text before the first step, \"## ...\"");
      lesson_.steps.back().text += open.text + "\n" + body + "```\n";
      return;
    }
    hasBlock_ = true;
    if (isBlank(body)) fail(open, "the block is empty");
    const json block = parseJson(body, source_);
    apply(block, BlockPlace(open.number, body), source_, lesson_.steps.back());
  }

  std::vector<Line> lines_;
  const std::string& source_;
  std::size_t at_ = 0;
  Lesson lesson_;
  bool hasBlock_ = false;
};

}  // namespace

Lesson lessonFromText(const std::string& text, const std::string& source) {
  if (text.size() > kLargestLessonBytes) {
    throw InputError(source, "", "larger than 1 MiB, too large for a lesson");
  }
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8Length(std::string_view(text).substr(i));
    if (length == 0) {
      const auto line =
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n');
      throw InputError(source, "line " + std::to_string(line), "not UTF-8 text");
    }
    i += length;
  }
  return Reader(text, source).read();
}

Lesson loadLesson(const std::filesystem::path& file) {
  return lessonFromText(readFile(file, kLargestLessonBytes), file.string());
}

}  // namespace flatland
