// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons: what is read, what is refused and where.
#include "flatland/io/lesson_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace flatland {
namespace {

std::string block(const std::string& json) { return "```flatland\n" + json + "\n```\n"; }

std::string refusal(const std::string& text) {
  try {
    lessonFromText(text, "l.md");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(LessonText, StepsKeepWhatTheyDoNotName) {
  const Lesson lesson = lessonFromText(
      "# A lesson\n\n## One\n\nSome *words*.\n\n" +
          block(R"({"preset": "bump", "viewAngleDeg": 30, "probe": 0.25, "equation": "3.10",
                    "printed": true, "families": ["ridge"], "stop": true})") +
          "\n## Two\n\nMore.\n\n## Three\n" + block(R"({"equation": "3.13", "probe": [0, 0.5]})") +
          "\n## Four\n" + block(R"({"preset": "loop"})"),
      "l.md");
  EXPECT_EQ(lesson.title, "A lesson");
  ASSERT_EQ(lesson.steps.size(), 4u);
  EXPECT_EQ(lesson.steps[0].text, "Some *words*.");
  EXPECT_TRUE(lesson.steps[0].stop);
  EXPECT_FALSE(lesson.steps[1].stop);
  EXPECT_EQ(lesson.steps[1].state.viewAngleDeg, 30.0);
  EXPECT_EQ(lesson.steps[1].state.probeT, 0.25);
  EXPECT_TRUE(lesson.steps[1].state.printed);
  EXPECT_EQ(lesson.steps[1].state.equation, DerivationStep::Eq3_10);
  EXPECT_EQ(*lesson.steps[1].state.families, std::vector<std::string>{"ridge"});
  // Another equation begins as corrected; another scene with its own view and no probe.
  EXPECT_FALSE(lesson.steps[2].state.printed);
  EXPECT_EQ(lesson.steps[2].state.probeT, 0.5);
  EXPECT_FALSE(lesson.steps[3].state.viewAngleDeg);
  EXPECT_FALSE(lesson.steps[3].state.probeT);
}

TEST(LessonText, NoFamiliesIsNotTheSameAsNotNamingThem) {
  const Lesson lesson =
      lessonFromText("# A\n## B\ntext\n## C\n" + block(R"({"families": []})"), "l.md");
  EXPECT_FALSE(lesson.steps[0].state.families);
  ASSERT_TRUE(lesson.steps[1].state.families);
  EXPECT_TRUE(lesson.steps[1].state.families->empty());
}

TEST(LessonText, OtherBlocksAreText) {
  const Lesson lesson = lessonFromText("# A\n## B\n```\ncode\n## no step\n```\nend\n", "l.md");
  ASSERT_EQ(lesson.steps.size(), 1u);
  EXPECT_EQ(lesson.steps[0].text, "```\ncode\n## no step\n```\nend");
}

TEST(LessonText, ASceneCanBeWrittenOut) {
  const Lesson lesson = lessonFromText(
      "# A\n## B\n" +
          block(R"({"scene": {"flatland": 1, "curves": [{"bezier": [[0, 0], [1, 2], [2, 0]]}]}})"),
      "l.md");
  EXPECT_EQ(lesson.steps[0].state.scene->curves.size(), 1u);
}

TEST(LessonText, ASurfaceIsSeenFromACameraAndPicked) {
  const std::string scene =
      R"("scene": {"flatland": 3, "curves": [{"bezier": [[0, 0], [1, 2], [2, 0]]}],
                   "surface": {"mesh": "solid:torus:40"}})";
  const Lesson lesson = lessonFromText(
      "# A\n## B\n" + block("{" + scene + R"(, "camera": [0, 0, 2], "pick": {"vertex": 7},
                                            "panel": "surface-derivation"})") +
          "## C\ntext\n## D\n" + block(R"({"pick": {"triangle": 9}, "panel": "triangle"})") +
          "## E\n" + block("{" + scene + "}"),
      "l.md");
  const LessonState& first = lesson.steps[0].state;
  ASSERT_TRUE(first.camera && first.pick);
  EXPECT_EQ(*first.camera, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(*first.pick, (LessonPick{false, 7}));
  EXPECT_EQ(lesson.steps[1].state.pick, first.pick);
  EXPECT_FALSE(lesson.steps[1].setsPlace);
  EXPECT_EQ(*lesson.steps[2].state.pick, (LessonPick{true, 9}));
  EXPECT_TRUE(lesson.steps[2].setsPlace);
  EXPECT_TRUE(lesson.steps[2].state.camera);
  EXPECT_FALSE(lesson.steps[3].state.camera || lesson.steps[3].state.pick);
  EXPECT_NE(refusal("# A\n## B\n" + block(R"({"preset": "bump", "pick": {"vertex": 7}})"))
                .find("line 4: \"camera\" and \"pick\" are for"),
            std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block("{" + scene + ",\n\"camera\": [0, 0, 0]}"))
                .find("\"camera\": expected a direction"),
            std::string::npos);
  for (const char* pick : {R"({"vertex": -1})", R"({"edge": 1})", R"({"vertex": 1, "triangle": 2})",
                           "7", R"({"triangle": 4294967296})"}) {
    EXPECT_NE(refusal("# A\n## B\n" + block("{" + scene + ", \"pick\": " + pick + "}"))
                  .find("\"pick\": expected {"),
              std::string::npos)
        << pick;
  }
}

TEST(LessonText, RefusesWithLineAndReason) {
  EXPECT_EQ(refusal(""), "l.md: no title, \"# ...\"");
  EXPECT_EQ(refusal("# A\n"), "l.md: no step, \"## ...\"");
  EXPECT_EQ(refusal("\nwords\n"), "l.md: line 2: a lesson begins with its title, \"# ...\"");
  EXPECT_EQ(refusal("# A\n# B\n"), "l.md: line 2: a second title; steps begin with \"## \"");
  EXPECT_EQ(refusal("# A\n## B\n\n```flatland\n{}\n"),
            "l.md: line 4: the block is not closed by ```");
  EXPECT_NE(refusal("# A\n## B\n" + block(R"({"preset": "bmup"})"))
                .find("line 4: \"preset\": no such preset; there are thesis"),
            std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block(R"({"veiw": 3})")).find("line 4: \"veiw\": unknown key"),
            std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block("{\"probe\": 1,\n \"stop\": }")).find("line 5, column"),
            std::string::npos)
      << "the line is that of the file";
  EXPECT_NE(
      refusal("# A\n## B\n" + block(R"({"equation": "3.5", "printed": true})")).find("misprints"),
      std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block("{}") + block("{}")).find("line 6: a second block"),
            std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block(R"({"panel": "sweeep"})"))
                .find("line 4: \"panel\": no such panel; there are view, "),
            std::string::npos);
  // The line of the key, whatever looks like it before.
  EXPECT_NE(refusal("# A\n## B\n" + block("{\"families\": [\"ridge\"],\n \"panel\": \"view\",\n\n"
                                          " \"pr\\u006fbe\" :\n \"probe\", \"stop\": true}"))
                .find("line 7: \"probe\": expected t"),
            std::string::npos);
  EXPECT_NE(
      refusal("# A\n## B\n" +
              block("{\"scene\": {\n\"flatland\": 1,\n \"curves\": [], \"view\": \"\\\":{\"},\n"
                    "\"stop\": 1}"))
          .find("line 4: \"scene\": "),
      std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block("{\"panel\": \"view\",\n\"stop\": 1}"))
                .find("line 5: \"stop\": expected true or false"),
            std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n" + block("{\"equation\": \"3.5\",\n\n\"printed\": true}"))
                .find("line 6: \"printed\" is for"),
            std::string::npos);
  EXPECT_NE(refusal("# A\n## B\n\xFF\n").find("line 3: not UTF-8"), std::string::npos);
  EXPECT_NE(refusal(std::string(kLargestLessonBytes + 1, 'x')).find("too large"),
            std::string::npos);
}

// The example of docs/user/lesson-format.md, and the lessons that come with the program.
TEST(LessonText, TheDocumentedExampleAndTheShippedLessonsAreRead) {
  const std::string root = FLATLAND_SOURCES;
  std::ifstream page(root + "/docs/user/lesson-format.md");
  const std::string text{std::istreambuf_iterator<char>(page), std::istreambuf_iterator<char>()};
  const std::string begin = "````markdown\n";
  const std::size_t from = text.find(begin);
  ASSERT_NE(from, std::string::npos);
  const std::size_t start = from + begin.size();
  const Lesson example = lessonFromText(text.substr(start, text.find("````\n", start) - start), "");
  EXPECT_EQ(example.steps.size(), 2u);
  for (const char* name : {"silhouette", "apparent-ridge", "offset", "surface"}) {
    const Lesson lesson = loadLesson(root + "/ui/lesson/lessons/" + name + ".md");
    EXPECT_GE(lesson.steps.size(), 5u) << name;
    for (const LessonStep& step : lesson.steps) EXPECT_FALSE(step.text.empty()) << step.title;
  }
  EXPECT_THROW(loadLesson(root + "/nowhere.md"), InputError);
}

/// The blocks between ```flatland and ```, one after the other.
std::string blocksOf(const std::string& file) {
  std::ifstream in(file);
  std::string blocks;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("```", 0) == 0) inside = line == "```flatland";
    if (inside) blocks += line + '\n';
  }
  return blocks;
}

// A translation has other words and nothing else: step for step it shows the same.
TEST(LessonText, TheGermanLessonsShowWhatTheEnglishOnesShow) {
  const std::string folder = std::string(FLATLAND_SOURCES) + "/ui/lesson/lessons/";
  int lessons = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".md") continue;
    ++lessons;
    const std::string translated = folder + "de/" + entry.path().filename().string();
    const Lesson english = loadLesson(entry.path());
    const Lesson german = loadLesson(translated);
    EXPECT_NE(german.title, english.title);
    ASSERT_EQ(german.steps.size(), english.steps.size()) << translated;
    for (std::size_t i = 0; i < german.steps.size(); ++i) {
      const LessonStep& step = german.steps[i];
      EXPECT_FALSE(step.text.empty()) << step.title;
      EXPECT_NE(step.title, english.steps[i].title);
      EXPECT_NE(step.text, english.steps[i].text) << step.title;
      EXPECT_EQ(step.stop, english.steps[i].stop) << step.title;
      EXPECT_EQ(step.state.equation, english.steps[i].state.equation) << step.title;
      EXPECT_EQ(step.state.printed, english.steps[i].state.printed) << step.title;
    }
    EXPECT_EQ(blocksOf(translated), blocksOf(entry.path().string())) << translated;
  }
  EXPECT_EQ(lessons, 4);
}

}  // namespace
}  // namespace flatland
