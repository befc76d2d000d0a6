// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/qt_parts.h"

#include <QGuiApplication>
#include <QtGlobal>
#include <cstdio>
#include <cstdlib>

#include "ui/app/app.h"
#include "ui/export/figure_qt.h"
#include "ui/import/glyph.h"

namespace flatland::ui {

namespace {

constexpr char kPlatform[] = "QT_QPA_PLATFORM";

/// The arguments Qt gets to see: the program's name only, since the rest was read before.
struct QtArguments {
  std::string name = "flatland";
  int argc = 1;
  char* argv[2] = {name.data(), nullptr};
};

/// Passes Qt's messages on, but for two that are true of every run without a desktop and tell a
/// person nothing.
void passMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
  for (const char* noise : {"QStandardPaths: XDG_RUNTIME_DIR not set",
                            "This plugin does not support propagateSizeHints"}) {
    if (message.startsWith(QLatin1String(noise))) return;
  }
  std::fprintf(stderr, "flatland: %s\n", qPrintable(message));
  if (type == QtFatalMsg) std::abort();
}

/// Fonts need a QGuiApplication, but a file needs no display, nor should a broken one stop it. What
/// comes afterwards chooses its own platform.
template <class Make>
auto withoutDisplay(const Make& make) {
  qInstallMessageHandler(passMessage);
  const bool isSet = qEnvironmentVariableIsSet(kPlatform);
  const QByteArray before = qgetenv(kPlatform);
  qputenv(kPlatform, "offscreen");
  QtArguments arguments;
  const QGuiApplication application(arguments.argc, arguments.argv);
  if (isSet) {
    qputenv(kPlatform, before);
  } else {
    qunsetenv(kPlatform);
  }
  return make();
}

}  // namespace

void requireQt(const std::string&, const std::string&) {}

ImportedScene glyphWithQt(const std::string& argument) {
  return withoutDisplay([&] { return glyphScene(glyphNamed(argument)); });
}

std::string pdfWithQt(const Figure& figure, const FigureSource& source) {
  return withoutDisplay([&] { return figureToPdf(figure, source); });
}

std::string pngWithQt(const Figure& figure, const FigureSource& source, double dpi) {
  return withoutDisplay([&] { return figureToPng(figure, source, dpi); });
}

int windowWithQt(const WindowStart& start) {
  QtArguments arguments;
  return runWindow(arguments.argc, arguments.argv, start);
}

int shotWithQt(const Shot& shot) {
  qInstallMessageHandler(passMessage);
  QtArguments arguments;
  return takeShot(arguments.argc, arguments.argv, shot);
}

}  // namespace flatland::ui
