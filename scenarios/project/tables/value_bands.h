#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/measures/palette.h"

namespace noonmark {

/// Values from `low` to `high`. The bound farther from zero is exclusive, except in the outermost band.
struct ValueBand {
    double low = 0, high = 0;
    Rgb colour;         ///< of the middle of the band, as in the window and the report
    std::string label;  ///< "60 to 120 min/day"
};

/// Bands between round values that cover all values of a result, in ascending order.
class ValueBands {
public:
    /// `change`: values may be negative, and zero is in no band. Otherwise all values must be 0 or more.
    ValueBands(std::span<const float> values, const std::string& unit, bool change);

    [[nodiscard]] const std::vector<ValueBand>& bands() const { return bands_; }
    [[nodiscard]] int bandOf(float value) const;  ///< index into bands(); -1: in no band, as for NaN

private:
    LegendScale scale_;
    bool change_;
    int each_;  // number of bands on one side of zero
    std::vector<ValueBand> bands_;
};

}  // namespace noonmark
