#pragma once

// The folder core/lab/bench measures the engines. contests/ runs engines against each other on equal terms:
// sites, periods, timing, deadlines, errors against the ray reference. paper/ repeats the paper's experiments
// with these contests, horizon/ measures the horizon sweep and projected shadows, points/ single points.
// Every experiment returns a Finding with a table and charts (finding.h); BenchReport (this file) collects
// them. work.h says how much is measured (Extent) and carries progress, stop and time limit (Work).

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/lab/bench/finding.h"

namespace noonmark::bench {

/// Peak memory of the process while `work` runs, minus its memory before, bytes, as the system counts pages
/// (resident set; Linux). Memory that the process freed before is returned to the system first, so that it
/// does not hide what `work` takes. Nothing if the system does not provide these numbers. Memory of other
/// threads counts too.
std::optional<std::uint64_t> measurePeakMemory(const std::function<void()>& work);

/// The machine's properties that times depend on.
struct Machine {
    std::string processor;  ///< the model's name from the system; "unknown processor" if it gives none
    int threads = 1;        ///< number of threads that the engines use
};

/// The machine that runs the program.
Machine detectMachine();

/// "AMD EPYC, 2 threads"
std::string describeMachine(const Machine& machine);

/// What a ratio or an error should reach on any machine.
struct Target {
    bool isMinimum = false;  ///< the value should be at least, else at most, this
    double value = 0;
};
constexpr Target atLeast(double value) { return {true, value}; }
constexpr Target atMost(double value) { return {false, value}; }

/// A number in summary.json and on the first page.
struct SummaryFigure {
    std::string key;                    ///< "iam_vs_ray"
    std::string what;                   ///< "inverse accrual map, times as fast as rays"
    std::string paper;                  ///< the paper's value in words, or the target; may be empty
    std::optional<double> value = {};   ///< nothing if an engine is missing or refused
    std::optional<Target> target = {};  ///< none: it depends on the machine, or nothing was aimed at
};
/// With the target in words.
SummaryFigure targetFigure(std::string key, std::string what, Target target);

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

/// The figures that are over a quarter worse than their target, or were not measured: a noisy machine alone
/// does not make them so.
std::vector<SummaryFigure> listMissed(const BenchReport& report);

/// summary.json: one object of numbers or null, in the order of `summary`.
std::string summaryJson(const BenchReport& report);

/// The summary as a table for a page.
Comparison summaryTable(const BenchReport& report);

}  // namespace noonmark::bench
