#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/measures/colour_scale.h"

namespace noonmark {

/// Bands between round values that cover all values of a result, in ascending order, in the colours of their
/// middles: "60 to 120 min/day". The bound farther from zero is exclusive, except in the outermost band.
class ValueBands {
public:
    /// `change`: values may be negative, and zero is in no band. Otherwise all values must be 0 or more.
    ValueBands(std::span<const float> values, const std::string& unit, bool change);

    [[nodiscard]] const std::vector<ColourClass>& bands() const { return bands_; }
    [[nodiscard]] int bandOf(float value) const;  ///< index into bands(); -1: in no band, as for NaN

private:
    LegendScale scale_;
    bool change_;
    int each_;  // number of bands on one side of zero
    std::vector<ColourClass> bands_;
};

}  // namespace noonmark
