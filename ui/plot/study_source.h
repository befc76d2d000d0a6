// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>

#include "flatland/study/offset_study.h"
#include "ui/jobs/job.h"

namespace flatland::ui {

/// A study, or the part of one that has been run.
struct StudyData {
  OffsetStudyOptions options;
  OffsetSummary summary;

  bool isWhole() const { return summary.curves == options.curves; }
};

/// Runs offset studies on all cores beside the window's thread: for the summary, which grows
/// meanwhile, or into a table file.
class StudySource : public QObject {
  Q_OBJECT

 public:
  explicit StudySource(QObject* parent = nullptr);

  /// The study there is to see; null before the first.
  const std::shared_ptr<const StudyData>& data() const { return data_; }
  bool isRunning() const { return job_.isRunning(); }

  /// Precondition for both: options.whyInvalid() is empty.
  void run(const OffsetStudyOptions& options);

  /// Writes the per-curve table, a row as soon as it is measured. A file that holds a part of this
  /// study is continued; any other is left as it is, and failed() says so.
  void writeTable(const OffsetStudyOptions& options, const std::filesystem::path& file);

  /// Stops where it is; what was counted or written stays.
  void cancel() { job_.cancel(); }

 signals:
  void changed();  ///< data() or isRunning()
  void progressed(double share);
  void tableWritten(const QString& file);
  void failed(const QString& reason);

 private:
  Job job_;
  std::shared_ptr<const StudyData> data_;
};

}  // namespace flatland::ui
