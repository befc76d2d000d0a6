// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core3d/study/bridge.h"
#include "ui/jobs/latest_job.h"
#include "ui/model/seen_surface.h"

namespace flatland::ui {

/// What flatland predicts of a swept surface, beside the lines found on its mesh in one view.
struct BridgeView {
  std::shared_ptr<const SeenSurface> seen;
  BridgePrediction prediction;
  std::vector<BridgeLimit> limits;  ///< of prediction.lines()
  BridgeRow row;                    ///< how both agree; its cells are those of the mesh
};

/// The prediction for what is seen of a swept surface. Made beside the window's thread after each
/// search for lines, the newest there is, so it follows a moving curve or camera.
class BridgeSource : public QObject {
  Q_OBJECT

 public:
  explicit BridgeSource(const SeenSource& seen, QObject* parent = nullptr);

  /// Null unless the surface is swept and its lines were looked for.
  const std::shared_ptr<const BridgeView>& view() const { return view_; }
  bool isStale() const { return job_.isStale(); }

  /// Whether the predicted lines are drawn on the surface; at first they are.
  bool isShown() const { return shown_; }
  void setShown(bool shown);

 signals:
  void changed();
  void failed(const QString& reason);

 private:
  void follow();
  void predict();

  const SeenSource& seen_;
  LatestJob job_;
  std::shared_ptr<const BridgeView> view_;
  bool shown_ = true;
};

}  // namespace flatland::ui
