// SPDX-License-Identifier: MIT
#include "core3d/diff/one_ring.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core3d/diff/vertex_blocks.h"

namespace flatland {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Tangents = Eigen::Matrix<double, 3, 2>;

// A plane's frame with symmetric forms of degree 2 and 3 in it, by the number of second indices.
struct Forms {
  Vector3d n = Vector3d::Zero();
  Tangents frame = Tangents::Zero();
  Vector3d K = Vector3d::Zero();  // 11, 12, 22
  Eigen::Vector4d C = Eigen::Vector4d::Zero();
};

struct Triangle {
  std::array<std::uint32_t, 3> vertices;
  Vector3d edges[3];  // opposite to corner 0, 1, 2, each in the direction of the winding
  Vector3d normal;    // its length is twice the area
};

Triangle triangleOf(const TriangleMesh& mesh, std::uint32_t t) {
  const auto vertices = mesh.triangles[t];
  const Vector3d a = mesh.position(vertices[0]).cast<double>(),
                 b = mesh.position(vertices[1]).cast<double>(),
                 c = mesh.position(vertices[2]).cast<double>();
  return {vertices, {c - b, a - c, b - a}, (b - a).cross(c - a)};
}

// The part of the triangle's area that is nearest to corner k, or its usual stand-in where the
// triangle is obtuse (bibliography: meyer2003, section 3.3).
double cornerArea(const Triangle& triangle, int k) {
  const auto* e = triangle.edges;
  const double twice = triangle.normal.norm();
  if (!(twice > 0.0)) return 0.0;
  for (int i = 0; i < 3; ++i) {
    if (e[(i + 1) % 3].dot(e[(i + 2) % 3]) > 0.0) return (i == k ? 0.25 : 0.125) * twice;
  }
  double area = 0.0;
  for (int i = 1; i < 3; ++i) {
    // The edge from k to the corner opposite to e[i], with the cotangent of the angle across.
    const int edge = (k + i) % 3, p = (edge + 1) % 3, q = (edge + 2) % 3;
    area += 0.125 * e[edge].squaredNorm() * -e[p].dot(e[q]) / twice;
  }
  return area;
}

// Takes directions of one plane to another by the shortest turn of its normal, so that forms keep
// their values (rusinkiewicz2004, section 3: rotating, not projecting).
Eigen::Matrix2d turned(const Forms& from, const Forms& to) {
  const double cosine = from.n.dot(to.n);
  Tangents axes = from.frame;
  if (cosine > -1.0) {
    // R x = x - (n + m) m.x / (1 + n.m) for x across n, from n to m.
    axes -= (from.n + to.n) * (to.n.transpose() * from.frame) / (1.0 + cosine);
  } else {
    axes = -axes;
  }
  return to.frame.transpose() * axes;  // column j: axis j of `from` in the frame of `to`
}

// A form in the frame of `to`; the axes of `to` are the rows of the turn.
Vector3d turnedK(const Vector3d& K, const Eigen::Matrix2d& turn) {
  const Vector2d a = turn.row(0), b = turn.row(1);
  const auto value = [&K](const Vector2d& x, const Vector2d& y) {
    return K[0] * x[0] * y[0] + K[1] * (x[0] * y[1] + x[1] * y[0]) + K[2] * x[1] * y[1];
  };
  return {value(a, a), value(a, b), value(b, b)};
}

Eigen::Vector4d turnedC(const Eigen::Vector4d& C, const Eigen::Matrix2d& turn) {
  const SymmetricCubic<2> form{{C[0], C[1], C[2], C[3]}};
  const Vector2d a = turn.row(0), b = turn.row(1);
  return {form(a, a, a), form(a, a, b), form(a, b, b), form(b, b, b)};
}

// The frame of a triangle; false if it has no area.
bool frameOf(const Triangle& triangle, Forms& face) {
  const double twice = triangle.normal.norm(), length = triangle.edges[0].norm();
  if (!(twice > 0.0) || !(length > 0.0)) return false;
  face.n = triangle.normal / twice;
  face.frame.col(0) = triangle.edges[0] / length;
  face.frame.col(1) = face.n.cross(Vector3d(face.frame.col(0)));
  return true;
}

// Least squares over the three edges for K(e) = difference of the normals.
void fitK(const Triangle& triangle, const std::vector<Forms>& vertices, Forms& face) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const auto& from = vertices[triangle.vertices[(i + 1) % 3]].n;
    const auto& to = vertices[triangle.vertices[(i + 2) % 3]].n;
    const Vector2d e = face.frame.transpose() * triangle.edges[i];
    const Vector2d turn = face.frame.transpose() * (to - from);
    const double u = e[0], v = e[1];
    A += (Eigen::Matrix3d() << u * u, u * v, 0, u * v, u * u + v * v, u * v, 0, u * v, v * v)
             .finished();
    b += Vector3d(u * turn[0], u * turn[1] + v * turn[0], v * turn[1]);
  }
  face.K = A.ldlt().solve(b);
}

// The same for C(e) = difference of K. An entry off the diagonal stands twice in K.
void fitC(const Triangle& triangle, const std::vector<Forms>& vertices, Forms& face) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  Vector3d K[3];
  for (int i = 0; i < 3; ++i) {
    const Forms& vertex = vertices[triangle.vertices[i]];
    K[i] = turnedK(vertex.K, turned(vertex, face));
  }
  for (int i = 0; i < 3; ++i) {
    const Vector2d e = face.frame.transpose() * triangle.edges[i];
    const Vector3d change = K[(i + 2) % 3] - K[(i + 1) % 3];
    for (int k = 0; k < 3; ++k) {
      const double weight = k == 1 ? 2.0 : 1.0;
      Eigen::Vector4d row = Eigen::Vector4d::Zero();
      row[k] = e[0];
      row[k + 1] = e[1];
      A += weight * row * row.transpose();
      b += weight * change[k] * row;
    }
  }
  face.C = A.ldlt().solve(b);
}

// A worker for overBlocks that gives every element its index.
template <typename Each>
auto eachOf(const Each& each) {
  return [&each] {
    return [&each](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) each(static_cast<std::uint32_t>(i));
    };
  };
}

// Sums sum(vertex, triangle, corner's weight) over the corners of each vertex and divides by the
// weights.
template <typename Add>
void overCorners(const TriangleMesh& mesh, std::uint32_t v, const Add& add) {
  for (std::uint32_t i = mesh.cornerStart[v]; i < mesh.cornerStart[v + 1]; ++i) {
    const std::uint32_t c = mesh.cornersAt[i];
    add(c / 3, cornerArea(triangleOf(mesh, c / 3), static_cast<int>(c % 3)));
  }
}

// One smoothing pass: every vertex takes the mean of itself and its neighbours.
bool smooth(const TriangleMesh& mesh, std::vector<Forms>& vertices, const FieldOptions& options) {
  const std::vector<Forms> before = vertices;
  const auto pass = [&](std::uint32_t v) {
    Forms& mean = vertices[v];
    double weight = 1.0;
    const auto add = [&](std::uint32_t neighbour) {
      const Eigen::Matrix2d turn = turned(before[neighbour], before[v]);
      mean.K += turnedK(before[neighbour].K, turn);
      mean.C += turnedC(before[neighbour].C, turn);
      weight += 1.0;
    };
    const std::uint32_t begin = mesh.cornerStart[v], end = mesh.cornerStart[v + 1];
    for (std::uint32_t i = begin; i < end; ++i)
      add(mesh.vertexOf(TriangleMesh::nextCorner(mesh.cornersAt[i])));
    if (mesh.isAtEdge(v)) add(mesh.vertexOf(TriangleMesh::previousCorner(mesh.cornersAt[end - 1])));
    mean.K /= weight;
    mean.C /= weight;
  };
  return overBlocks(vertices.size(), options, 1.0, 1.0, eachOf(pass));
}

}  // namespace

std::vector<Vector3d> vertexNormals(const TriangleMesh& mesh, const FieldOptions& options) {
  std::vector<Vector3d> normals(mesh.vertexCount());
  const auto normalOf = [&](std::uint32_t v) {
    const Vector3d p = mesh.position(v).cast<double>();
    Vector3d sum = Vector3d::Zero();
    for (std::uint32_t i = mesh.cornerStart[v]; i < mesh.cornerStart[v + 1]; ++i) {
      const std::uint32_t c = mesh.cornersAt[i];
      const Vector3d a =
          mesh.position(mesh.vertexOf(TriangleMesh::nextCorner(c))).cast<double>() - p;
      const Vector3d b =
          mesh.position(mesh.vertexOf(TriangleMesh::previousCorner(c))).cast<double>() - p;
      const double lengths = a.squaredNorm() * b.squaredNorm();
      if (lengths > 0.0) sum += a.cross(b) / lengths;
    }
    const double length = sum.norm();
    normals[v] = length > 0.0 ? Vector3d(sum / length) : Vector3d::Zero();
  };
  if (!overBlocks(normals.size(), options, 0.0, 0.05, eachOf(normalOf))) normals.clear();
  return normals;
}

SurfaceFields oneRingFields(const TriangleMesh& mesh, const FieldOptions& options) {
  const std::vector<Vector3d> normals = vertexNormals(mesh, options);
  if (normals.empty()) return {};
  std::vector<Forms> vertices(normals.size()), faces(mesh.triangleCount());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    vertices[v].n = normals[v];
    if (normals[v].isZero(0.0)) continue;
    vertices[v].frame.col(0) = normals[v].unitOrthogonal();
    vertices[v].frame.col(1) = normals[v].cross(Vector3d(vertices[v].frame.col(0)));
  }
  const auto faceK = [&](std::uint32_t t) {
    const Triangle triangle = triangleOf(mesh, t);
    if (frameOf(triangle, faces[t])) fitK(triangle, vertices, faces[t]);
  };
  const auto vertexK = [&](std::uint32_t v) {
    double area = 0.0;
    Vector3d sum = Vector3d::Zero();
    overCorners(mesh, v, [&](std::uint32_t t, double weight) {
      sum += weight * turnedK(faces[t].K, turned(faces[t], vertices[v]));
      area += weight;
    });
    if (area > 0.0) vertices[v].K = sum / area;
  };
  const auto faceC = [&](std::uint32_t t) {
    if (!faces[t].n.isZero(0.0)) fitC(triangleOf(mesh, t), vertices, faces[t]);
  };
  const auto vertexC = [&](std::uint32_t v) {
    double area = 0.0;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    overCorners(mesh, v, [&](std::uint32_t t, double weight) {
      sum += weight * turnedC(faces[t].C, turned(faces[t], vertices[v]));
      area += weight;
    });
    if (area > 0.0) vertices[v].C = sum / area;
  };
  if (!overBlocks(faces.size(), options, 0.05, 0.25, eachOf(faceK)) ||
      !overBlocks(vertices.size(), options, 0.25, 0.5, eachOf(vertexK)) ||
      !overBlocks(faces.size(), options, 0.5, 0.75, eachOf(faceC)) ||
      !overBlocks(vertices.size(), options, 0.75, 1.0, eachOf(vertexC))) {
    return {};
  }
  // The spread of an estimate grows with the root of the passes.
  const int passes = static_cast<int>(std::lround(options.scale * options.scale - 1.0));
  for (int i = 0; i < passes; ++i) {
    if (!smooth(mesh, vertices, options)) return {};
  }

  SurfaceFields fields;
  fields.resize(vertices.size());
  fields.size = surfaceSize(mesh);
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const Forms& forms = vertices[v];
    SurfacePoint point;
    point.p = mesh.position(v).cast<double>();
    point.n = forms.n;
    point.frame = forms.frame;
    point.K << forms.K[0], forms.K[1], forms.K[1], forms.K[2];
    point.C.coefficients = {forms.C[0], forms.C[1], forms.C[2], forms.C[3]};
    fields.set(v, point);
  }
  return fields;
}

}  // namespace flatland
