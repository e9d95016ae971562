#pragma once

#include <QColor>
#include <map>
#include <string>

#include "core/bench/finding.h"

namespace noonmark {

enum class MarkShape { circle, square, triangle, diamond, pentagon };

/// How a series looks.
struct ChartInk {
    QColor colour;
    MarkShape shape = MarkShape::circle;
};

/// One look for every word of ChartSeries::colourOf, the same on all pages: colours that the colour-blind
/// tell apart (Okabe and Ito, 2008, "Color Universal Design", and two of Tol's), and shapes for those who
/// print in grey.
class ChartInks {
public:
    explicit ChartInks(const std::vector<bench::Finding>& findings);
    [[nodiscard]] ChartInk of(const std::string& word) const;

private:
    std::map<std::string, ChartInk> inks_;
};

}  // namespace noonmark
