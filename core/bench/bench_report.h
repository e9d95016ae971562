#pragma once

// The folder core/bench measures the engines. contests/ runs engines against each other on equal terms:
// sites, periods, timing, deadlines, errors against the ray reference. paper/ repeats the paper's experiments
// with these contests, horizon/ measures the horizon sweep and projected shadows. Every experiment returns a
// Finding (finding.h) with a table (table.h) and charts (chart.h); BenchReport (this file) collects them.
// Extent (extent.h) says how much is measured, Work (work.h) carries progress, stop and time limit.

#include <optional>
#include <string>
#include <vector>

#include "core/bench/finding.h"

namespace noonmark::bench {

/// A number in summary.json and on the first page.
struct SummaryFigure {
    std::string key;                   ///< "iam_vs_ray"
    std::string what;                  ///< "inverse accrual map, times as fast as rays"
    std::string paper;                 ///< the paper's value in words, or the target; may be empty
    std::optional<double> value = {};  ///< nothing if an engine is missing or refused
};

/// The result of a benchmark: findings for pages and tables, numbers for the summary.
struct BenchReport {
    std::string title;
    std::string site;                 ///< the city, its size, and the date
    std::string machine;              ///< processor and threads
    std::string extent;               ///< how much was measured
    std::string reference = "paper";  ///< heading of the column of `SummaryFigure::paper`
    double seconds = 0;               ///< total time
    std::vector<Finding> findings;
    std::vector<SummaryFigure> summary;
};

/// Takes the values of `summary` from the findings.
void fillSummary(BenchReport& report);

/// summary.json: one object of numbers or null, in the order of `summary`.
std::string summaryJson(const BenchReport& report);

/// The summary as a table for a page.
Comparison summaryTable(const BenchReport& report);

}  // namespace noonmark::bench
