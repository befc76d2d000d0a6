// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/job.h"

#include <QMetaObject>
#include <QThreadPool>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>

#include "ui/model/core_sentences.h"

namespace flatland::ui {

namespace {

constexpr auto kProgressInterval = std::chrono::milliseconds(33);

}  // namespace

struct JobControl::State {
  std::atomic<bool> cancelled = false;
  std::mutex mutex;    ///< guards `job`, so that nothing is posted to one that is going
  Job* job = nullptr;  ///< null once cancelled
  std::chrono::steady_clock::time_point lastProgress{};  ///< of the work's thread

  // Queues `call` for the job's thread. Posted events of a QObject go with it, and `job` is cleared
  // under the lock before it goes, so the call never meets a dead job.
  template <class Call>
  void post(Call call) {
    const std::scoped_lock lock(mutex);
    if (job) QMetaObject::invokeMethod(job, std::move(call), Qt::QueuedConnection);
  }

  void abandon() {
    cancelled = true;
    const std::scoped_lock lock(mutex);
    job = nullptr;
  }
};

bool JobControl::isCancelled() const { return state_->cancelled; }

void JobControl::setProgress(double share) const {
  const auto now = std::chrono::steady_clock::now();
  if (now - state_->lastProgress < kProgressInterval) return;
  state_->lastProgress = now;
  state_->post([state = state_, share] {
    // What was queued before a cancel or a new start arrives after it, and is stale.
    if (state->job) emit state->job->progressed(share);
  });
}

void JobControl::deliver(std::function<void()> show) const {
  state_->post([state = state_, show = std::move(show)] {
    if (state->job) show();
  });
}

Job::Job(QObject* parent) : QObject(parent) {}

Job::~Job() {
  if (current_) current_->abandon();
}

void Job::run(std::function<Show(const JobControl&)> work) {
  const bool wasRunning = isRunning();
  if (current_) current_->abandon();
  const auto state = std::make_shared<JobControl::State>();
  state->job = this;
  current_ = state;
  QThreadPool::globalInstance()->start([state, work = std::move(work)] {
    if (state->cancelled) return;  // overtaken while it waited for a thread
    Show show;
    QString failure;
    try {
      show = work(JobControl(state));
    } catch (const InputError& error) {
      failure = errorForPeople(error);
    } catch (const std::exception& error) {
      failure = QString::fromUtf8(error.what());
    }
    state->post([state, show = std::move(show), failure] {
      if (state->job) state->job->finish(state, show, failure);
    });
  });
  if (!wasRunning) emit runningChanged(true);
}

void Job::finish(const std::shared_ptr<JobControl::State>& state, const Show& show,
                 const QString& failure) {
  state->abandon();
  current_ = nullptr;
  emit runningChanged(false);
  if (!failure.isEmpty()) {
    emit failed(failure);
  } else if (show) {
    show();
  }
}

void Job::cancel() {
  if (!current_) return;
  current_->abandon();
  current_ = nullptr;
  emit runningChanged(false);
}

}  // namespace flatland::ui
