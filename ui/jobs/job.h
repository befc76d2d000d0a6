// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace flatland::ui {

/// What the work of a job sees of the job. Safe to use from the work's thread; copies share state.
class JobControl {
 public:
  /// True once nobody wants the result any more. Work asks this often and then returns.
  bool isCancelled() const;

  /// How much is done, in [0, 1]; shown at most some thirty times a second.
  void setProgress(double share) const;

  /// Runs `show` on the thread of the job, for a value that is ready before the end. Dropped if
  /// the job was cancelled or started anew meanwhile.
  void deliver(std::function<void()> show) const;

 private:
  friend class Job;
  struct State;
  explicit JobControl(std::shared_ptr<State> state) : state_(std::move(state)) {}

  std::shared_ptr<State> state_;
};

/// Long work off the thread of the window: a value goes in (captured by copy), a value comes out.
/// The newest start wins: one that is still running is cancelled and its result dropped. A job that
/// is destroyed cancels its work and does not wait for it, so work must not refer to widgets or the
/// document; nothing is signalled or delivered afterwards.
class Job : public QObject {
  Q_OBJECT

 public:
  explicit Job(QObject* parent = nullptr);
  ~Job() override;

  /// Starts `work` on a thread of the pool and hands what it returns to `done` on this thread; no
  /// value (nullopt) is no result. An exception of the work is told by failed().
  template <class Value>
  void start(std::function<std::optional<Value>(const JobControl&)> work,
             std::function<void(const Value&)> done) {
    run([work = std::move(work), done = std::move(done)](const JobControl& control) {
      std::optional<Value> value = work(control);
      if (!value) return std::function<void()>();
      auto kept = std::make_shared<const Value>(std::move(*value));
      return std::function<void()>([done, kept] { done(*kept); });
    });
  }

  /// Drops the work at hand; does nothing if there is none.
  void cancel();

  bool isRunning() const { return current_ != nullptr; }

 signals:
  void runningChanged(bool running);
  void progressed(double share);
  /// The work threw; the reason for a person.
  void failed(const QString& reason);

 private:
  friend class JobControl;
  using Show = std::function<void()>;
  void run(std::function<Show(const JobControl&)> work);
  void finish(const std::shared_ptr<JobControl::State>& state, const Show& show,
              const QString& failure);

  std::shared_ptr<JobControl::State> current_;  ///< of the newest start; null when idle
};

}  // namespace flatland::ui
