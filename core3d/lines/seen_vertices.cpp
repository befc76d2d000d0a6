// SPDX-License-Identifier: MIT
// Compiled once for each kind of processor by Highway; the one that fits is called.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core3d/lines/seen_vertices.cpp"
#include <hwy/foreach_target.h>
// After the header that compiles this file again.
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "core3d/lines/seen_vertices.h"

HWY_BEFORE_NAMESPACE();
namespace flatland {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

struct Call {
  const TriangleMesh& mesh;
  const SurfaceFields& fields;
  float towards[3];
  float eye[3];
  bool perspective;
  float minRoot;
  SeenVertices& out;
  std::uint8_t radialFlag = 0;  // where radial curvature is not computed
};

// One vector of vertices from i on. Letters as in docs/math/lines.md; everything is multiplied with
// the power of n.w that seen_vertices.h names.
template <bool kPerspective, bool kRidges, bool kRadial, class D>
HWY_INLINE void seeVector(D d, const Call& call, std::size_t i) {
  using V = hn::Vec<D>;
  const SurfaceFields& f = call.fields;
  SeenVertices& out = call.out;
  const auto load = [d, i](const std::vector<float>& values) {
    return hn::LoadU(d, values.data() + i);
  };
  const auto store = [d, i](const V& v, std::vector<float>& values) {
    hn::StoreU(v, d, values.data() + i);
  };
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);

  V wx = hn::Set(d, call.towards[0]), wy = hn::Set(d, call.towards[1]),
    wz = hn::Set(d, call.towards[2]);
  V inverseDistance = zero;
  if constexpr (kPerspective) {
    wx = hn::Sub(hn::Set(d, call.eye[0]), load(call.mesh.x));
    wy = hn::Sub(hn::Set(d, call.eye[1]), load(call.mesh.y));
    wz = hn::Sub(hn::Set(d, call.eye[2]), load(call.mesh.z));
    const V square = hn::MulAdd(wx, wx, hn::MulAdd(wy, wy, hn::Mul(wz, wz)));
    // At the viewer itself w is 0.
    inverseDistance = hn::IfThenElseZero(hn::Gt(square, zero), hn::Div(one, hn::Sqrt(square)));
    wx = hn::Mul(wx, inverseDistance);
    wy = hn::Mul(wy, inverseDistance);
    wz = hn::Mul(wz, inverseDistance);
  }

  const V nx = load(f.nx), ny = load(f.ny), nz = load(f.nz);
  const V nw = hn::MulAdd(nx, wx, hn::MulAdd(ny, wy, hn::Mul(nz, wz)));
  store(nw, out.nw);
  const hn::RebindToUnsigned<D> du;
  using U = hn::Vec<decltype(du)>;
  const auto bit = [d, du](const auto& mask, std::uint8_t flag) {
    return hn::And(hn::BitCast(du, hn::VecFromMask(d, mask)), hn::Set(du, std::uint32_t{flag}));
  };
  const auto front = hn::Gt(nw, zero);
  const V nn = hn::MulAdd(nx, nx, hn::MulAdd(ny, ny, hn::Mul(nz, nz)));
  U flags = hn::Or(bit(front, VertexFlag::kFront),
                   bit(hn::Gt(nn, hn::Set(d, kKnownNormalSq)), VertexFlag::kKnown));
  if constexpr (!kRadial) flags = hn::Or(flags, hn::Set(du, std::uint32_t{call.radialFlag}));
  if constexpr (!kRidges && !kRadial) (void)one, (void)half;

  if constexpr (kRidges || kRadial) {
    const V e1x = load(f.e1x), e1y = load(f.e1y), e1z = load(f.e1z);
    const V e2x = hn::NegMulAdd(nz, e1y, hn::Mul(ny, e1z));
    const V e2y = hn::NegMulAdd(nx, e1z, hn::Mul(nz, e1x));
    const V e2z = hn::NegMulAdd(ny, e1x, hn::Mul(nx, e1y));
    const V w1 = hn::MulAdd(e1x, wx, hn::MulAdd(e1y, wy, hn::Mul(e1z, wz)));
    const V w2 = hn::MulAdd(e2x, wx, hn::MulAdd(e2y, wy, hn::Mul(e2z, wz)));
    const V k1 = load(f.k1), k2 = load(f.k2);
    const V p1 = hn::Mul(k1, w1), p2 = hn::Mul(k2, w2);  // K w_T
    if constexpr (kRadial) {
      // Where both curvatures are positive it is 0 only by rounding or exactly head on. It counts
      // as positive there, as it does for clusters that are passed over for being convex.
      const V computed = hn::MulAdd(p1, w1, hn::Mul(p2, w2));
      const V least = hn::Set(d, std::numeric_limits<float>::min());
      const V radial = hn::IfThenElse(hn::Gt(k2, zero), hn::Max(computed, least), computed);
      store(radial, out.radial);
      flags = hn::Or(flags, bit(hn::Gt(radial, zero), VertexFlag::kRadial));
    }
    if constexpr (kRidges) {
      const V facing = hn::Abs(nw), nw2 = hn::Mul(nw, nw);
      // (n.w)^2 K G K: half its trace, and its traceless part from products and sums.
      const V mean = hn::Mul(half, hn::MulAdd(nw2, hn::MulAdd(k1, k1, hn::Mul(k2, k2)),
                                              hn::MulAdd(p1, p1, hn::Mul(p2, p2))));
      const V difference = hn::Mul(half, hn::MulAdd(hn::Mul(nw2, hn::Add(k1, k2)), hn::Sub(k1, k2),
                                                    hn::Mul(hn::Sub(p1, p2), hn::Add(p1, p2))));
      const V mixed = hn::Mul(p1, p2);
      const V radius = hn::Sqrt(hn::MulAdd(difference, difference, hn::Mul(mixed, mixed)));
      const V lambda = hn::Add(mean, radius);
      const V root = hn::Sqrt(lambda);
      // Of the two proportional eigenvectors the longer one; (1, 0) where both vanish.
      const V main = hn::Add(radius, hn::Abs(difference));
      const V length = hn::Sqrt(hn::MulAdd(main, main, hn::Mul(mixed, mixed)));
      const auto turned = hn::Gt(length, zero);
      const V inverseLength = hn::Div(one, hn::IfThenElse(turned, length, one));
      const V large = hn::IfThenElse(turned, hn::Mul(main, inverseLength), one);
      const V small = hn::Mul(mixed, inverseLength);
      const auto first = hn::Ge(difference, zero);
      const V v1 = hn::IfThenElse(first, large, small), v2 = hn::IfThenElse(first, small, large);

      const V kv1 = hn::Mul(k1, v1), kv2 = hn::Mul(k2, v2);
      const V along = hn::MulAdd(w1, kv1, hn::Mul(w2, kv2));
      const V inverseRoot = hn::IfThenElseZero(hn::Gt(root, zero), hn::Div(one, root));
      const V r1 = hn::Mul(hn::MulAdd(nw2, kv1, hn::Mul(w1, along)), inverseRoot);
      const V r2 = hn::Mul(hn::MulAdd(nw2, kv2, hn::Mul(w2, along)), inverseRoot);

      // C(r, r, v) = r1^2 (C111 v1 + C112 v2) + 2 r1 r2 (C112 v1 + C122 v2) + r2^2 (...).
      const V c112 = load(f.c112), c122 = load(f.c122);
      const V c11 = hn::MulAdd(load(f.c111), v1, hn::Mul(c112, v2));
      const V c12 = hn::MulAdd(c112, v1, hn::Mul(c122, v2));
      const V c22 = hn::MulAdd(c122, v1, hn::Mul(load(f.c222), v2));
      const V r11 = hn::Mul(r1, r1), r12 = hn::Mul(hn::Add(r1, r1), r2), r22 = hn::Mul(r2, r2);
      const V cubic = hn::MulAdd(r11, c11, hn::MulAdd(r12, c12, hn::Mul(r22, c22)));
      const V feature = hn::Mul(hn::Mul(facing, root), cubic);
      const V rv = hn::MulAdd(r1, v1, hn::Mul(r2, v2));
      const V vp = hn::MulAdd(v1, p1, hn::Mul(v2, p2));
      const V sideOfViewer = hn::CopySign(one, nw);
      V sum = hn::NegMulAdd(hn::Mul(sideOfViewer, lambda), hn::Mul(rv, vp), feature);
      if constexpr (kPerspective) {
        const V wr = hn::MulAdd(w1, r1, hn::Mul(w2, r2));
        sum = hn::NegMulAdd(hn::Mul(facing, lambda), hn::Mul(wr, inverseDistance), sum);
      }
      // Not a number, or infinite: nothing is known here.
      const auto sound =
          hn::And(hn::Lt(hn::Abs(sum), hn::Set(d, 1e37f)), hn::Lt(lambda, hn::Set(d, 1e37f)));
      const V sign = hn::IfThenElseZero(sound, hn::CopySign(one, sum));
      const V s1 = hn::Mul(hn::IfThenElseZero(sound, r1), sign),
              s2 = hn::Mul(hn::IfThenElseZero(sound, r2), sign);
      const V rx = hn::MulAdd(s1, e1x, hn::Mul(s2, e2x)),
              ry = hn::MulAdd(s1, e1y, hn::Mul(s2, e2y)),
              rz = hn::MulAdd(s1, e1z, hn::Mul(s2, e2z));
      const V soundRoot = hn::IfThenElseZero(sound, root);
      store(soundRoot, out.root);
      store(hn::IfThenElseZero(sound, hn::Abs(sum)), out.slope);
      store(rx, out.rx);
      store(ry, out.ry);
      store(rz, out.rz);
      flags = hn::Or(flags, hn::Or(bit(hn::Gt(rx, zero), 1),
                                   hn::Or(bit(hn::Gt(ry, zero), 2), bit(hn::Gt(rz, zero), 4))));
      flags = hn::Or(flags, bit(hn::Ge(soundRoot, hn::Mul(hn::Set(d, call.minRoot), facing)),
                                VertexFlag::kStrong));
    }
  }
  const hn::Rebind<std::uint8_t, D> d8;
  const hn::RebindToSigned<D> ds;
  hn::StoreU(hn::DemoteTo(d8, hn::BitCast(ds, flags)), d8, out.flags.data() + i);
}

template <bool kPerspective, bool kRidges, bool kRadial>
void seeRun(const Call& call, std::size_t begin, std::size_t end) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = begin;
  for (; i + lanes <= end; i += lanes) seeVector<kPerspective, kRidges, kRadial>(d, call, i);
  if (i == end) return;
  if (call.fields.vertexCount() >= lanes) {
    // The last vector reaches back over vertices that are done, or that lie before the run: what it
    // writes there is what belongs there.
    const std::size_t back = end >= lanes ? end - lanes : 0;
    seeVector<kPerspective, kRidges, kRadial>(d, call, back);
    return;
  }
  const hn::CappedTag<float, 1> single;
  for (; i < end; ++i) seeVector<kPerspective, kRidges, kRadial>(single, call, i);
}

void seeRuns(Call call, std::span<const VertexRun> runs) {
  using Run = void (*)(const Call&, std::size_t, std::size_t);
  constexpr Run kRuns[2][2][2] = {{{seeRun<false, false, false>, seeRun<false, false, true>},
                                   {seeRun<false, true, false>, seeRun<false, true, true>}},
                                  {{seeRun<true, false, false>, seeRun<true, false, true>},
                                   {seeRun<true, true, false>, seeRun<true, true, true>}}};
  for (const VertexRun& run : runs) {
    if (run.nw || run.ridges || run.radial) {
      call.radialFlag = run.flags & VertexFlag::kRadial;
      kRuns[call.perspective][run.ridges][run.radial](call, run.begin, run.end);
    } else {
      std::fill(call.out.flags.begin() + run.begin, call.out.flags.begin() + run.end, run.flags);
    }
  }
}

void seeAll(const TriangleMesh& mesh, const SurfaceFields& fields, const SurfaceView& view,
            float minRoot, std::span<const VertexRun> runs, SeenVertices& out) {
  const auto single = [](double x) { return static_cast<float>(x); };
  const Eigen::Vector3d eye = view.eye.value_or(Eigen::Vector3d::Zero());
  const Call call{mesh,
                  fields,
                  {single(view.towards.x()), single(view.towards.y()), single(view.towards.z())},
                  {single(eye.x()), single(eye.y()), single(eye.z())},
                  view.eye.has_value(),
                  minRoot,
                  out};
  seeRuns(call, runs);
}

}  // namespace HWY_NAMESPACE
}  // namespace flatland
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace flatland {

HWY_EXPORT(seeAll);

void seeVertices(const TriangleMesh& mesh, const SurfaceFields& fields, const SurfaceView& view,
                 float minRoot, std::span<const VertexRun> runs, SeenVertices& out) {
  HWY_DYNAMIC_DISPATCH(seeAll)(mesh, fields, view, minRoot, runs, out);
}

void SeenVertices::resize(std::size_t vertices, const VertexNeeds& needs) {
  flags.resize(vertices);
  nw.resize(vertices);
  if (needs.ridges) {
    for (auto* values : {&root, &slope, &rx, &ry, &rz}) values->resize(vertices);
  }
  if (needs.radial) radial.resize(vertices);
}

}  // namespace flatland
#endif
