// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>
#include <utility>

#include "ui/jobs/job.h"

namespace flatland::ui {

/// Long work that follows what changes faster than the work is done: one piece is under way, it is
/// let come to its end, and of what is wished meanwhile only that it is wished is kept. What is
/// wished is looked at when it begins, so it is the newest. For work whose older results are still
/// worth to be seen; a Job started anew drops them.
///
/// All calls on the thread of the object, all signals there. Destroyed, it drops the work at hand
/// as a Job does: nothing begins, is done or signalled afterwards, also if `done` or a slot of
/// failed() destroys it.
class LatestJob : public QObject {
  Q_OBJECT

 public:
  /// `begin` looks at what is wished now and calls start() once, or does nothing if nothing is. It
  /// is called by wish(), or when work has ended.
  explicit LatestJob(std::function<void()> begin, QObject* parent = nullptr);

  /// Something else is wished: begins now, or when the work at hand has ended, be it well, with no
  /// value, or with an exception. A failure by itself repeats nothing: with nothing wished since
  /// its start the work is over.
  void wish();

  /// What was wished while work is under way is not wished any more; that work goes on.
  void forgetWish() { waiting_ = false; }

  /// Drops the work at hand and forgets the wish behind it.
  void cancel();

  /// From `begin` only. `work` and `done` are as those of Job::start. What was wished meanwhile
  /// begins after `done`, or after failed().
  template <class Value>
  void start(std::function<std::optional<Value>(const JobControl&)> work,
             std::function<void(const Value&)> done) {
    // Always a value, so that work without one is seen to end as well.
    using Maybe = std::optional<Value>;
    job_.start<Maybe>(
        [work = std::move(work)](const JobControl& control) {
          return std::optional<Maybe>(work(control));
        },
        [this, done = std::move(done)](const Maybe& value) {
          const QPointer<LatestJob> still(this);
          if (value) done(*value);
          if (still) beginWaiting();
        });
  }

  bool isRunning() const { return job_.isRunning(); }
  /// True until everything wished has been done.
  bool isStale() const { return isRunning() || waiting_; }

 signals:
  void runningChanged(bool running);
  void progressed(double share);
  /// The work threw; the reason for a person.
  void failed(const QString& reason);

 private:
  void beginWaiting();

  std::function<void()> begin_;
  Job job_;
  bool waiting_ = false;
};

}  // namespace flatland::ui
