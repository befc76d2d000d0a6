// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "ui/model/bridge_source.h"

namespace flatland::ui {

/// Ends of pieces of a line on the surface, two in a row a piece, for all who draw it.
using LineEnds = std::shared_ptr<const std::vector<LineVertex>>;

/// The predicted lines as dashes along the surface. They are made once for each prediction, however
/// often and in however many views they are painted.
class PredictedDashes {
 public:
  /// Of each of view->prediction.lines(). Valid until the next call. Precondition: not null.
  const std::vector<LineEnds>& of(const std::shared_ptr<const BridgeView>& view);

 private:
  std::shared_ptr<const BridgeView> view_;
  std::vector<LineEnds> dashes_;
};

}  // namespace flatland::ui
