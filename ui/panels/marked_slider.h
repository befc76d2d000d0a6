// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>
#include <optional>

namespace flatland::ui {

/// A slider with one place marked by a small triangle: where something happens.
class MarkedSlider : public QSlider {
  Q_OBJECT

 public:
  explicit MarkedSlider(QWidget* parent = nullptr);

  /// The slider value to mark; nullopt, or one out of range, for none.
  void setMark(std::optional<int> value);
  std::optional<int> mark() const { return mark_; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<int> mark_;
};

}  // namespace flatland::ui
