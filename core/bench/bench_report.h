#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bench/finding.h"

namespace noonmark::bench {

/// A figure of summary.json and of the first page.
struct SummaryFigure {
    std::string key;                   ///< "iam_vs_ray"
    std::string what;                  ///< "inverse accrual map, times as fast as rays"
    std::string paper;                 ///< its value in words, or the target; may be empty
    std::optional<double> value = {};  ///< nothing where an engine is missing or refused
};

/// What a benchmark leaves: findings for pages and tables, figures for the summary.
struct BenchReport {
    std::string title;
    std::string site;                 ///< the city, how large it is, and when
    std::string machine;              ///< processor and threads
    std::string extent;               ///< how much was measured
    std::string reference = "paper";  ///< what `SummaryFigure::paper` is: the heading of its column
    double seconds = 0;               ///< all in all
    std::vector<Finding> findings;
    std::vector<SummaryFigure> summary;
};

/// The values of `figures` from what the findings say.
void fillSummary(BenchReport& report);

/// summary.json: one object of numbers or null, in the order of the figures.
std::string summaryJson(const BenchReport& report);

/// The figures for a page.
Comparison summaryTable(const BenchReport& report);

}  // namespace noonmark::bench
