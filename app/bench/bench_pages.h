#pragma once

#include <QIODevice>

#include "core/bench/bench_report.h"

namespace noonmark {

/// Writes the report of a benchmark as a PDF of A4 pages: the summary with the first finding, then two
/// findings per page. Every page names city, date and machine. Text remains text, charts are vectors.
/// `device` must be open. False if the PDF could not be started or completed. Needs a QApplication.
bool writeBenchPages(const bench::BenchReport& report, QIODevice& device);

}  // namespace noonmark
