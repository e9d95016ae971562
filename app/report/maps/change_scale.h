#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/measures/colour_scale.h"

namespace noonmark {

/// Magnitudes of values around zero.
struct ChangeSpread {
    double percentile98 = 0;  ///< 98 % of the nonzero values are no larger
    double maximum = 0;
};

/// Values up to `minimum` count as zero, as does NaN. O(n log n).
ChangeSpread changeSpreadOf(const std::vector<float>& values, float minimum);

/// The range of colours of a difference in minutes. A locked scale is the same for every proposal, so that
/// pictures can be compared; otherwise the scale is fitted to each difference.
struct ChangeScale {
    static constexpr double defaultLockedMin = lockedChangeMin;
    static constexpr double maxLockedMin = 1440;
    std::optional<double> lockedMin =
        defaultLockedMin;  ///< colours run from -lockedMin to lockedMin; (0, maxLockedMin]
    bool operator==(const ChangeScale&) const = default;
};

/// "60" or "auto", as in a project's view and on the command line.
std::string formatText(const ChangeScale& scale);
/// Empty where the text is neither "auto" nor minutes above 0 and up to maxLockedMin.
std::optional<ChangeScale> parseChangeScale(const std::string& text);

/// The option of commands that states the scale.
constexpr const char* changeScaleFlag = "--scale";
/// Key of the scale in Project::view.
constexpr const char* changeScaleKey = "change_scale";
/// The scale stored in a project's view, or the default.
ChangeScale changeScaleIn(const std::map<std::string, std::string>& view);

/// The legend's scale for values of this spread.
LegendScale legendScaleOf(const ChangeScale& scale, const ChangeSpread& spread);

}  // namespace noonmark
