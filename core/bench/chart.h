#pragma once

#include <string>
#include <vector>

namespace noonmark::bench {

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

}  // namespace noonmark::bench
