// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "core3d/study/bridge.h"
#include "ui/jobs/job.h"
#include "ui/model/bridge_source.h"
#include "ui/model/display.h"
#include "ui/model/document.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace flatland::ui {

/// A study of one swept surface in one view.
struct BridgeStudyData {
  Scene scene;
  std::vector<BridgeSeries> series;
};

/// How the distance between predicted and extracted ridges falls with the resolution of the mesh,
/// for each estimator and derivative: started by a button, with a diagram and its export.
class BridgeStudy : public QWidget {
  Q_OBJECT

 public:
  BridgeStudy(const Document& document, const BridgeSource& bridge, const Display& display,
              QWidget* parent = nullptr);

  const std::shared_ptr<const BridgeStudyData>& data() const { return data_; }
  bool isRunning() const { return job_.isRunning(); }

 signals:
  /// For the status line.
  void said(const QString& text);

 private:
  /// Whether there is a study, and of the sweep there is now.
  bool isOfThisSweep() const;
  void start();
  void showState();
  void exportDiagram();

  const Document& document_;
  const BridgeSource& bridge_;
  Job job_;
  std::shared_ptr<const BridgeStudyData> data_;
  QPushButton* run_;
  QPushButton* export_;
  QProgressBar* progress_;
  QLabel* old_;  ///< says that the curve or the view was another
  class Diagram;
  Diagram* diagram_;
};

}  // namespace flatland::ui
