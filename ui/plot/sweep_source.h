// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "flatland/screen/sweep_visibility.h"
#include "ui/jobs/job.h"
#include "ui/model/document.h"

namespace flatland::ui {

/// A sweep and the scene it is of.
struct SweepData {
  Scene scene;
  Sweep sweep;
  std::vector<double> lengths;                ///< of the curves
  std::optional<SweepVisibility> visibility;  ///< comes a little later

  /// Arc length at a parameter, and the parameter at an arc length (to 1e-9 of the scene's size).
  double lengthAt(int curve, double t) const;
  double parameterAt(int curve, double u) const;
};

/// The sweep of the document, computed beside the window's thread. The last one stays until the
/// next is there.
class SweepSource : public QObject {
  Q_OBJECT

 public:
  explicit SweepSource(const Document& document, QObject* parent = nullptr);

  /// Null until the first one is there.
  const std::shared_ptr<const SweepData>& data() const { return data_; }

  /// True while data() is of an earlier scene, or what is hidden in it is not known yet.
  bool isStale() const { return job_.isRunning() || waiting_; }

  /// Nothing is computed while nobody looks.
  void setActive(bool active);

 signals:
  void changed();
  void failed(const QString& reason);

 private:
  void follow(const Change& change);
  void start();

  const Document& document_;
  Job job_;
  std::shared_ptr<const SweepData> data_;
  Scene started_;  ///< of the last start
  bool active_ = false;
  bool waiting_ = true;  ///< the scene has changed since the last start
};

}  // namespace flatland::ui
