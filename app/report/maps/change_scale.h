#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/measures/palette.h"

namespace noonmark {

/// How large values around zero are, without their signs.
struct ChangeSpread {
    double usual = 0;  ///< 98 % of those that are not zero are no larger
    double most = 0;
};

/// Values up to `least` count as zero, and so does NaN. O(n log n).
ChangeSpread changeSpreadOf(const std::vector<float>& values, float least);

/// The ends of the colours of a difference in minutes. Locked, they are the same for every proposal, so that
/// pictures can be compared; else they are fitted to each difference.
struct ChangeScale {
    static constexpr double usualMin = 60;
    static constexpr double mostMin = 1440;
    std::optional<double> lockedMin = usualMin;  ///< colours run from -lockedMin to lockedMin; (0, mostMin]
    bool operator==(const ChangeScale&) const = default;
};

/// "60" or "auto", as in a project's view and on the command line.
std::string textOf(const ChangeScale& scale);
/// Nothing where it is neither minutes above 0 and up to mostMin nor "auto".
std::optional<ChangeScale> parseChangeScale(const std::string& text);

/// Under this key Project::view holds it.
constexpr const char* changeScaleKey = "change_scale";
/// What a project's view holds, or the usual one.
ChangeScale changeScaleIn(const std::map<std::string, std::string>& view);

/// The legend's scale for minutes that spread so.
LegendScale legendScaleOf(const ChangeScale& scale, const ChangeSpread& spread);

}  // namespace noonmark
