#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/measures/palette.h"

namespace noonmark {

/// Values from `low` to `high`; the one farther from zero is not in it, but for the outermost band.
struct ValueBand {
    double low = 0, high = 0;
    Rgb colour;         ///< of its middle, as in the window and the report
    std::string label;  ///< "60 to 120 min/day"
};

/// Bands between round values that hold all of a result's values, from low to high.
class ValueBands {
public:
    /// `change`: values may be less or more than zero, and zero itself is in no band; else none is less.
    ValueBands(std::span<const float> values, const std::string& unit, bool change);

    [[nodiscard]] const std::vector<ValueBand>& bands() const { return bands_; }
    [[nodiscard]] int bandOf(float value) const;  ///< its place in bands(); -1: none, as for NaN

private:
    LegendScale scale_;
    bool change_;
    int each_;  // bands on one side of zero
    std::vector<ValueBand> bands_;
};

}  // namespace noonmark
