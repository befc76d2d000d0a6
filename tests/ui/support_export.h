// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

#include "tests/ui/support_window.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"

namespace flatland::ui {

inline QByteArray textOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline void chosen(QWidget& dialog, const char* box, const QVariant& data) {
  auto* choice = dialog.findChild<QComboBox*>(box);
  choice->setCurrentIndex(choice->findData(data));
}

/// The window with a bumpy sphere, from which files are written.
class ExportDriver : public WindowDriver {
 public:
  static constexpr int kPatienceMs = 60000;  ///< estimates on a crowded machine

  /// False if the window or the surface does not come.
  bool ready() {
    if (!WindowDriver::ready()) return false;
    window().surfaces().openSolid("bumpy-sphere:20");
    return quiet() && scene().surface.has_value();
  }

  bool quiet() {
    const SurfaceModels models = window().surfaceModels();
    return QTest::qWaitFor(
        [&] { return surfaceQuiet() && !models.source.isStale() && !models.bridges.isStale(); },
        kPatienceMs);
  }

  /// False if the views do not follow.
  bool push(const SurfaceSetting& setting) {
    document().push(std::make_unique<SetSurface>(document(), setting, "edit"));
    return quiet();
  }

  /// Without dialogs.
  void exportTo(const QString& file, const PictureSize& size = {}) {
    window().surfaces().exporter().exportTo(file, size);
  }

  /// Through both dialogs, in the first of which something is set.
  void exportAs(
      const QString& suffix, const QString& file,
      const std::function<void(QWidget&)>& set = [](QWidget&) {}) {
    whenModal(
        [=](QWidget& dialog) {
          chosen(dialog, "export.format", suffix);
          set(dialog);
          typeFileName(file);
          QTest::mouseClick(dialog.findChild<QAbstractButton*>("export.go"), Qt::LeftButton);
        },
        [](QWidget& dialog) { return dialog.objectName() == "surface-export"; });
    trigger("surface.export");
  }

  /// The file when it is there; false if it does not come.
  static bool comes(const QString& file) {
    return QTest::qWaitFor([&file] { return QFile::exists(file); }, kPatienceMs);
  }
};

}  // namespace flatland::ui
