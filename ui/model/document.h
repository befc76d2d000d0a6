// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "flatland/features/features.h"
#include "flatland/features/printed_roots.h"
#include "flatland/scene/scene.h"
#include "flatland/screen/visibility.h"

namespace flatland::ui {

/// Which curves have left the list, or come back into it; all others keep their order.
struct CurveShift {
  std::vector<std::size_t> curves = {};  ///< their indices in the longer list, rising
  bool removed = true;                   ///< false: they came back

  /// Where the curve is that was at an index before; nullopt if it has left.
  std::optional<std::size_t> after(std::size_t before) const;
  CurveShift back() const { return {curves, !removed}; }
};

/// What a change of the document touched, so that a view updates only what it shows of it.
struct Change {
  enum class What {
    Points,    ///< points moved or a normal flipped; as many curves and points as before
    Topology,  ///< curves or points came or went
    View,      ///< the direction or distance of the viewer
    Scene,     ///< another scene altogether, surface and its camera included
    Surface,   ///< which surface there is beside the curves, or how it is drawn
    Camera,    ///< only from where the surface is seen
    File,      ///< only the name of the file
  };
  What what;
  CurveShift shift = {};    ///< with Topology: who keeps an index of a curve goes along
  bool surfaceToo = false;  ///< with Topology: a swept surface came or went with its curve

  /// True if curves or their view are others.
  bool touchesScene() const { return what < What::Surface; }
  bool touchesSurface() const { return what == What::Surface || what == What::Scene || surfaceToo; }
};

/// The scene being edited, its marks, its file and its undo stack: the one place where they live.
/// Reading is open to all; the scene changes through commands (ui/commands) only, and each of them
/// sends `changed` exactly once.
class Document : public QObject {
  Q_OBJECT

 public:
  Document(Scene scene, const QString& originName, QObject* parent = nullptr);

  const Scene& scene() const { return scene_; }

  /// The marks of the scene. Computed at the first call after a change and kept until the next.
  const FeatureSet& features() const;

  /// The roots of (3.13) as printed; computed and kept likewise.
  const PrintedRoots& printedRoots() const;

  /// What of the scene can be seen; computed and kept likewise.
  const Visibility& visibility() const;

  /// How long the last computation of the marks took, in milliseconds, and how many there were.
  double featureMilliseconds() const { return featureMilliseconds_; }
  int featureComputations() const { return featureComputations_; }

  QUndoStack& undoStack() { return undoStack_; }
  /// True if something would be lost: a file is not up to date, or a scene that never had one has
  /// work in it, or had, which only undoing brings back (unsaved_work.h).
  bool isModified() const { return isUnsaved(scene_, undoStack_.index()); }
  /// The same for the scene there was at another place of the undo stack.
  bool isUnsaved(const Scene& scene, int undoIndex) const;
  /// The scene as it was started, opened or last saved.
  const Scene& saved() const { return saved_; }

  /// Does a command: the one way to edit. One that is obsolete from the start, because it would
  /// change nothing, is dropped without a trace: no signal, and what was undone can still be
  /// redone.
  void push(std::unique_ptr<QUndoCommand> command);

  /// The file the scene came from or was last saved to; empty for a new one.
  const std::filesystem::path& file() const { return file_; }

  /// The scene as it was started or opened: what Reset goes back to.
  const Scene& origin() const { return origin_; }
  /// What a person calls it: the preset's name; empty for a scene from a file.
  const QString& originName() const { return originName_; }

  /// Starts over with an unnamed scene; undo steps are forgotten.
  void start(Scene scene, const QString& originName);

  /// Replaces the scene by that of a file; undo steps are forgotten. Throws InputError, and then
  /// nothing has changed.
  void open(const std::filesystem::path& file);

  /// Saves atomically and takes on the file's name. Throws InputError, and then nothing has
  /// changed.
  void save(const std::filesystem::path& file);

  /// A number no other gesture of this document has; commands with the same one become one step.
  int newGesture() { return ++lastGesture_; }

  // For the commands. Each exchanges the argument with what the document holds, so doing it
  // twice restores both, and sends `changed` once.

  void swapCurves(std::vector<SceneCurve>& curves);
  /// The same where whole curves leave or come back. A surface that is swept from another curve
  /// stays with that; one that is swept from a curve that leaves goes into `swept`, and comes back
  /// from there.
  void swapCurves(std::vector<SceneCurve>& curves, const CurveShift& shift,
                  std::optional<SurfaceSetting>& swept);
  void swapScene(Scene& scene);
  /// As long as the mesh stays, and which of its axes is upward, so do the cameras: looking from
  /// elsewhere is no edit.
  void swapSurface(std::optional<SurfaceSetting>& surface);

  /// Looks at the curves from elsewhere: no edit by itself, as setCamera() is none; SetView makes a
  /// step of it.
  void setView(const View& view);

  /// Looks at the surface from elsewhere, in one of its views: where that has no camera of its own,
  /// in all that have none. No edit: not undone, and alone no reason to save. Precondition: there
  /// is a surface, and such a view.
  void setCamera(const SurfaceCamera& camera, std::size_t pane = 0);

 signals:
  void changed(const flatland::ui::Change& change);

 private:
  void replace(Scene scene, const QString& originName, std::filesystem::path file);
  void sceneChanged(const Change& change);

  Scene scene_;
  Scene origin_;
  Scene saved_;
  QString originName_;
  QUndoStack undoStack_;
  std::filesystem::path file_;
  int lastGesture_ = 0;
  mutable std::optional<FeatureSet> features_;
  mutable std::optional<PrintedRoots> printedRoots_;
  mutable std::optional<Visibility> visibility_;
  mutable double featureMilliseconds_ = 0.0;
  mutable int featureComputations_ = 0;
};

}  // namespace flatland::ui
