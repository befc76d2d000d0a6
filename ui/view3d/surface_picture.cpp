// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_picture.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/export/figure_cells.h"
#include "ui/export/figure_qt.h"
#include "ui/export/line_style.h"
#include "ui/model/orbit.h"
#include "ui/model/theme.h"
#include "ui/view3d/mark_groups.h"
#include "ui/view3d/pane_menu.h"
#include "ui/view3d/picture_legend.h"

namespace flatland::ui {

namespace {

using Eigen::Vector3f;

constexpr int kFiner =
    2;  ///< the surface is drawn so much larger and then made small: smooth edges

std::array<float, 3> shares(Rgb colour) {
  return {static_cast<float>(colour.r) / 255.0f, static_cast<float>(colour.g) / 255.0f,
          static_cast<float>(colour.b) / 255.0f};
}

Vector3f vectorOf(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

/// A vertex on the way to the picture: x, y in its pixels, z as in clip space, normal in its axes.
struct Corner {
  Vector3f at;
  Vector3f normal;
  bool inFront;
};

class Painter {
 public:
  Painter(const SurfacePicture& picture, const QSize& size, double ratio)
      : picture_(picture),
        size_(size),
        ratio_(ratio),
        style_(styleOf(picture.setting)),
        shading_(shadingColours(picture.palette)),
        colours_(picture.colours()),
        width_(size.width() * kFiner),
        height_(size.height() * kFiner),
        image_(width_, height_, QImage::Format_RGB32),
        depth_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
               std::numeric_limits<float>::infinity()) {
    const Projection projection = orbitProjection(
        picture.setting.camera, picture.surface->ballRadius, size.width(), size.height());
    clip_ = clipMatrix(projection, picture.surface->ballRadius).cast<float>();
    axes_ = projection.axes.cast<float>();
  }

  QImage paint() {
    image_.fill(rgb(vectorOf(shading_.background)));
    const TriangleMesh& mesh = *picture_.surface->mesh;
    corners_.reserve(mesh.vertexCount());
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) corners_.push_back(cornerOf(v));
    for (const auto& triangle : mesh.triangles) paintTriangle(triangle);
    QImage small = image_.scaled(size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const HiddenLines hidden = hiddenOf(picture_.setting);
    for (const bool visible : {false, true}) {
      if (!visible && hidden == HiddenLines::Off) continue;
      paintMarks(small, hidden, visible);
      paintLines(small, hidden, visible);
    }
    return small;
  }

 private:
  static QRgb rgb(const Vector3f& c) {
    const auto byte = [](float share) {
      return static_cast<int>(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f));
    };
    return qRgb(byte(c.x()), byte(c.y()), byte(c.z()));
  }

  Vector3f toPicture(const Vector3f& p, bool* inFront) const {
    const Eigen::Vector4f c = clip_ * Eigen::Vector4f(p.x(), p.y(), p.z(), 1.0f);
    *inFront = c.w() > 0.0f && c.z() > -c.w();
    return {(c.x() / c.w() * 0.5f + 0.5f) * static_cast<float>(width_),
            (0.5f - c.y() / c.w() * 0.5f) * static_cast<float>(height_), c.z() / c.w()};
  }

  Corner cornerOf(std::uint32_t v) const {
    Corner corner;
    corner.at = toPicture(picture_.surface->mesh->position(v), &corner.inFront);
    corner.normal = axes_ * picture_.surface->normals[v];
    return corner;
  }

  float shareOf(std::uint32_t v) const { return colours_ ? colours_->share[v] : 0.0f; }

  /// Of the surface before it is lit.
  Vector3f ownColour(float share) const {
    return colours_ ? vectorOf(shares(colours_->scale.at(share, picture_.palette)))
                    : vectorOf(shading_.base);
  }

  void paintTriangle(const std::array<std::uint32_t, 3>& t) {
    const Corner &a = corners_[t[0]], &b = corners_[t[1]], &c = corners_[t[2]];
    if (!a.inFront || !b.inFront || !c.inFront) return;
    const Vector3f ab = b.at - a.at, ac = c.at - a.at;
    const float area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0.0f) return;
    const auto low = [](float x, float y, float z) { return std::floor(std::min({x, y, z})); };
    const auto high = [](float x, float y, float z) { return std::ceil(std::max({x, y, z})); };
    const int left = std::max(static_cast<int>(low(a.at.x(), b.at.x(), c.at.x())), 0);
    const int right = std::min(static_cast<int>(high(a.at.x(), b.at.x(), c.at.x())), width_ - 1);
    const int top = std::max(static_cast<int>(low(a.at.y(), b.at.y(), c.at.y())), 0);
    const int bottom = std::min(static_cast<int>(high(a.at.y(), b.at.y(), c.at.y())), height_ - 1);
    // y is down in the picture, so what is counter-clockwise to the eye has a negative area here.
    const bool front = area < 0.0f;
    const float sa = shareOf(t[0]), sb = shareOf(t[1]), sc = shareOf(t[2]);
    Vector3f flat = flatNormal(t);
    for (int y = top; y <= bottom; ++y) {
      auto* row = reinterpret_cast<QRgb*>(image_.scanLine(y));
      for (int x = left; x <= right; ++x) {
        const float px = static_cast<float>(x) + 0.5f - a.at.x();
        const float py = static_cast<float>(y) + 0.5f - a.at.y();
        const float u = (px * ac.y() - py * ac.x()) / area;
        const float v = (ab.x() * py - ab.y() * px) / area;
        if (u < 0.0f || v < 0.0f || u + v > 1.0f) continue;
        const float z = a.at.z() + u * ab.z() + v * ac.z();
        float& nearest = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                static_cast<std::size_t>(x)];
        if (z >= nearest) continue;
        nearest = z;
        const float w = 1.0f - u - v;
        Vector3f n = style_ == SurfaceStyle::Flat
                         ? flat
                         : Vector3f((w * a.normal + u * b.normal + v * c.normal).normalized());
        if (!front) n = -n;
        row[x] = rgb(shaded(n, ownColour(w * sa + u * sb + v * sc)));
      }
    }
  }

  Vector3f flatNormal(const std::array<std::uint32_t, 3>& t) const {
    const TriangleMesh& mesh = *picture_.surface->mesh;
    const Vector3f a = mesh.position(t[0]);
    return axes_ * (mesh.position(t[1]) - a).cross(mesh.position(t[2]) - a).normalized();
  }

  /// The same as in the fragment shader of gl_shaders.h.
  Vector3f shaded(const Vector3f& n, const Vector3f& colour) const {
    const float light = n.dot(vectorOf(kLight));
    const Vector3f base = vectorOf(shading_.base), dark = vectorOf(shading_.dark);
    const auto mix = [](const Vector3f& a, const Vector3f& b, float t) {
      return Vector3f(a + std::clamp(t, 0.0f, 1.0f) * (b - a));
    };
    switch (style_) {
      case SurfaceStyle::Paper:
        return vectorOf(shading_.background);
      case SurfaceStyle::Flat:
      case SurfaceStyle::Lambert:
        return mix(dark, base, 0.25f + 0.75f * light);
      case SurfaceStyle::Toon:
        return mix(dark, base, light > 0.6f ? 1.0f : light > 0.2f ? 0.66f : 0.33f);
      case SurfaceStyle::Gooch:
        return mix(vectorOf(shading_.cool), vectorOf(shading_.warm), 0.5f + 0.5f * light);
      case SurfaceStyle::Normals:
        return 0.5f * n + Vector3f::Constant(0.5f);
      case SurfaceStyle::Colours:
        break;
    }
    return colour * (0.86f + 0.14f * std::max(light, 0.0f));
  }

  /// Of all marks, and then of all lines, what is visible or what is hidden.
  void paintMarks(QImage& image, HiddenLines hidden, bool visible) const {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const MarkLines& marks : picture_.marks) {
      const std::vector<LineVertex>& ends = *marks.ends;
      const LineLayer layer{&ends, marks.colour, marks.widthPx, 0.0};
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        paintSegment(painter, ends[i], ends[i + 1], layer, {hidden, visible}, marks.ink);
      }
    }
  }

  void paintLines(QImage& image, HiddenLines hidden, bool visible) const {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const LineLayer& layer : lineLayers(picture_)) {
      for (std::size_t i = 0; i + 1 < layer.ends->size(); i += 2) {
        const auto seen = layer.visibleEnds ? std::optional(i < *layer.visibleEnds) : std::nullopt;
        if (seen && *seen != visible) continue;
        paintSegment(painter, (*layer.ends)[i], (*layer.ends)[i + 1], layer, {hidden, visible},
                     1.0f, seen);
      }
    }
  }

  /// What of a segment is painted: its visible part, or its hidden part and how.
  struct Part {
    HiddenLines hidden;
    bool visible;
  };

  /// `seen`: whether it is not hidden, if that is known.
  void paintSegment(QPainter& painter, const LineVertex& a, const LineVertex& b,
                    const LineLayer& layer, Part part, float opacity = 1.0f,
                    std::optional<bool> seen = {}) const {
    bool aInFront = false, bInFront = false;
    const Vector3f from = toPicture({a.x, a.y, a.z}, &aInFront);
    const Vector3f to = toPicture({b.x, b.y, b.z}, &bInFront);
    if (!aInFront || !bInFront) return;
    const float ink = opacity * inkOf(0.5f * (a.strength + b.strength), layer.threshold);
    // In pieces within a dash or a gap each, counted along the axis it follows more closely, as in
    // gl_shaders.h. A piece is hidden or not by its middle; those alike are drawn as one.
    const int axis = std::abs(to.x() - from.x()) >= std::abs(to.y() - from.y()) ? 0 : 1;
    const float dash = kDashPx * static_cast<float>(kFiner * ratio_);
    const float first = from[axis] / dash, last = to[axis] / dash;
    const auto shareAt = [first, last](float place) {
      return first == last ? 1.0f : std::min((place - first) / (last - first), 1.0f);
    };
    float begun = 0.0f, done = 0.0f, before = 0.0f;  // shares of the segment, opacity
    for (float at = first; done < 1.0f;) {
      const float next = last > first ? std::floor(at) + 1.0f : std::ceil(at) - 1.0f;
      const float reached = shareAt(next);
      const float middle = 0.5f * (at + (reached < 1.0f ? next : last));
      const bool isGap = static_cast<long>(std::floor(middle)) % 2 != 0;
      const bool visible = seen ? *seen : isVisible(from + 0.5f * (done + reached) * (to - from));
      const float opacityHere = visible != part.visible ? 0.0f
                                : visible               ? 1.0f
                                                        : hiddenOpacity(part.hidden, isGap);
      if (opacityHere != before) {
        paintPiece(painter, from + begun * (to - from), from + done * (to - from), layer,
                   before * ink);
        begun = done;
        before = opacityHere;
      }
      done = reached;
      at = next;
    }
    paintPiece(painter, from + begun * (to - from), to, layer, before * ink);
  }

  static float hiddenOpacity(HiddenLines hidden, bool isGap) {
    const bool drawn = hidden == HiddenLines::Shown || (hidden == HiddenLines::Dashed && !isGap);
    return drawn ? kHiddenInk : 0.0f;
  }

  void paintPiece(QPainter& painter, const Vector3f& from, const Vector3f& to,
                  const LineLayer& layer, float ink) const {
    if (!(ink > 0.0f)) return;
    QColor shade(layer.colour.r, layer.colour.g, layer.colour.b);
    shade.setAlphaF(ink);
    QPen pen(shade, layer.widthPx * picture_.lineScale * ratio_);
    // Round ends would overlap at every joint and show as dots where a line is transparent.
    pen.setCapStyle(ink < 1.0f ? Qt::FlatCap : Qt::RoundCap);
    painter.setPen(pen);
    const auto point = [](const Vector3f& p) {
      return QPointF(static_cast<double>(p.x()) / kFiner, static_cast<double>(p.y()) / kFiner);
    };
    painter.drawLine(point(from), point(to));
  }

  /// Against the farthest of the surroundings: beside an outline that is the background.
  bool isVisible(const Vector3f& p) const {
    float farthest = -1.0f;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = static_cast<int>(p.x()) + dx, y = static_cast<int>(p.y()) + dy;
        if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
        farthest = std::max(farthest,
                            depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(x)]);
      }
    }
    return p.z() - kLineBias <= farthest;
  }

  const SurfacePicture& picture_;
  QSize size_;
  double ratio_;
  SurfaceStyle style_;
  ShadingColours shading_;
  const VertexColours* colours_;
  int width_, height_;
  QImage image_;
  std::vector<float> depth_;
  Eigen::Matrix4f clip_;
  Eigen::Matrix3f axes_;
  std::vector<Corner> corners_;
};

}  // namespace

const VertexColours* SurfacePicture::colours() const {
  const bool there = styleOf(setting) == SurfaceStyle::Colours && seen && seen->colours &&
                     seen->surface->mesh == surface->mesh;
  return there ? &*seen->colours : nullptr;
}

Rgb differenceColour(std::size_t part, Palette palette) {
  const bool light = palette == Palette::Light;
  switch (part) {
    case SeenDifference::Added:
      return light ? Rgb{213, 94, 0} : Rgb{230, 159, 0};
    case SeenDifference::Missing:
      return light ? Rgb{0, 114, 178} : Rgb{86, 180, 233};
    default:
      return light ? Rgb{150, 150, 150} : Rgb{140, 140, 140};
  }
}

std::vector<LineLayer> lineLayers(const SurfacePicture& picture) {
  if (!picture.seen || !picture.surface ||
      !isSameSurface(*picture.surface, *picture.seen->surface)) {
    return {};
  }
  std::vector<LineLayer> layers;
  if (picture.pane.difference) {
    // Nothing before it is computed: whole lines would say that all of them differ.
    if (!picture.seen->difference) return {};
    for (std::size_t part = 0; part < SeenDifference::kParts; ++part) {
      layers.push_back({&picture.seen->difference->lines[part],
                        differenceColour(part, picture.palette), SurfaceFamily{}.widthPx, 0.0});
    }
    return layers;
  }
  const SeenSurface& seen = *picture.seen;
  const bool knowsHidden =
      seen.surface->mesh == picture.surface->mesh &&
      seen.knowsHidden(orbitView(picture.setting.camera, picture.surface->ballRadius));
  for (const LineFamily family : paintingOrder()) {
    const auto index = static_cast<std::size_t>(family);
    const SurfaceFamily look = familyOf(picture.setting, family);
    if (!look.on) continue;
    const bool fades = look.fade && !picture.setting.unfiltered;
    layers.push_back({&seen.lines[index], colourOf(look, picture.palette), look.widthPx,
                      fades ? *look.threshold : 0.0});
    if (knowsHidden) layers.back().visibleEnds = (*seen.visibleEnds)[index];
  }
  return layers;
}

void addMarks(SurfacePicture& picture, Bridges& bridges) {
  const auto& bridge = bridges.source.view();
  if (bridge && bridges.source.isShown() &&
      isSameSurface(*bridge->seen->surface, *picture.surface)) {
    picture.bridge = bridge;
    picture.marks = predictedLines(bridges, picture.palette);
  }
  const auto& section = bridges.section.view();
  if (section && section->surface->mesh == picture.surface->mesh) {
    picture.section = section;
    picture.marks.push_back(sectionLine(section, picture.palette));
  }
}

SurfacePicture pictureOf(const SurfaceModels& models) {
  SurfacePicture picture;
  picture.palette = themePalette();
  picture.lineScale = models.display.uiScale();
  if (!models.there()) return picture;
  const PaneSetting pane = models.setting();
  picture.setting = pane.surface;
  picture.setting.camera = pane.camera;
  picture.pane = paneSetting(*models.document.scene().surface, models.pane);
  picture.surface = models.source.surface();
  picture.seen = models.seen.seen();
  picture.markKinds = models.display.families();
  if (picture.surface) addMarks(picture, models.bridges);
  return picture;
}

std::vector<SurfacePicture> picturesOf(const SurfaceModels& models) {
  std::vector<SurfacePicture> pictures;
  for (std::size_t pane = 0; pane < models.views.count(); ++pane) {
    const SurfaceModels view = models.of(pane);
    pictures.push_back(pictureOf(view));
    if (view.there()) pictures.back().title = paneWords(view).toStdString();
  }
  return pictures;
}

ShadingColours shadingColours(Palette palette) {
  ShadingColours colours{};
  colours.background = shares(sceneColours(palette).background);
  if (palette == Palette::Light) {
    colours.base = {0.90f, 0.89f, 0.87f};
    colours.dark = {0.42f, 0.43f, 0.46f};
  } else {
    colours.base = {0.58f, 0.59f, 0.62f};
    colours.dark = {0.16f, 0.16f, 0.18f};
  }
  // Gooch's tones, paler and less yellow: the orange of apparent ridges has to stand out.
  colours.warm = {0.98f, 0.94f, 0.85f};
  colours.cool = {0.45f, 0.56f, 0.78f};
  if (palette != Palette::Light) {
    colours.warm = {0.44f, 0.39f, 0.30f};
    colours.cool = {0.16f, 0.23f, 0.38f};
  }
  return colours;
}

QImage paintSurface(const SurfacePicture& picture, const QSize& size, double ratio) {
  if (!picture.surface) {
    QImage empty(size, QImage::Format_RGB32);
    const Rgb background = sceneColours(picture.palette).background;
    empty.fill(qRgb(background.r, background.g, background.b));
    return empty;
  }
  return Painter(picture, size, ratio).paint();
}

namespace {

/// With what the window has above it: marks, and the legend of a difference.
QImage paintWithMarks(const SurfacePicture& picture, const QSize& size, double ratio) {
  constexpr int kMargin = 10;
  QImage image = paintSurface(picture, size, ratio);
  if (!picture.surface) return image;
  QPainter painter(&image);
  painter.scale(ratio, ratio);
  const QRectF bounds(0.0, 0.0, size.width() / ratio, size.height() / ratio);  // of the window
  const Projection projection = orbitProjection(picture.setting.camera, picture.surface->ballRadius,
                                                bounds.width(), bounds.height());
  paintFigure(painter, {.width = bounds.width(),
                        .height = bounds.height(),
                        .background = std::nullopt,
                        .groups = markGroups(picture, projection, picture.lineScale)});
  const SceneColours& colours = sceneColours(picture.palette);
  painter.setPen(toQColor(colours.text));
  painter.setBackground(toQColor(colours.background));
  paintDifferenceLegend(painter, bounds.toRect().adjusted(kMargin, kMargin, -kMargin, -kMargin),
                        picture);
  return image;
}

}  // namespace

QImage paintSurfaces(const std::vector<SurfacePicture>& pictures, const QSize& size, double ratio) {
  const SurfacePicture& first = pictures.front();
  QImage all(size, QImage::Format_RGB32);
  const SceneColours& colours = sceneColours(first.palette);
  all.fill(toQColor(colours.background));
  QPainter painter(&all);
  painter.setPen(toQColor(colours.text));
  const double width = size.width() / ratio, height = size.height() / ratio;  // of the window
  // All views have the same colours: one legend, below them.
  double below = 0.0;
  if (first.surface && first.colours()) {
    below = colourLegendHeight(painter.fontMetrics(), first.lineScale);
    painter.scale(ratio, ratio);
    paintColourLegend(painter, QRectF(0.0, height - below, width, below).toRect(), first);
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const CellPlace place = cellPlace(i, pictures.size(), width, std::max(height - below, 1.0));
    const QRectF there(place.left, place.top, place.width, place.height);
    const QRect cell(
        QPoint(qRound(there.left() * ratio), qRound(there.top() * ratio)),
        QSize(qRound(there.width() * ratio), qRound(there.height() * ratio)).expandedTo({1, 1}));
    painter.resetTransform();
    painter.drawImage(cell.topLeft(), paintWithMarks(pictures[i], cell.size(), ratio));
    painter.scale(ratio, ratio);
    if (place.titleHeight == 0.0) continue;
    painter.drawText(QRectF(there.left() + 4.0, there.top() - place.titleHeight,
                            there.width() - 8.0, place.titleHeight),
                     Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(pictures[i].title));
  }
  return all;
}

}  // namespace flatland::ui
