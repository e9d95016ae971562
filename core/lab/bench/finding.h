#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace noonmark::bench {

/// A number, a word, or nothing: a value that was not measured is empty, never zero.
using TableCell = std::variant<std::monostate, double, std::string>;

/// The result of an experiment for further use: one row per measurement.
struct Table {
    std::vector<std::string> columns;          ///< lower case, unit at the end: "time_s"
    std::vector<std::vector<TableCell>> rows;  ///< each as long as `columns`
};

/// RFC 4180, lines end in \n, decimal points, a header row with the column names. Numbers have enough digits
/// to be read back exactly.
std::string toCsv(const Table& table);

/// The content of a chart, independent of how it is drawn.
struct ChartPoint {
    double x = 0;
    double y = 0;
    std::string label;  ///< beside the point; may be empty
};

struct ChartSeries {
    std::string name;      ///< name in the legend; series of one name share an entry
    std::string colourOf;  ///< series with the same word have the same colour in every chart; empty: ink
    std::vector<ChartPoint> points;
    bool joined = true;      ///< points are joined by lines, in their order
    bool marked = true;      ///< each point has a marker
    bool estimated = false;  ///< hollow markers, dashed lines: estimated from a sample, or a published value
};

struct ChartAxis {
    std::string label;  ///< with its unit
    bool logarithmic = false;
    bool fromZero = false;  ///< a linear axis that must show zero
    bool whole = false;     ///< a linear axis of whole numbers
};

struct Chart {
    std::string title;
    ChartAxis x;
    ChartAxis y;
    std::vector<ChartSeries> series;
};

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
