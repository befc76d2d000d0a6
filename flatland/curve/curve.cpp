// SPDX-License-Identifier: MIT
#include "flatland/curve/curve.h"

namespace flatland {

int pieceCount(const Curve& curve) {
  return std::visit([](const auto& kind) { return kind.pieceCount(); }, curve);
}

bool isClosed(const Curve& curve) {
  return std::visit([](const auto& kind) { return kind.closed(); }, curve);
}

Jet jetAt(const Curve& curve, double t) {
  return std::visit([t](const auto& kind) { return jetAt(kind, t); }, curve);
}

Jet jetAt(const Curve& curve, int piece, double t) {
  return std::visit([piece, t](const auto& kind) { return jetAt(kind.piece(piece), t); }, curve);
}

Vec2 pointAt(const Curve& curve, double t) {
  return std::visit([t](const auto& kind) { return pointAt(kind, t); }, curve);
}

ArcLength arcLength(const Curve& curve, double t0, double t1, double accuracy) {
  return std::visit([=](const auto& kind) { return arcLength(kind, t0, t1, accuracy); }, curve);
}

const std::vector<Vec2>& controlPoints(const Curve& curve) {
  return std::visit([](const auto& kind) -> const std::vector<Vec2>& { return kind.points(); },
                    curve);
}

Nearest nearestPoint(const Curve& curve, const Vec2& p) {
  return std::visit([&p](const auto& kind) { return nearestPoint(kind, p); }, curve);
}

}  // namespace flatland
