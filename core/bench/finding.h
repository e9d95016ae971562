#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/bench/chart.h"
#include "core/bench/table.h"

namespace noonmark::bench {

/// A small table for the page, as text: our values and the paper's side by side.
struct Comparison {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;  ///< each as long as `header`
};

/// The result of one experiment: for a file, for a page, for the summary.
struct Finding {
    std::string key;    ///< name of its CSV file: "sun_linearity"
    std::string title;  ///< title of its page: "The sun's straight path"
    std::string text;   ///< what was measured, on what, how much of it, and what the result shows
    std::vector<std::string> remarks;  ///< what was refused or left out, and why
    Table table;
    std::vector<Chart> charts;
    std::vector<Comparison> comparisons{1};
    std::map<std::string, double> summary;  ///< its keys of summary.json
    double seconds = 0;                     ///< duration of the experiment
};

}  // namespace noonmark::bench
