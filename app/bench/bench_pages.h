#pragma once

#include <QIODevice>

#include "core/bench/bench_report.h"

namespace noonmark {

/// The report of a benchmark as a PDF of A4 pages: the summary with the first finding, then two findings a
/// page; every page names city, date and machine. Text stays text, charts are vectors. Writes to `device`,
/// which is open; false when no PDF could be begun or ended. Needs a QApplication.
bool writeBenchPages(const bench::BenchReport& report, QIODevice& device);

}  // namespace noonmark
