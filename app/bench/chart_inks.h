#pragma once

#include <QColor>
#include <map>
#include <string>

#include "core/bench/finding.h"

namespace noonmark {

enum class MarkShape { circle, square, triangle, diamond, pentagon };

/// Colour and mark of a series.
struct ChartInk {
    QColor colour;
    MarkShape shape = MarkShape::circle;
};

/// One colour and shape per value of ChartSeries::colourOf, the same on all pages. The colours are
/// distinguishable for colour-blind readers (Okabe and Ito, 2008, "Color Universal Design", and two of
/// Tol's), the shapes in greyscale print.
class ChartInks {
public:
    explicit ChartInks(const std::vector<bench::Finding>& findings);
    [[nodiscard]] ChartInk of(const std::string& word) const;

private:
    std::map<std::string, ChartInk> inks_;
};

}  // namespace noonmark
