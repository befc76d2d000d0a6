// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/gl_painter.h"

#include <QMatrix4x4>
#include <QVector3D>
#include <algorithm>
#include <array>

#include "ui/model/orbit.h"
#include "ui/view3d/gl_shaders.h"

namespace flatland::ui {

namespace {

QVector3D vectorOf(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

QVector3D sharesOf(Rgb c) { return QVector3D(c.r, c.g, c.b) / 255.0f; }

template <class Value>
void send(QOpenGLBuffer& buffer, const std::vector<Value>& values) {
  if (!buffer.isCreated()) buffer.create();
  buffer.bind();
  buffer.allocate(values.data(), static_cast<int>(values.size() * sizeof(Value)));
}

/// How far the surface steps back from its lines, in pixels of its slope: beside a contour it is so
/// steep that it would hide the inner half of the line.
constexpr float kStepBackPx = 1.5f;

}  // namespace

GlPainter::GlPainter() {
  initializeOpenGLFunctions();
  using Type = QOpenGLShader::ShaderTypeBit;
  build(meshProgram_,
        {{Type::Vertex, shaders::kMeshVertex}, {Type::Fragment, shaders::kMeshFragment}});
  build(lineProgram_, {{Type::Vertex, shaders::kLineVertex},
                       {Type::Geometry, shaders::kLineGeometry},
                       {Type::Fragment, shaders::kLineFragment}});
  meshArrays_.create();
  lineArrays_.create();
  markArrays_.create();
}

void GlPainter::build(
    QOpenGLShaderProgram& program,
    std::initializer_list<std::pair<QOpenGLShader::ShaderType, const char*>> parts) {
  for (const auto& [type, text] : parts) {
    if (!program.addShaderFromSourceCode(type, text)) fault_ = program.log();
  }
  if (!program.link()) fault_ = program.log();
}

void GlPainter::sendMesh(const SurfacePicture& picture) {
  const LoadedSurface& surface = *picture.surface;
  if (mesh_ == surface.mesh) return;
  mesh_ = surface.mesh;
  isClosed_ = std::all_of(mesh_->opposite.begin(), mesh_->opposite.end(),
                          [](std::uint32_t other) { return other < TriangleMesh::kCut; });
  coloured_.reset();
  std::vector<Eigen::Vector3f> places;
  places.reserve(mesh_->vertexCount());
  for (std::uint32_t v = 0; v < mesh_->vertexCount(); ++v) places.push_back(mesh_->position(v));
  const QOpenGLVertexArrayObject::Binder bound(&meshArrays_);
  send(positions_, places);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  send(normals_, surface.normals);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  send(indices_, mesh_->triangles);
  indexCount_ = static_cast<int>(3 * mesh_->triangleCount());
  glDisableVertexAttribArray(2);
  hasColours_ = false;
}

void GlPainter::sendColours(const SurfacePicture& picture) {
  const VertexColours* colours = picture.colours();
  if (colours && coloured_ == picture.seen) return;
  const QOpenGLVertexArrayObject::Binder bound(&meshArrays_);
  hasColours_ = colours != nullptr;
  coloured_ = colours ? picture.seen : nullptr;
  if (!colours) return glDisableVertexAttribArray(2);
  send(colours_, colours->share);
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void GlPainter::sendLines(const SurfacePicture& picture) {
  if (picture.seen == seen_) return;
  seen_ = picture.seen;
  starts_.clear();
  std::vector<LineVertex> all;
  const auto add = [&](const std::vector<LineVertex>& ends) {
    starts_[&ends] = static_cast<int>(all.size());
    all.insert(all.end(), ends.begin(), ends.end());
  };
  if (seen_) {
    for (const auto& ends : seen_->lines) add(ends);
    if (seen_->difference) {
      for (const auto& ends : seen_->difference->lines) add(ends);
    }
  }
  const QOpenGLVertexArrayObject::Binder bound(&lineArrays_);
  send(lines_, all);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(LineVertex), nullptr);
}

void GlPainter::sendMarks(const SurfacePicture& picture) {
  std::vector<LineEnds> ends;
  for (const MarkLines& marks : picture.marks) ends.push_back(marks.ends);
  if (ends == sentMarks_) return;
  sentMarks_ = std::move(ends);
  std::vector<LineVertex> all;
  for (const LineEnds& marks : sentMarks_) all.insert(all.end(), marks->begin(), marks->end());
  const QOpenGLVertexArrayObject::Binder bound(&markArrays_);
  send(marks_, all);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(LineVertex), nullptr);
}

void GlPainter::paintMesh(const SurfacePicture& picture) {
  const ShadingColours shading = shadingColours(picture.palette);
  meshProgram_.bind();
  meshProgram_.setUniformValue("clip", clip_);
  meshProgram_.setUniformValue("axes", axes_);
  meshProgram_.setUniformValue("style", static_cast<int>(styleOf(picture.setting)));
  meshProgram_.setUniformValue("hasColours", hasColours_);
  meshProgram_.setUniformValue("light", vectorOf(kLight));
  meshProgram_.setUniformValue("background", vectorOf(shading.background));
  meshProgram_.setUniformValue("base", vectorOf(shading.base));
  meshProgram_.setUniformValue("dark", vectorOf(shading.dark));
  meshProgram_.setUniformValue("warm", vectorOf(shading.warm));
  meshProgram_.setUniformValue("cool", vectorOf(shading.cool));
  if (const VertexColours* colours = picture.colours()) {
    std::array<QVector3D, 5> stops;
    const auto row = colours->scale.stops(picture.palette);
    std::transform(row.begin(), row.end(), stops.begin(), sharesOf);
    meshProgram_.setUniformValueArray("stops", stops.data(), static_cast<int>(stops.size()));
    meshProgram_.setUniformValue("noValue", sharesOf(ColourScale::kNoValue));
  }
  const QOpenGLVertexArrayObject::Binder bound(&meshArrays_);
  indices_.bind();
  glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

void GlPainter::setUpLines(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                           bool hiddenOnes) {
  lineProgram_.bind();
  lineProgram_.setUniformValue("clip", clip_);
  lineProgram_.setUniformValue("halfSize", QSizeF(pixels) / 2.0);
  lineProgram_.setUniformValue("bias", kLineBias);
  lineProgram_.setUniformValue("weakest", kWeakestInk);
  const bool dashed = hiddenOnes && hiddenOf(picture.setting) == HiddenLines::Dashed;
  lineProgram_.setUniformValue("dashPx", dashed ? kDashPx * static_cast<float>(pixelRatio) : 0.0f);
  lineProgram_.setUniformValue("opacity", hiddenOnes ? kHiddenInk : 1.0f);
}

void GlPainter::paintMarks(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                           bool hiddenOnes) {
  if (picture.marks.empty()) return;
  setUpLines(picture, pixels, pixelRatio, hiddenOnes);
  const QOpenGLVertexArrayObject::Binder bound(&markArrays_);
  lineProgram_.setUniformValue("threshold", 0.0f);
  int first = 0;
  for (const MarkLines& marks : picture.marks) {
    const int count = static_cast<int>(marks.ends->size());
    lineProgram_.setUniformValue("colour", sharesOf(marks.colour));
    lineProgram_.setUniformValue("opacity", hiddenOnes ? kHiddenInk * marks.ink : marks.ink);
    lineProgram_.setUniformValue(
        "halfWidth", static_cast<float>(0.5 * marks.widthPx * picture.lineScale * pixelRatio));
    if (count > 0) glDrawArrays(GL_LINES, first, count);
    first += count;
  }
}

void GlPainter::paintLines(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                           bool hiddenOnes) {
  setUpLines(picture, pixels, pixelRatio, hiddenOnes);
  const QOpenGLVertexArrayObject::Binder bound(&lineArrays_);
  for (const LineLayer& layer : lineLayers(picture)) {
    if (layer.ends->empty()) continue;
    lineProgram_.setUniformValue("colour", sharesOf(layer.colour));
    lineProgram_.setUniformValue("threshold", static_cast<float>(layer.threshold));
    lineProgram_.setUniformValue(
        "halfWidth", static_cast<float>(0.5 * layer.widthPx * picture.lineScale * pixelRatio));
    const int start = starts_.at(layer.ends), all = static_cast<int>(layer.ends->size());
    if (!layer.visibleEnds) {
      glDrawArrays(GL_LINES, start, all);
      continue;
    }
    const int visible = static_cast<int>(*layer.visibleEnds);
    glDisable(GL_DEPTH_TEST);
    if (hiddenOnes) {
      glDrawArrays(GL_LINES, start + visible, all - visible);
    } else {
      glDrawArrays(GL_LINES, start, visible);
    }
    glEnable(GL_DEPTH_TEST);
  }
}

void GlPainter::paint(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                      bool inMotion) {
  const ShadingColours shading = shadingColours(picture.palette);
  glViewport(0, 0, pixels.width(), pixels.height());
  glClearColor(shading.background[0], shading.background[1], shading.background[2], 1.0f);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!picture.surface || !fault_.isEmpty()) return;
  const double radius = picture.surface->ballRadius;
  const Projection projection = orbitProjection(
      picture.setting.camera, radius, pixels.width() / pixelRatio, pixels.height() / pixelRatio);
  const Eigen::Matrix4d clip = clipMatrix(projection, radius);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) clip_(i, k) = static_cast<float>(clip(i, k));
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) axes_(i, k) = static_cast<float>(projection.axes(i, k));
  }
  sendMesh(picture);
  sendColours(picture);
  sendLines(picture);

  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  // What is turned away lies behind what is not, unless the surface passes through itself: then a
  // picture that is gone in a moment is a little wrong. Near a viewer the front may be cut away.
  // A revolved curve that crosses itself has whole rooms turned inside out.
  const bool culls =
      inMotion && isClosed_ && !projection.distance && !picture.setting.swept.has_value();
  if (culls) glEnable(GL_CULL_FACE);
  glDepthFunc(GL_LESS);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kStepBackPx * static_cast<float>(pixelRatio), 0.0f);
  paintMesh(picture);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_CULL_FACE);
  // Lines hide nothing.
  sendMarks(picture);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  if (hiddenOf(picture.setting) != HiddenLines::Off) {
    glDepthFunc(GL_GREATER);
    paintMarks(picture, pixels, pixelRatio, true);
    paintLines(picture, pixels, pixelRatio, true);
  }
  glDepthFunc(GL_LEQUAL);
  paintMarks(picture, pixels, pixelRatio, false);
  paintLines(picture, pixels, pixelRatio, false);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace flatland::ui
