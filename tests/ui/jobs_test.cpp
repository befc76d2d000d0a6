// SPDX-License-Identifier: GPL-3.0-or-later
// Work off the window's thread: nothing stale arrives, and nothing after the end.
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QThreadPool>
#include <atomic>
#include <stdexcept>

#include "ui/jobs/job.h"

using namespace flatland::ui;

namespace {

// Far longer than any of these tests takes; work that does not notice a cancel runs as long.
constexpr int kForeverMs = 60000;
// Far more than a cancel takes on a busy machine.
constexpr int kPromptMs = 2000;

std::function<std::optional<int>(const JobControl&)> untilCancelled(std::atomic<int>& ended) {
  return [&ended](const JobControl& control) -> std::optional<int> {
    QElapsedTimer timer;
    timer.start();
    while (!control.isCancelled() && timer.elapsed() < kForeverMs) {
      control.setProgress(0.5);
      QThread::msleep(1);
    }
    ++ended;
    return -1;
  };
}

}  // namespace

class JobsTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QVERIFY(QThreadPool::globalInstance()->waitForDone(kPromptMs)); }

  void resultArrivesOnTheThreadOfTheJob() {
    Job job;
    QSignalSpy running(&job, &Job::runningChanged);
    int result = 0;
    QThread *worker = nullptr, *receiver = nullptr;
    job.start<int>(
        [&worker](const JobControl&) {
          worker = QThread::currentThread();
          return std::optional(42);
        },
        [&](const int& value) {
          receiver = QThread::currentThread();
          result = value;
        });
    QVERIFY(job.isRunning());
    QTRY_COMPARE(result, 42);
    QVERIFY(!job.isRunning());
    QCOMPARE(receiver, QThread::currentThread());
    QVERIFY(worker != receiver);
    QCOMPARE(running.count(), 2);
  }

  void newestWinsAndStaleResultsAreDropped() {
    Job job;
    QList<int> results;
    std::atomic<int> ended = 0;
    const auto keep = [&results](const int& value) { results << value; };
    QSignalSpy progress(&job, &Job::progressed);
    job.start<int>(untilCancelled(ended), keep);
    QTRY_VERIFY(progress.count() > 0);
    // Ends at once, but its result is still in the queue when the next one starts.
    std::atomic<bool> finished = false;
    job.start<int>(
        [&finished](const JobControl&) {
          finished = true;
          return std::optional(1);
        },
        keep);
    while (!finished) QThread::msleep(1);
    QThread::msleep(50);
    job.start<int>([](const JobControl&) { return std::optional(2); }, keep);
    QTRY_COMPARE(results, QList<int>{2});
    QTRY_COMPARE(ended.load(), 1);
    QTest::qWait(50);
    QCOMPARE(results, QList<int>{2});
  }

  void cancelIsPrompt() {
    Job job;
    std::atomic<int> ended = 0;
    bool arrived = false;
    QSignalSpy progress(&job, &Job::progressed);
    job.start<int>(untilCancelled(ended), [&](const int&) { arrived = true; });
    QTRY_VERIFY(progress.count() > 0);
    QElapsedTimer timer;
    timer.start();
    job.cancel();
    QVERIFY(!job.isRunning());
    const qsizetype told = progress.count();
    QVERIFY(QThreadPool::globalInstance()->waitForDone(kPromptMs));
    QVERIFY(timer.elapsed() < kPromptMs);
    QCOMPARE(ended.load(), 1);
    QTest::qWait(50);
    QVERIFY(!arrived);
    QCOMPARE(progress.count(), told);
  }

  void nothingAfterDestruction() {
    std::atomic<int> ended = 0;
    int signalled = 0;
    bool arrived = false;
    {
      auto job = std::make_unique<Job>();
      connect(job.get(), &Job::runningChanged, this, [&signalled] { ++signalled; });
      connect(job.get(), &Job::progressed, this, [&signalled] { ++signalled; });
      job->start<int>(untilCancelled(ended), [&](const int&) { arrived = true; });
      QThread::msleep(60);  // some progress is queued
      QElapsedTimer timer;
      timer.start();
      signalled = 0;
      job.reset();
      QVERIFY(timer.elapsed() < kPromptMs);
    }
    QTRY_COMPARE(ended.load(), 1);
    QTest::qWait(50);
    QCOMPARE(signalled, 0);
    QVERIFY(!arrived);
  }

  void earlyValuesComeInOrderAndOnlyFromTheNewest() {
    Job job;
    QList<int> shown;
    job.start<int>(
        [&shown](const JobControl& control) {
          for (int i = 0; i < 5; ++i) control.deliver([&shown, i] { shown << i; });
          return std::optional(5);
        },
        [&shown](const int& value) { shown << value; });
    QTRY_COMPARE(shown, (QList<int>{0, 1, 2, 3, 4, 5}));
    shown.clear();
    std::atomic<bool> finished = false;
    job.start<int>(
        [&](const JobControl& control) {
          control.deliver([&shown] { shown << 7; });
          finished = true;
          return std::optional(8);
        },
        [&shown](const int& value) { shown << value; });
    while (!finished) QThread::msleep(1);
    job.cancel();
    QTest::qWait(50);
    QVERIFY(shown.isEmpty());
  }

  void exceptionsAreToldOnce() {
    Job job;
    QSignalSpy failed(&job, &Job::failed);
    job.start<int>(
        [](const JobControl&) -> std::optional<int> { throw std::runtime_error("no room"); },
        [](const int&) { QFAIL("a result"); });
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(failed.front().front().toString(), QStringLiteral("no room"));
    QVERIFY(!job.isRunning());
  }

  void manyRestartsEndWithTheLast() {
    Job job;
    int last = -1;
    constexpr int kRestarts = 300;
    for (int i = 0; i < kRestarts; ++i) {
      job.start<int>([i](const JobControl&) { return std::optional(i); },
                     [&last, i](const int& value) {
                       QCOMPARE(value, i);
                       last = value;
                     });
      if (i % 7 == 0) QCoreApplication::processEvents();
    }
    QTRY_COMPARE(last, kRestarts - 1);
  }
};

QTEST_GUILESS_MAIN(JobsTest)
#include "jobs_test.moc"
