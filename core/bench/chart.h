#pragma once

#include <string>
#include <vector>

namespace noonmark::bench {

/// What a chart shows, without a word about how it is drawn.
struct ChartPoint {
    double x = 0;
    double y = 0;
    std::string label;  ///< beside the point; may be empty
};

struct ChartSeries {
    std::string name;      ///< in the legend; series of one name share an entry
    std::string colourOf;  ///< series with the same word have the same colour in every chart; empty: ink
    std::vector<ChartPoint> points;
    bool joined = true;      ///< by lines, in their order
    bool marked = true;      ///< a mark at each point
    bool estimated = false;  ///< hollow marks, dashed lines: worked out from a sample, or another's figure
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
