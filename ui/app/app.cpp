// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/app.h"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QFontInfo>
#include <QPixmap>
#include <QSettings>
#include <QThreadPool>
#include <QTimer>
#include <QWindow>
#include <algorithm>

#include "flatland/io/atomic_file.h"
#include "flatland/io/input_error.h"
#include "ui/app/language.h"
#include "ui/app/layouts.h"
#include "ui/app/main_window.h"
#include "ui/model/paths.h"

namespace flatland::ui {

namespace {

constexpr double kSmallestFontPt = 9.0;
constexpr int kPaintTimeoutMs = 5000;
constexpr int kSurfaceTimeoutMs = 600000;  ///< a mesh of millions of triangles takes its time

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

/// Lets work that goes on beside the window (the sweep, for example) come to its end and be shown.
void waitForWork(MainWindow& window) {
  QElapsedTimer timer;
  timer.start();
  constexpr int kQuietMs = 150;
  // What work that ended during a long pass has posted is handled in the next: a pass that alone
  // is nearly as long as the quiet says nothing of it.
  constexpr int kLongPassMs = kQuietMs / 2;
  QElapsedTimer quiet;
  quiet.start();
  const SurfaceModels surface = window.surfaceModels();
  // Painting a large surface without OpenGL takes its time too.
  const int patienceMs = window.document().scene().surface ? kSurfaceTimeoutMs : kPaintTimeoutMs;
  while (quiet.elapsed() < kQuietMs && timer.elapsed() < patienceMs) {
    QElapsedTimer pass;
    pass.start();
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    const bool onSurface = surface.source.isStale() || surface.views.isStale();
    const bool works = onSurface || QThreadPool::globalInstance()->activeThreadCount() > 0;
    if (works || pass.elapsed() > kLongPassMs) quiet.restart();
  }
}

[[noreturn]] void refuse(const char* option, const std::string& name, const QStringList& known) {
  throw InputError(option, "",
                   "there is no " + name + "; there are " + known.join(", ").toStdString());
}

/// Puts on what the shot asks for; the size comes after.
void dress(MainWindow& window, const Shot& shot) {
  const auto theme = Display::themeNamed(shot.theme);
  if (!theme) refuse("--theme", shot.theme, {"system", "light", "dark", "high-contrast"});
  const auto layout = Layouts::kindNamed(QString::fromStdString(shot.layout));
  if (!layout) refuse("--layout", shot.layout, {"work", "surface", "picture", "projector"});
  const QStringList panels = window.docks().ids();
  for (const std::string& panel : shot.show) {
    if (!panels.contains(QString::fromStdString(panel))) refuse("--show", panel, panels);
  }
  window.display().setTheme(*theme);
  const bool chosen = *layout != Layouts::Kind::Work || !window.document().scene().surface;
  if (chosen) window.layouts().use(*layout);
  if (shot.scale > 0.0) window.display().setUiScale(shot.scale);
  if (!shot.pick.empty()) {
    const bool isTriangle = shot.pick.front() == 't';
    const unsigned long number = std::stoul(shot.pick.substr(shot.pick.find(':') + 1));
    window.surfaceModels().pick.pickWhenRead(isTriangle, static_cast<std::uint32_t>(number));
  }
  if (shot.probe) window.probe().setPlace(Probe::Place{shot.probe->first, shot.probe->second});
}

}  // namespace

int runWindow(int& argc, char** argv, const WindowStart& start) {
  const QApplication application(argc, argv);
  setUpApplication();
  QSettings settings;
  installLanguage(start.language.empty() ? chosenLanguage(settings)
                                         : QString::fromStdString(start.language));
  const QString name = start.scene ? QString() : presetName(presets().front());
  MainWindow window(start.scene ? *start.scene : defaultScene(), name, &settings);
  window.show();
  if (start.projector) window.layouts().use(Layouts::Kind::Projector);
  if (start.sceneFile) {
    // From the running event loop, so that a message about it finds a window to stand in.
    QTimer::singleShot(0, &window, [&] { window.files().openFile(toQString(*start.sceneFile)); });
  }
  return QApplication::exec();
}

int takeShot(int& argc, char** argv, const Shot& shot) {
  // Never on a display: the picture is then the same everywhere, and a display that is gone does no
  // harm.
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  setUpApplication();
  installLanguage(QString::fromStdString(shot.language));
  const QString name = shot.scene ? QString() : presetName(presets().front());
  MainWindow window(shot.scene ? *shot.scene : defaultScene(), name, nullptr);
  const QSize size(std::max(shot.width, 1), std::max(shot.height, 1));
  window.resize(size);
  window.show();
  waitUntilPainted(window);
  dress(window, shot);
  window.setWindowState(Qt::WindowNoState);  // the size is the one asked for, in any layout
  window.resize(size);
  waitUntilPainted(window);
  window.layouts().restoreDefault();
  for (const std::string& panel : shot.show) window.docks().show(panel.c_str());
  waitUntilPainted(window);
  window.canvas().fit();
  waitForWork(window);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (!window.grab().save(&buffer, "PNG")) {
    throw InputError(shot.output.string(), "", "no picture of this size can be made");
  }
  writeFileAtomically(shot.output,
                      std::string_view(png.constData(), static_cast<std::size_t>(png.size())));
  return 0;
}

}  // namespace flatland::ui
