// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/latest_job.h"

namespace flatland::ui {

LatestJob::LatestJob(std::function<void()> begin, QObject* parent)
    : QObject(parent), begin_(std::move(begin)) {
  connect(&job_, &Job::runningChanged, this, &LatestJob::runningChanged);
  connect(&job_, &Job::progressed, this, &LatestJob::progressed);
  connect(&job_, &Job::failed, this, [this](const QString& reason) {
    const QPointer<LatestJob> still(this);
    emit failed(reason);
    if (still) beginWaiting();
  });
}

void LatestJob::wish() {
  waiting_ = isRunning();
  if (!waiting_) begin_();
}

void LatestJob::cancel() {
  waiting_ = false;
  job_.cancel();
}

// A slot that was told of the end may have wished something already, which has begun then.
void LatestJob::beginWaiting() {
  if (!waiting_ || isRunning()) return;
  waiting_ = false;
  begin_();
}

}  // namespace flatland::ui
