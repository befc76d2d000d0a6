// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/lines_command.h"

#include <optional>

#include "flatland/io/number_text.h"
#include "ui/export/plain_text.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"

namespace flatland::ui {

namespace {

std::string vectorText(const Eigen::Vector3d& v) {
  return numberText(v.x()) + "," + numberText(v.y()) + "," + numberText(v.z());
}

std::string sizeText(const QSize& size) {
  return std::to_string(size.width()) + "x" + std::to_string(size.height());
}

/// What the command says once of all families.
struct CommonLook {
  double widthPx;
  bool fade;

  bool operator==(const CommonLook&) const = default;
};

/// Of the families that are drawn; nullopt if they differ, or one has a colour of its own.
std::optional<CommonLook> commonLook(const SurfacePicture& picture, const LineOptions& lines) {
  std::optional<CommonLook> common;
  for (const LineFamily family : allLineFamilies()) {
    if (!lines[family]) continue;
    const SurfaceFamily look = familyOf(picture.setting, family);
    const CommonLook here{look.widthPx, look.fade && !picture.setting.unfiltered};
    if (!look.colour.empty() || (common && !(*common == here))) return std::nullopt;
    common = here;
  }
  return common;
}

std::string hiddenText(HiddenLines hidden) {
  switch (hidden) {
    case HiddenLines::Dashed:
      return " --hidden dash";
    case HiddenLines::Shown:
      return " --hidden show";
    case HiddenLines::Off:
      break;
  }
  return {};
}

std::string familiesText(const LineOptions& lines) {
  const std::array<double, kLineFamilyCount> usual = LineOptions::defaultThresholds();
  std::string names, more;
  for (const LineFamily family : allLineFamilies()) {
    if (!lines[family]) continue;
    const std::string name(nameOf(family));
    names += (names.empty() ? "" : ",") + name;
    const double threshold = lines.thresholdOf(family);
    if (threshold != usual[static_cast<std::size_t>(family)]) {
      more += " --threshold " + name + "=" + numberText(threshold);
    }
    if (family == LineFamily::Isophotes) {
      more += " --isophotes " + std::to_string(lines.isophoteLevels);
    }
    if (family == LineFamily::Topographic) {
      more += " --topographic " + std::to_string(lines.topographicLevels) + " --topographic-up " +
              vectorText(lines.topographicUp);
    }
  }
  return " --lines " + names + more;
}

std::string cameraText(const SurfaceCamera& camera) {
  // A camera with a centre fits the ball that holds the mesh, as the window does.
  std::string text = " --view " + vectorText(camera.towards) + " --up " + vectorText(camera.up) +
                     " --centre " + vectorText(camera.centre);
  if (camera.zoom != 1.0) text += " --zoom " + numberText(camera.zoom);
  if (camera.perspectiveDeg) text += " --perspective " + numberText(*camera.perspectiveDeg);
  return text;
}

}  // namespace

std::string linesCommand(const std::vector<SurfacePicture>& pictures, const QSize& size,
                         const std::string& file) {
  if (pictures.size() != 1) return {};
  const SurfacePicture& picture = pictures.front();
  const SurfaceSetting& setting = picture.pane.surface;
  const bool bridged = picture.bridge || picture.section || picture.surface->swept;
  if (bridged || picture.pane.difference || picture.pane.ownCamera || setting.ink) return {};
  if (picture.palette == Palette::HighContrast) return {};
  const LineOptions lines = lineOptionsOf(picture.pane);
  const std::optional<CommonLook> look = commonLook(picture, lines);
  if (!look) return {};
  std::string mesh = setting.mesh;
  if (namesFile(mesh)) mesh = mesh.substr(mesh.rfind('/') + 1);
  std::string command = "flatland lines " + shellWord(mesh) + " -o " + shellWord(file) +
                        cameraText(picture.pane.camera) + " --size " + sizeText(size) +
                        familiesText(lines) + " --width " + numberText(look->widthPx) +
                        " --colours" + hiddenText(hiddenOf(picture.setting));
  if (look->fade) command += " --style fade";
  if (lines.unfiltered) command += " --unfiltered";
  if (lines.derivative == RidgeDerivative::OneRing) command += " --derivative one-ring";
  if (setting.fitScale != 1.0) command += " --scale " + numberText(setting.fitScale);
  if (picture.palette == Palette::Dark) command += " --dark";
  return command;
}

}  // namespace flatland::ui
