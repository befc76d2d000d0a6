// SPDX-License-Identifier: GPL-3.0-or-later
// The program from the outside: arguments in, files, text and exit codes out.
#include <cmath>
#include <filesystem>
#include <fstream>

#include "flatland/features/features.h"
#include "flatland/io/features_text.h"
#include "flatland/io/scene_json.h"
#include "tests/support/flatland_program.h"
#include "tests/support/xml_check.h"

namespace flatland::test {
namespace {

constexpr bool kWithQt = FLATLAND_WITH_QT;

void expectOneLine(const ProgramResult& result, int exitCode, const std::string& part) {
  EXPECT_EQ(result.exitCode, exitCode) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("flatland: ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
}

TEST(Program, TellsItsVersion) {
  const ProgramResult result = run({"--version"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, "flatland " FLATLAND_VERSION "\n");
  EXPECT_EQ(result.err, "");
}

TEST(Program, HelpTeachesByExamples) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--help"}, "flatland draw preset:thesis -o fig.svg"},
      {{"features", "--help"}, "flatland features scene.json --view-angle 30"},
      {{"draw", "--help"}, "flatland draw preset:loop -o loop.pdf --view-angle 30"},
      {{"shot", "--help"}, "flatland shot scene.json -o window.png --size 1920x1080"},
      {{"presets", "--help"}, "flatland presets bump > mine.json"}};
  for (const auto& [arguments, example] : cases) {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("Examples:"), std::string::npos) << arguments[0];
    EXPECT_NE(result.out.find(example), std::string::npos) << arguments[0];
  }
  EXPECT_NE(run({"--help"}).out.find("Exit codes: 0 done, 1 bad input, 2 bad usage, 3 internal"),
            std::string::npos);
}

// Of the program and of every subcommand that a help lists, theirs too.
TEST(Program, NoLineOfAnyHelpIsLongerThan100Letters) {
  std::vector<std::vector<std::string>> commands{{}};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    std::vector<std::string> arguments = commands[i];
    arguments.push_back("--help");
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exitCode, 0) << arguments.front();
    std::istringstream help(result.out);
    bool listed = false;
    for (std::string line; std::getline(help, line);) {
      EXPECT_LE(line.size(), 100U) << arguments.front() << ": " << line;
      if (line.empty() || line.front() != ' ') {
        listed = line == "Subcommands:";
      } else if (listed && line.size() > 2 && line[2] != ' ') {
        std::vector<std::string> deeper = commands[i];
        deeper.push_back(line.substr(2, line.find(' ', 2) - 2));
        commands.push_back(deeper);
      }
    }
  }
  EXPECT_NE(std::find(commands.begin(), commands.end(), std::vector<std::string>{"bridge"}),
            commands.end());
  EXPECT_NE(
      std::find(commands.begin(), commands.end(), std::vector<std::string>{"study", "limits"}),
      commands.end());
}

TEST(Program, TheExamplesOfTheHelpWork) {
  // Every example on a preset that needs no Qt, taken from the help itself.
  const TemporaryFolder folder;
  int tried = 0;
  for (const char* command : {"features", "draw"}) {
    std::istringstream help(run({command, "--help"}).out);
    for (std::string line; std::getline(help, line);) {
      if (line.rfind("  flatland ", 0) != 0 || line.find("preset:") == std::string::npos) continue;
      if (line.find(".pdf") != std::string::npos || line.find(".png") != std::string::npos)
        continue;
      std::istringstream words(line.substr(0, line.find("  ", 2)));
      std::vector<std::string> arguments;
      for (std::string word; words >> word;) arguments.push_back(word);
      arguments.erase(arguments.begin());
      const ProgramResult result =
          runProgram(FLATLAND_PROGRAM, {.arguments = arguments, .folder = folder.path()});
      EXPECT_EQ(result.exitCode, 0) << line << "\n" << result.err;
      ++tried;
    }
  }
  EXPECT_GE(tried, 2);
}

TEST(Program, BadUsageIsOneLineAndExitCode2) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"features"}, "see flatland features --help"},
      {{"features", "a.json", "b.json"}, "b.json"},
      {{"features", "preset:thesis", "--format", "xml"}, "xml"},
      {{"features", "preset:thesis", "--view-angle", "east"}, "expected a number of degrees"},
      {{"features", "preset:thesis", "--view-angle", "nan"}, "expected a number of degrees"},
      {{"features", "preset:thesis", "--view-angle", "inf"}, "expected a number of degrees"},
      {{"features", "preset:thesis", "--frobnicate"}, "--frobnicate"},
      {{"draw", "preset:thesis"}, "--output is required"},
      {{"draw", "preset:thesis", "-o", "a.gif"}, "should end in .svg, .pdf, .png or .tex"},
      {{"draw", "preset:thesis", "-o", "svg"}, "should end in .svg, .pdf, .png or .tex"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--size", "640"}, "expected WxH"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--size", "640x480x2"}, "expected WxH"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--size", "0x480"}, "expected WxH"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--size", "640x-480"}, "expected WxH"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--size", "99999x480"}, "expected WxH"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--kinds", "ridge,peak"}, "unknown kind peak"},
      {{"draw", "preset:thesis", "-o", "a.svg", "--hidden", "maybe"}, "maybe"},
      {{"draw", "preset:thesis", "-o", "a.png", "--dpi", "0"}, "--dpi"},
      {{"shot"}, "--output is required"},
      {{"shot", "-o", "a.svg"}, "should end in .png"},
      {{"features", "draw"}, ""},
      {{"presets", "thesis", "loop"}, "loop"}};
  for (const auto& [arguments, part] : cases) {
    SCOPED_TRACE(arguments.back());
    const ProgramResult result = run(arguments);
    if (arguments == std::vector<std::string>{"features", "draw"}) {
      // "draw" is a scene's name here, and there is no such file.
      expectOneLine(result, 1, "draw: cannot be read");
    } else {
      expectOneLine(result, 2, part);
    }
  }
}

TEST(Program, BadInputNamesFilePlaceAndReason) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bad.json").string();
  std::ofstream(file) << R"({"flatland": 1, "curves": [{"bezier": [[0, 0], [1, "x"]]}]})";
  const std::string message =
      "flatland: " + file + ": curves[0].bezier[1][1]: expected a number, found a string\n";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"features", file},
        {"draw", file, "-o", (folder.path() / "a.svg").string()}}) {
    const ProgramResult result = run(arguments);
    expectOneLine(result, 1, file);
    EXPECT_EQ(result.err, message);
  }
  EXPECT_EQ(folder.count(), 1U) << "nothing was drawn";

  expectOneLine(run({"features", "none.json"}), 1,
                "none.json: cannot be read: No such file or directory");
  expectOneLine(run({"features", "-"}, "{"), 1, "standard input: line 1, column 2: not valid JSON");
  expectOneLine(run({"features", "preset:thesi"}), 1,
                "preset:thesi: no such preset; there are thesis, circle");
  expectOneLine(run({"presets", "x"}), 1, "no such preset");
}

TEST(Program, OutputThatCannotBeWrittenIsReported) {
  expectOneLine(run({"draw", "preset:thesis", "-o", "/no/such/folder/a.svg"}), 1,
                "/no/such/folder/a.svg: cannot be written: No such file or directory");
  expectOneLine(run({"features", "preset:thesis", "-o", "/dev/full"}), 1,
                "/dev/full: cannot be written: No space left on device");
  // A long text fails while it is written, a short one when it is flushed.
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"features", "preset:thesis"}, {"presets", "cusp"}}) {
    const ProgramResult full =
        runProgram(FLATLAND_PROGRAM, {.arguments = arguments, .standardOutput = "/dev/full"});
    expectOneLine(full, 1, "standard output: cannot be written: No space left on device");
  }
}

TEST(Features, PrintsWhatTheLibraryFinds) {
  const ProgramResult result = run({"features", "preset:thesis"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, featuresToJson(findFeatures(defaultScene()), defaultScene().view));
}

TEST(Features, TheDefaultSceneShowsEveryKindOfMarkItIsKnownFor) {
  const json read = json::parse(run({"features", "preset:thesis"}).out);
  std::map<std::string, int> counts;
  for (const json& mark : read["marks"]) {
    ++counts[mark["kind"].get<std::string>()];
    EXPECT_LT(mark["residual"].get<double>(), 1e-12);
    if (mark["kind"] == "apparent-ridge") {
      const double feature = mark["feature"];
      const double offset = mark["offset"];
      EXPECT_LT(std::abs(feature + offset), 1e-9 * std::abs(feature));
      EXPECT_GT(mark["lambda"].get<double>(), 0.0);
    }
    if (mark["kind"] == "silhouette") {
      EXPECT_TRUE(mark["lambda"].is_null());
    }
    // Seen from +x, the screen's axis points down.
    EXPECT_DOUBLE_EQ(mark["screen"].get<double>(), -mark["point"][1].get<double>());
  }
  for (const char* kind : {"silhouette", "ridge", "valley", "inflection", "apparent-ridge"}) {
    EXPECT_GT(counts[kind], 0) << kind;
  }
  EXPECT_TRUE(read["complete"].get<bool>());
}

TEST(Features, TheViewAngleReplacesTheScenes) {
  Scene scene = defaultScene();
  for (const double angle : {-30.0, 12.5, 400.0}) {
    scene.view.angleDeg = angle;
    std::string text = std::to_string(angle);
    EXPECT_EQ(run({"features", "preset:thesis", "--view-angle", text}).out,
              featuresToJson(findFeatures(scene), scene.view));
  }
}

TEST(Features, ReadsFilesAndStandardInput) {
  const TemporaryFolder folder;
  Scene scene = presets().back().scene;
  scene.view = {75.0, 9.0};
  const std::string file = (folder.path() / "a scene's.json").string();
  saveScene(scene, file);
  const std::string expected = featuresToJson(findFeatures(scene), scene.view);
  EXPECT_EQ(run({"features", file}).out, expected);
  EXPECT_EQ(run({"features", "-"}, sceneToJson(scene)).out, expected);
}

TEST(Features, CsvAndFilesHoldTheSame) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "marks.csv").string();
  const ProgramResult result = run({"features", "preset:thesis", "--format", "csv", "-o", file});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(contentsOf(file), featuresToCsv(findFeatures(defaultScene())));
  EXPECT_EQ(run({"features", "preset:thesis", "--format", "csv"}).out, contentsOf(file));
}

TEST(Presets, AreListedAndPrinted) {
  const ProgramResult list = run({"presets"});
  EXPECT_EQ(list.exitCode, 0);
  for (const Preset& preset : presets()) {
    EXPECT_NE(list.out.find(preset.id + " "), std::string::npos);
    EXPECT_NE(list.out.find(preset.description), std::string::npos);
    const ProgramResult printed = run({"presets", preset.id});
    EXPECT_EQ(printed.exitCode, 0);
    EXPECT_EQ(sceneFromJson(printed.out, preset.id), preset.scene);
  }
}

std::optional<std::string> textOf(const XmlReading& xml, const std::string& name) {
  for (const XmlElement& element : xml.elements) {
    if (element.name == name) return element.text;
  }
  return std::nullopt;
}

TEST(Draw, SvgNeedsNoQtAndMakesItselfAgain) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "it's.svg").string();
  const std::vector<std::string> arguments{
      "draw",    "preset:circle",    "-o",       file,     "--size",           "500x400",
      "--kinds", "ridge,silhouette", "--hidden", "remove", "--control-polygon"};
  const ProgramResult result = run(arguments);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
  const std::string svg = contentsOf(file);
  const XmlReading xml = readXml(svg);
  ASSERT_FALSE(xml.error) << *xml.error;
  EXPECT_EQ(xml.elements.front().attributes.at("width"), "500");
  EXPECT_EQ(xml.elements.front().attributes.at("height"), "400");
  EXPECT_EQ(svg.find("inflection"), std::string::npos);
  EXPECT_EQ(svg.find("-hidden\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"marks-ridge\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"control-polygon\""), std::string::npos);
  EXPECT_EQ(textOf(xml, "program"), "flatland " FLATLAND_VERSION);

  // The command in the file, read by a shell, makes the same file in another folder; where the
  // first one was made it does not tell.
  EXPECT_EQ(svg.find(folder.path().string()), std::string::npos);
  std::string command = textOf(xml, "command").value_or("");
  ASSERT_EQ(command.rfind("flatland draw", 0), 0U) << command;
  command.replace(0, std::string("flatland").size(), "'" FLATLAND_PROGRAM "'");
  const TemporaryFolder other;
  ASSERT_EQ(runProgram("/bin/sh", {.arguments = {"-c", command}, .folder = other.path()}).exitCode,
            0)
      << command;
  EXPECT_EQ(contentsOf(other.path() / "it's.svg"), svg);
}

TEST(Draw, NoPictureTellsOfFolders) {
  const TemporaryFolder folder;
  const std::filesystem::path secret = folder.path() / "secret";
  std::filesystem::create_directory(secret);
  const std::string scene = (secret / "a b.json").string();
  std::ofstream(scene) << run({"presets", "thesis"}).out;
  for (const char* command : {"draw", "sweep", "bridge"}) {
    const std::string title = std::string(command) + ".svg";
    const std::vector<std::vector<std::string>> ways{
        {command, scene, "-o", (secret / title).string()},
        {command, "secret/a b.json", "-osecret/" + title},
        {command, "./secret/../secret/a b.json", "--output=" + (secret / title).string()}};
    for (std::vector<std::string> all : ways) {
      if (all[0] == "bridge") all.insert(all.end(), {"--resolutions", "16"});
      const ProgramResult result = runIn(folder.path(), all);
      ASSERT_EQ(result.exitCode, 0) << result.err;
      const std::string svg = contentsOf(secret / title);
      EXPECT_EQ(svg.find("secret"), std::string::npos) << svg.substr(0, 1000);
      EXPECT_NE(svg.find("a b.json</title>"), std::string::npos) << svg.substr(0, 1000);
      EXPECT_NE(svg.find(title), std::string::npos) << svg.substr(0, 1000);
    }
  }
}

TEST(Draw, TikzNeedsNoQt) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.tex").string();
  const ProgramResult result = run({"draw", "preset:bump", "-o", file, "--no-legend", "--dark"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const std::string tikz = contentsOf(file);
  EXPECT_NE(tikz.find("\\begin{tikzpicture}"), std::string::npos);
  EXPECT_NE(tikz.find("\\end{tikzpicture}"), std::string::npos);
  EXPECT_NE(tikz.find("{flatland-background}{HTML}{1E1E22}"), std::string::npos);
  EXPECT_EQ(tikz.find("% legend"), std::string::npos);
}

TEST(Draw, TheExtensionMayBeInCapitals) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "A.SVG").string();
  ASSERT_EQ(run({"draw", "preset:bump", "-o", file}).exitCode, 0);
  EXPECT_FALSE(readXml(contentsOf(file)).error);
}

/// A number of four bytes, the highest first, as PNG has them.
unsigned bigEndian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value * 256U + static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

void expectPng(const std::string& bytes, unsigned width, unsigned height) {
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(12, 4), "IHDR");
  EXPECT_EQ(bigEndian(bytes, 16), width);
  EXPECT_EQ(bigEndian(bytes, 20), height);
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

TEST(Draw, PngHasThePixelsAskedFor) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.png").string();
  const ProgramResult plain = run({"draw", "preset:thesis", "-o", file, "--size", "320x240"});
  if (!kWithQt) {
    expectOneLine(plain, 2, "needs Qt, which this build was made without; write .svg or .tex");
    EXPECT_EQ(folder.count(), 0U);
    return;
  }
  ASSERT_EQ(plain.exitCode, 0) << plain.err;
  EXPECT_EQ(plain.err, "");
  expectPng(contentsOf(file), 320, 240);
  constexpr char kTrueColour = 2;
  constexpr char kWithAlpha = 6;
  EXPECT_EQ(contentsOf(file).at(25), kTrueColour);
  ASSERT_EQ(run({"draw", "preset:thesis", "-o", file, "--size", "320x240", "--dpi", "240",
                 "--transparent"})
                .exitCode,
            0);
  expectPng(contentsOf(file), 800, 600);
  EXPECT_EQ(contentsOf(file).at(25), kWithAlpha);

  expectOneLine(run({"draw", "preset:thesis", "-o", file, "--dpi", "4800", "--size", "9999x99"}), 1,
                "a picture of 499950 x 4950 pixels is too large");
  expectPng(contentsOf(file), 800, 600);  // the old one
}

TEST(Draw, PdfIsAPageOfTheSizeAskedFor) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.pdf").string();
  const ProgramResult result = run({"draw", "preset:thesis", "-o", file, "--size", "640x400"});
  if (!kWithQt) {
    expectOneLine(result, 2, "needs Qt, which this build was made without; write .svg or .tex");
    EXPECT_EQ(folder.count(), 0U);
    return;
  }
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::string pdf = contentsOf(file);
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("/MediaBox [0 0 480.000000 300.000000]"), std::string::npos);
  EXPECT_NE(pdf.find("/Type /Font"), std::string::npos) << "text is text";
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos) << "shapes are vectors";
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
}

TEST(Shot, PicturesTheWindowWithoutADisplay) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "window.png").string();
  const ProgramResult result =
      run({"shot", "preset:loop", "-o", file, "--size", "1280x800"}, {}, std::nullopt);
  if (!kWithQt) {
    expectOneLine(result, 2, "The window needs Qt, which this build was made without");
    EXPECT_EQ(folder.count(), 0U);
    return;
  }
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  expectPng(contentsOf(file), 1280, 800);
  expectOneLine(run({"shot", "-o", "/no/such/folder/a.png"}, {}, std::nullopt), 1,
                "/no/such/folder/a.png: cannot be written");
}

TEST(Window, SaysSoWithoutADisplay) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{}, std::vector<std::string>{"preset:thesis"}}) {
    expectOneLine(run(arguments, {}, std::nullopt), 2,
                  kWithQt ? "no display to show the window on" : "The window needs Qt");
  }
}

TEST(Window, AMistypedNameIsReportedWhereItWasTyped) {
  const ProgramResult result = run({"featurs"}, {}, "offscreen");
  if (kWithQt) {
    expectOneLine(result, 1, "featurs: cannot be read: No such file or directory");
  } else {
    expectOneLine(result, 2, "The window needs Qt");
  }
}

}  // namespace
}  // namespace flatland::test
