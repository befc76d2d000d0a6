// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QSize>
#include <map>
#include <memory>

#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

/// Draws a SurfacePicture with OpenGL 3.3 core. Made, used and destroyed while its context is
/// current. What is on the card already is not sent again: a turn of the camera sends nothing but
/// the lines found since.
class GlPainter : protected QOpenGLExtraFunctions {
 public:
  GlPainter();

  /// Empty if all is well, else why nothing can be drawn.
  const QString& fault() const { return fault_; }

  /// `pixels` is the size of the frame buffer. In motion the far side of a closed surface is left
  /// out, which by the processor takes two thirds of the time: right wherever it does not pass
  /// through itself.
  void paint(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
             bool inMotion = false);

 private:
  void build(QOpenGLShaderProgram& program,
             std::initializer_list<std::pair<QOpenGLShader::ShaderType, const char*>> parts);
  void sendMesh(const SurfacePicture& picture);
  void sendColours(const SurfacePicture& picture);
  void sendLines(const SurfacePicture& picture);
  void sendMarks(const SurfacePicture& picture);
  void paintMesh(const SurfacePicture& picture);
  void setUpLines(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                  bool hiddenOnes);
  void paintMarks(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                  bool hiddenOnes);
  void paintLines(const SurfacePicture& picture, const QSize& pixels, double pixelRatio,
                  bool hiddenOnes);

  QString fault_;
  QOpenGLShaderProgram meshProgram_, lineProgram_;
  QOpenGLVertexArrayObject meshArrays_, lineArrays_, markArrays_;
  QOpenGLBuffer positions_, normals_, colours_, indices_{QOpenGLBuffer::IndexBuffer}, lines_,
      marks_;
  std::map<const std::vector<LineVertex>*, int> starts_;  ///< in lines_, of what seen_ has
  int indexCount_ = 0;
  bool hasColours_ = false;
  std::shared_ptr<const TriangleMesh> mesh_;  ///< the one on the card
  bool isClosed_ = false;                     ///< mesh_ has no border
  std::shared_ptr<const SeenSurface> seen_, coloured_;
  std::vector<LineEnds> sentMarks_;
  QMatrix4x4 clip_;
  QMatrix3x3 axes_;
};

}  // namespace flatland::ui
