// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/app.h"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QFontInfo>
#include <QPixmap>
#include <QSettings>
#include <QTimer>
#include <QWindow>
#include <algorithm>

#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "ui/app/main_window.h"
#include "ui/app/paths.h"

namespace flatland::ui {

namespace {

constexpr double kSmallestFontPt = 9.0;
constexpr int kPaintTimeoutMs = 5000;

/// What every way into the window sets up once the application object is there.
void setUpApplication() {
  QCoreApplication::setOrganizationName("flatland");
  QCoreApplication::setApplicationName("flatland");
  QCoreApplication::setApplicationVersion(FLATLAND_VERSION);
  QGuiApplication::setApplicationDisplayName("");
  QFont font = QApplication::font();
  if (QFontInfo(font).pointSizeF() < kSmallestFontPt) {
    font.setPointSizeF(kSmallestFontPt);
    QApplication::setFont(font);
  }
}

/// Lets the window lay itself out and paint.
void waitUntilPainted(QWidget& window) {
  QElapsedTimer timer;
  timer.start();
  const QWindow* handle = window.windowHandle();
  while (!handle->isExposed() && timer.elapsed() < kPaintTimeoutMs) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  // Docks settle in the events that follow.
  QCoreApplication::processEvents();
  QCoreApplication::sendPostedEvents();
}

}  // namespace

int runWindow(int& argc, char** argv, const std::optional<std::filesystem::path>& sceneFile,
              const std::optional<Scene>& scene) {
  const QApplication application(argc, argv);
  setUpApplication();
  QSettings settings;
  const QString name = scene ? QString() : presetName(presets().front());
  MainWindow window(scene ? *scene : defaultScene(), name, &settings);
  window.show();
  if (sceneFile) {
    // From the running event loop, so that a message about it finds a window to stand in.
    QTimer::singleShot(0, &window, [&] { window.files().openFile(toQString(*sceneFile)); });
  }
  return QApplication::exec();
}

int takeShot(int& argc, char** argv, const std::optional<Scene>& scene,
             const std::filesystem::path& output, int width, int height) {
  // Never on a display: the picture is then the same everywhere, and a display that is gone does no
  // harm.
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  setUpApplication();
  const QString name = scene ? QString() : presetName(presets().front());
  MainWindow window(scene ? *scene : defaultScene(), name, nullptr);
  window.resize(std::max(width, 1), std::max(height, 1));
  window.restoreDefaultLayout();
  window.show();
  waitUntilPainted(window);
  window.canvas().fit();
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (!window.grab().save(&buffer, "PNG")) {
    throw InputError(output.string(), "", "no picture of this size can be made");
  }
  writeFileAtomically(output,
                      std::string_view(png.constData(), static_cast<std::size_t>(png.size())));
  return 0;
}

}  // namespace flatland::ui
