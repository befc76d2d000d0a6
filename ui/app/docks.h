// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QMainWindow>

class QDockWidget;

namespace flatland::ui {

/// The panels of the window in their docks: where each belongs, and how they are arranged.
class Docks {
 public:
  /// Where a panel has its place. Panels of one group are tabs on each other, in order of adding,
  /// but those of Top stand one below the other.
  enum class Group {
    Top,     ///< right, small, always seen
    Side,    ///< right
    Plots,   ///< right, below
    Bottom,  ///< below the canvas
  };

  explicit Docks(QMainWindow& window) : window_(window) {}
  Docks(const Docks&) = delete;
  Docks& operator=(const Docks&) = delete;

  /// The docks with their panels go before the models that the panels look at.
  ~Docks();

  /// Puts the panel, whose owner the dock becomes, into a dock named `id`. It names the dock in
  /// saved layouts and in the View menu.
  void add(const char* id, const QString& title, QWidget* panel, Group group);

  const QList<QDockWidget*>& all() const { return all_; }
  QStringList ids() const;

  /// Every panel but these open and in its place, the first of each group in front.
  void arrangeBut(const QStringList& closed);

  /// Only these panels, by id, each in its place; all others closed.
  void arrangeOnly(const QStringList& ids);

  /// How much larger than usual type is: the column at the right is as much wider, up to a third of
  /// the window, when it is arranged.
  void setScale(double scale) { scale_ = scale; }

  /// Whether that column has the equations of a lesson: it is wider, and up to two fifths.
  void setEquations(bool there) { equations_ = there; }

  /// Opens the panel and brings it to the front. One below the column at the right gets as much of
  /// it as it needs, but no more than half.
  void show(const char* id);

  /// Its panel this many pixels high, but its row less than half of the window; open or not.
  void setHeight(const char* id, int height);

  void hide(const char* id);

  /// What stands above the panel, for as long as it has more to say than its name; empty: its name.
  /// Menus keep the name.
  void setHeading(const char* id, const QString& heading);

 private:
  QList<QDockWidget*> inGroup(Group group) const;
  void makeRoom(QDockWidget& dock);

  QMainWindow& window_;
  QList<QDockWidget*> all_;
  QList<Group> groups_;  ///< of all_
  double scale_ = 1.0;
  bool equations_ = false;
};

}  // namespace flatland::ui
