// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "ui/model/bridges.h"
#include "ui/view3d/surface_models.h"

class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QTableWidget;

namespace flatland::ui {

/// The plane that cuts the surface, in numbers; its section, to be opened as curves; and where the
/// section's apparent ridges and the surface's differ, and why.
class SectionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SectionPanel(const SurfaceModels& models, QWidget* parent = nullptr);

  /// Puts the plane through the view: through the picked point, or the middle of the picture.
  void cutAlongView();
  /// Puts it along t_A at the picked point; said() tells why that cannot be.
  void cutAlongRidge();
  void removePlane();
  void openAsCurve();

 protected:
  void changeEvent(QEvent* event) override;

 signals:
  /// For the status line.
  void said(const QString& text);
  void curvesOpened();

 private:
  QWidget* makePresets();
  void addFields(QFormLayout& form);
  QDoubleSpinBox* addField(QFormLayout& form, const char* id, const QString& name,
                           const QString& tip);
  void showPlane();
  void showSection();
  void showTable();
  void showSentence();
  /// Room for what may come, so that nothing moves when it does.
  void reserveLines();
  /// Below what the view asks of apparent ridges, which scans have many of.
  bool isWeak(const SectionPair& pair) const;
  void setPlane(const std::optional<SurfacePlane>& plane, const QString& text);
  void typed();

  SurfaceModels models_;
  QPushButton* alongView_ = nullptr;
  QPushButton* alongRidge_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* open_ = nullptr;
  QDoubleSpinBox* azimuth_ = nullptr;
  QDoubleSpinBox* elevation_ = nullptr;
  QDoubleSpinBox* height_ = nullptr;
  QDoubleSpinBox* tolerance_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* weaker_ = nullptr;
  QTableWidget* table_ = nullptr;
  std::vector<std::size_t> rows_;  ///< indices of the pairs that are listed
  QLabel* sentence_ = nullptr;
};

}  // namespace flatland::ui
