// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMap>
#include <QObject>
#include <QRect>
#include <optional>

class QMainWindow;
class QSettings;
class QToolBar;
class QToolButton;

namespace flatland::ui {

class Display;
class Docks;

/// The arrangements of the window. Each keeps what the person makes of it: which panels are open,
/// where, and how large.
class Layouts : public QObject {
  Q_OBJECT

 public:
  enum class Kind {
    Work,       ///< every panel of flatland
    Surface,    ///< the surface large, the canvas beside it, what belongs to the surface
    Picture,    ///< the pictures alone, with what an export needs in a tool bar
    Projector,  ///< full screen, large type, the pictures and one panel
  };

  /// `pictureBar` is shown in the layout for pictures only, `surface` in that for surfaces and, if
  /// there is one, in those for pictures and the projector.
  Layouts(QMainWindow& window, Docks& docks, Display& display, QToolBar& pictureBar,
          QWidget& surface);

  /// "work", "surface", "picture", "projector"
  static std::optional<Kind> kindNamed(const QString& name);

  Kind current() const { return current_; }

  /// Whether the scene has a surface.
  void setSurfaceThere(bool there);
  /// Whether a surface, if there is one, is seen in the current layout.
  bool showsSurfaces() const { return current_ != Kind::Work; }

  /// Whether the curves are seen beside a surface; where there is none they are always.
  bool showsFlatBeside() const { return flatBeside_; }
  void setFlatBeside(bool shows);

  /// While a lesson is given a layout has another arrangement, for as long as the lesson lasts: the
  /// strip, and with a surface or on the wall the panel of the step and no other. That of all
  /// panels stays as the person has it, with the strip. Then the layout there was before, its
  /// arrangement and whether it had the curves beside the surface come back; the projector stays if
  /// it is on.
  void beginLesson();
  void endLesson();
  /// The panel that the step of the lesson speaks of, in front in every layout; empty: none. The
  /// one of the step before goes.
  void setLessonPanel(const QString& id);

  /// Leaves the arrangement there is as it is, for the next time, and takes that of `kind` as it
  /// was left. Leaving the projector brings back size and place of the window too.
  void use(Kind kind);

  /// Into projector mode, or out of it to the layout there was before.
  void toggleProjector();

  /// The current layout as on the first day.
  void restoreDefault();

  /// Arrangements that cannot be read (of another version, or damaged) count as not saved. The
  /// projector is not restored: a window that fills the screen at the start would be a surprise.
  void restore(const QSettings& settings);
  void save(QSettings& settings) const;

 signals:
  void changed();
  void entered();  ///< after changed(): the panels were arranged anew, and not for a lesson's sake

 private:
  void enter(Kind kind);
  void arrange();
  void arrangeForLesson();
  void showLessonPanel();
  void showParts();
  QMap<Kind, QByteArray>& states() { return own_ ? lessonStates_ : states_; }

  QMainWindow& window_;
  Docks& docks_;
  Display& display_;
  QToolBar& pictureBar_;
  QWidget& surface_;
  QToolButton* leave_;  ///< says, in projector mode, how to leave it
  Kind current_ = Kind::Work;
  Kind beforeProjector_ = Kind::Work;
  bool surfaceThere_ = false;
  bool emptyWanted_ = false;  ///< the place of a surface is shown without one
  bool flatBeside_ = true;
  QByteArray geometry_;  ///< of the window before projector mode, for the settings
  QRect place_;
  Qt::WindowStates windowState_;
  QMap<Kind, QByteArray> states_;

  struct Own {
    Kind current, beforeProjector;
    bool flatBeside, emptyWanted;
  };
  std::optional<Own> own_;  ///< the person's, while a lesson is given
  QMap<Kind, QByteArray> lessonStates_;
  QString lessonPanel_;
  QStringList lessonOpened_;  ///< what steps have opened
};

}  // namespace flatland::ui
