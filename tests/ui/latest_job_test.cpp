// SPDX-License-Identifier: GPL-3.0-or-later
// Work that follows a wish: one piece at a time, the newest wish behind it, whatever becomes of it.
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <stdexcept>

#include "ui/jobs/latest_job.h"

using namespace flatland::ui;

namespace {

constexpr int kPromptMs = 5000;  // far more than a step of these tests takes on a busy machine
constexpr int kBadWish = -1;     // the work throws
constexpr int kEmptyWish = -2;   // the work has no value

/// Somebody who wishes numbers and shows those that are made. The work waits until it is let go.
struct Wisher {
  struct Gate {
    std::atomic<int> open = 0, begun = 0, together = 0, most = 0;
  };

  std::shared_ptr<Gate> gate = std::make_shared<Gate>();
  int wished = 0;
  QList<int> tried, shown;
  std::unique_ptr<LatestJob> job = std::make_unique<LatestJob>([this] { begin(); });
  QSignalSpy failed{job.get(), &LatestJob::failed};

  void wish(int value) {
    wished = value;
    job->wish();
  }
  void begin() {
    tried << wished;
    job->start<int>(
        [gate = gate, value = wished](const JobControl& control) -> std::optional<int> {
          ++gate->begun;
          const int together = ++gate->together;
          if (together > gate->most) gate->most = together;
          while (gate->open <= 0 && !control.isCancelled()) QThread::msleep(1);
          --gate->open;
          --gate->together;
          if (value == kBadWish) throw std::runtime_error("cannot be");
          if (value == kEmptyWish) return std::nullopt;
          return value;
        },
        [this](const int& value) { shown << value; });
  }
  bool begins(int count) {
    return QTest::qWaitFor([&] { return gate->begun == count; }, kPromptMs);
  }
  /// Lets `count` pieces of work end, and waits until nothing is left to do.
  bool ends(int count) {
    gate->open = count;
    return QTest::qWaitFor([this] { return !job->isStale(); }, kPromptMs);
  }
};

}  // namespace

class LatestJobTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QVERIFY(QThreadPool::globalInstance()->waitForDone(kPromptMs)); }

  void theNewestWishFollowsTheOneUnderWay() {
    Wisher w;
    w.wish(1);
    QVERIFY(w.begins(1));
    for (const int value : {2, 3, 4}) w.wish(value);
    QVERIFY(w.job->isRunning() && w.job->isStale());
    QCOMPARE(w.tried, (QList<int>{1}));
    QVERIFY(w.ends(2));
    QCOMPARE(w.tried, (QList<int>{1, 4}));
    QCOMPARE(w.shown, (QList<int>{1, 4}));
    QVERIFY(!w.job->isRunning());
  }

  void aWishBehindAFailureIsTried() {
    Wisher w;
    w.wish(kBadWish);
    QVERIFY(w.begins(1));
    w.wish(2);
    w.wish(3);
    QVERIFY(w.ends(2));
    QCOMPARE(w.failed.count(), 1);
    QCOMPARE(w.failed[0][0].toString(), QStringLiteral("cannot be"));
    QCOMPARE(w.tried, (QList<int>{kBadWish, 3}));
    QCOMPARE(w.shown, (QList<int>{3}));
  }

  void aFailureIsNotRepeated() {
    Wisher w;
    w.wish(kBadWish);
    QVERIFY(w.ends(1));
    QCOMPARE(w.tried.size(), 1);
    // Wished again while it is tried, it is tried again, once.
    w.wish(kBadWish);
    QVERIFY(w.begins(2));
    w.wish(kBadWish);
    QVERIFY(w.ends(2));
    QTest::qWait(50);
    QCOMPARE(w.tried.size(), 3);
    QCOMPARE(w.failed.count(), 3);
    QVERIFY(w.shown.isEmpty());
  }

  void aWishBehindWorkWithoutAValueIsTried() {
    Wisher w;
    w.wish(kEmptyWish);
    QVERIFY(w.begins(1));
    w.wish(2);
    QVERIFY(w.ends(2));
    QCOMPARE(w.shown, (QList<int>{2}));
    QCOMPARE(w.failed.count(), 0);
  }

  void aForgottenWishIsNotTried() {
    Wisher w;
    w.wish(1);
    QVERIFY(w.begins(1));
    w.wish(2);
    w.job->forgetWish();
    QVERIFY(w.ends(1));
    QCOMPARE(w.tried, (QList<int>{1}));
    QCOMPARE(w.shown, (QList<int>{1}));
  }

  void cancelDropsBoth() {
    Wisher w;
    w.wish(1);
    QVERIFY(w.begins(1));
    w.wish(2);
    w.job->cancel();
    QVERIFY(!w.job->isStale());
    QVERIFY(QThreadPool::globalInstance()->waitForDone(kPromptMs));
    QTest::qWait(50);
    QCOMPARE(w.tried, (QList<int>{1}));
    QVERIFY(w.shown.isEmpty());
    // And the next one begins at once.
    w.wish(3);
    QCOMPARE(w.tried.last(), 3);
    QVERIFY(w.ends(1));
    QCOMPARE(w.shown, (QList<int>{3}));
  }

  void nothingAfterDestruction() {
    Wisher w;
    int signalled = 0;
    connect(w.job.get(), &LatestJob::runningChanged, this, [&signalled] { ++signalled; });
    connect(w.job.get(), &LatestJob::failed, this, [&signalled] { ++signalled; });
    w.wish(kBadWish);
    QVERIFY(w.begins(1));
    w.wish(2);
    signalled = 0;
    w.job.reset();
    QVERIFY(QThreadPool::globalInstance()->waitForDone(kPromptMs));
    QTest::qWait(50);
    QCOMPARE(signalled, 0);
    QCOMPARE(w.tried, (QList<int>{kBadWish}));
    QVERIFY(w.shown.isEmpty());
  }

  void whoeverIsToldOfTheEndMayDestroyIt() {
    for (const int value : {1, kBadWish}) {
      std::unique_ptr<LatestJob> job;
      int begun = 0;
      std::atomic<bool> go = false;
      job = std::make_unique<LatestJob>([&] {
        ++begun;
        job->start<int>(
            [&go, value](const JobControl&) -> std::optional<int> {
              while (!go) QThread::msleep(1);
              if (value == kBadWish) throw std::runtime_error("cannot be");
              return value;
            },
            [&job](const int&) { job.reset(); });
      });
      connect(job.get(), &LatestJob::failed, this, [&job] { job.reset(); });
      job->wish();
      job->wish();  // waits for ever
      go = true;
      QTRY_VERIFY(!job);
      QTest::qWait(20);
      QCOMPARE(begun, 1);
    }
  }

  void neverTwoAtOnce() {
    Wisher w;
    // Whoever is told of the end may wish at once; a failure changes nothing of it.
    connect(w.job.get(), &LatestJob::runningChanged, this, [&w](bool running) {
      if (!running && w.tried.size() < 40) w.wish(w.tried.size() % 3 == 0 ? kBadWish : 7);
    });
    w.gate->open = 1000;
    for (int i = 0; i < 200; ++i) {
      w.wish(i % 5 == 0 ? kBadWish : i);
      if (i % 10 == 0) QTest::qWait(1);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!w.job->isStale() && w.tried.size() >= 40, kPromptMs);
    w.wish(1000);
    QTRY_VERIFY_WITH_TIMEOUT(!w.job->isStale(), kPromptMs);
    QCOMPARE(w.gate->most.load(), 1);
    QCOMPARE(w.gate->begun.load(), static_cast<int>(w.tried.size()));
    QCOMPARE(w.shown.size() + w.failed.count(), w.tried.size());
    QCOMPARE(w.shown.last(), 1000);
  }
};

QTEST_GUILESS_MAIN(LatestJobTest)
#include "latest_job_test.moc"
