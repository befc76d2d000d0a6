// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <functional>
#include <memory>

#include "ui/app/main_window.h"

namespace flatland::ui {

/// Counts events of one type that a widget receives.
class EventCounter : public QObject {
 public:
  EventCounter(QObject& watched, QEvent::Type type) : type_(type) {
    watched.installEventFilter(this);
  }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == type_) ++count_;
    return false;
  }
  int count() const { return count_; }

 private:
  QEvent::Type type_;
  int count_ = 0;
};

/// The real window with settings of its own, driven as a person would: by mouse and keys.
class WindowDriver {
 public:
  WindowDriver()
      : settings_(directory_.filePath("settings.ini"), QSettings::IniFormat),
        window_(std::make_unique<MainWindow>(defaultScene(), "preset", &settings_)) {
    window_->show();
    window_->activateWindow();
    ready_ = QTest::qWaitForWindowActive(window_.get());
    settle();
  }

  bool ready() const { return ready_; }
  MainWindow& window() { return *window_; }
  Document& document() { return window_->document(); }
  FlatCanvas& canvas() { return window_->canvas(); }
  const Scene& scene() { return document().scene(); }
  const BezierChain& chain(std::size_t curve = 0) { return scene().curves.at(curve).chain(); }
  QSettings& settings() { return settings_; }
  QString path(const QString& name) const { return directory_.filePath(name); }

  /// Lets everything queued happen, paints included.
  void settle() {
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }

  /// Waits until nothing of the surface is read or looked for any more, a minute at most: estimates
  /// take long on a crowded machine.
  bool surfaceQuiet() {
    settle();
    const SurfaceModels models = window_->surfaceModels();
    const bool done = QTest::qWaitFor(
        [&models] { return !models.source.isBusy() && !models.views.isStale(); }, 60000);
    settle();
    return done;
  }

  QPoint at(const Vec2& world) { return window_->viewport().toWidget(world).toPoint(); }
  QPoint atPoint(std::size_t index) { return at(chain().points().at(index)); }
  QPoint atHandle() { return at(window_->stage().handle()); }
  /// A place of the canvas where nothing is.
  QPoint nowhere() { return {12, canvas().height() - 12}; }

  void press(const QPoint& p, Qt::KeyboardModifiers keys = {}, Qt::MouseButton b = Qt::LeftButton) {
    QTest::mousePress(&canvas(), b, keys, p);
  }
  void move(const QPoint& p, Qt::KeyboardModifiers keys = {}, Qt::MouseButton b = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, p, canvas().mapToGlobal(p), Qt::NoButton, b, keys);
    QCoreApplication::sendEvent(&canvas(), &event);
  }
  void release(const QPoint& p, Qt::KeyboardModifiers keys = {},
               Qt::MouseButton b = Qt::LeftButton) {
    QTest::mouseRelease(&canvas(), b, keys, p);
    settle();
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {},
            Qt::MouseButton b = Qt::LeftButton) {
    press(from, keys, b);
    for (int i = 1; i <= 4; ++i) {
      move(from + (to - from) * i / 4, keys, b);
      settle();
    }
    release(to, keys, b);
  }
  void click(const QPoint& p, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(&canvas(), Qt::LeftButton, keys, p);
    settle();
  }
  void key(Qt::Key k, Qt::KeyboardModifiers keys = {}) {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : &canvas(), k, keys);
    settle();
  }
  /// Puts the focus on the canvas and presses there. Shortcuts need an active window, which it may
  /// not be yet where a dialog has just closed.
  void canvasKey(Qt::Key k, Qt::KeyboardModifiers keys = {}) {
    window_->activateWindow();
    if (!QTest::qWaitForWindowActive(window_.get())) qFatal("the window does not become active");
    canvas().setFocus();
    key(k, keys);
  }

  template <class T>
  T& child(const char* name) {
    T* found = window_->findChild<T*>(name);
    if (!found) qFatal("no child %s", name);
    return *found;
  }
  void trigger(const char* action) {
    child<QAction>(action).trigger();
    settle();
  }

 private:
  QTemporaryDir directory_;
  QSettings settings_;
  std::unique_ptr<MainWindow> window_;
  bool ready_ = false;
};

/// Waits for the dialog that the next action opens, and that is `wanted`, and deals with it once.
/// The action's own event loop runs meanwhile.
template <class Deal>
void whenModal(
    Deal deal, const std::function<bool(QWidget&)>& wanted = [](QWidget&) { return true; }) {
  auto* timer = new QTimer(qApp);
  timer->setInterval(20);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, deal, wanted] {
    QWidget* modal = QApplication::activeModalWidget();
    if (!modal || !modal->isVisible() || !wanted(*modal)) return;
    timer->stop();
    timer->deleteLater();
    deal(*modal);
  });
  timer->start();
}

/// Types a name into the file dialog that the next action opens, and accepts; before that, what
/// happens while the dialog is open.
inline void typeFileName(const QString& name, const std::function<void()>& meanwhile = {}) {
  whenModal(
      [name, meanwhile](QWidget& dialog) {
        if (meanwhile) meanwhile();
        auto* edit = dialog.findChild<QLineEdit*>("fileNameEdit");
        QVERIFY(edit);
        edit->setText(name);  // keys would open the list of completions, which takes Return
        const auto* buttons = dialog.findChild<QDialogButtonBox*>();
        for (QAbstractButton* button : buttons->buttons()) {
          if (buttons->buttonRole(button) != QDialogButtonBox::AcceptRole) continue;
          QTest::mouseClick(button, Qt::LeftButton);
          return;
        }
        QFAIL("no button to accept with");
      },
      [](QWidget& dialog) { return dialog.findChild<QLineEdit*>("fileNameEdit") != nullptr; });
}

}  // namespace flatland::ui
