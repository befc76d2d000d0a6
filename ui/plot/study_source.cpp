// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/study_source.h"

#include <QElapsedTimer>
#include <algorithm>
#include <mutex>
#include <thread>

#include "flatland/io/offset_table.h"
#include "ui/model/paths.h"

namespace flatland::ui {

namespace {

constexpr qint64 kShowEveryMs = 120;
constexpr qint64 kShowShare = 10;  // at most a tenth of the time goes into summing up

int allCores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

double shareOf(std::int64_t index, const OffsetStudyOptions& options) {
  return static_cast<double>(index + 1) / static_cast<double>(options.curves);
}

}  // namespace

StudySource::StudySource(QObject* parent) : QObject(parent) {
  connect(&job_, &Job::runningChanged, this, &StudySource::changed);
  connect(&job_, &Job::progressed, this, &StudySource::progressed);
  connect(&job_, &Job::failed, this, &StudySource::failed);
}

void StudySource::run(const OffsetStudyOptions& options) {
  using Data = std::shared_ptr<const StudyData>;
  const auto show = [this](const Data& shown) {
    data_ = shown;
    emit changed();
  };
  job_.start<Data>(
      [options, show](const JobControl& control) -> std::optional<Data> {
        OffsetCollector collector(options.convention);
        const auto dataNow = [&] {
          return std::make_shared<const StudyData>(StudyData{options, collector.summary()});
        };
        QElapsedTimer clock;
        clock.start();
        qint64 next = kShowEveryMs / 2;
        runOffsetStudy(options, 0, allCores(), [&](const CurveOffsets& curve) {
          collector.add(curve);
          control.setProgress(shareOf(curve.index, options));
          if (clock.elapsed() >= next) {
            const qint64 before = clock.elapsed();
            control.deliver([show, now = Data(dataNow())] { show(now); });
            next =
                clock.elapsed() + std::max(kShowEveryMs, kShowShare * (clock.elapsed() - before));
          }
          return !control.isCancelled();
        });
        if (control.isCancelled()) return std::nullopt;
        return dataNow();
      },
      show);
}

void StudySource::writeTable(const OffsetStudyOptions& options, const std::filesystem::path& file) {
  job_.start<bool>(
      [options, file](const JobControl& control) -> std::optional<bool> {
        // A run that was cancelled a moment ago may still be at its last row.
        static std::mutex oneWriter;
        const std::scoped_lock lock(oneWriter);
        OffsetTable table(file, options, OffsetTable::Existing::Continue);
        runOffsetStudy(options, table.rows(), allCores(), [&](const CurveOffsets& curve) {
          table.add(curve);
          control.setProgress(shareOf(curve.index, options));
          return !control.isCancelled();
        });
        table.close();
        return true;
      },
      [this, file](bool) { emit tableWritten(toQString(file)); });
}

}  // namespace flatland::ui
