#include "app/report/maps/change_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace noonmark {

namespace {

// Independent of the locale; nothing may follow the number.
std::optional<double> minutesIn(const std::string& text) {
    double minutes = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, minutes);
    if (error != std::errc() || stop != end) return std::nullopt;
    return minutes;
}

}  // namespace

ChangeSpread changeSpreadOf(const std::vector<float>& values, float minimum) {
    std::vector<float> amounts;
    for (const float value : values)
        if (std::abs(value) > minimum) amounts.push_back(std::abs(value));  // false for NaN
    if (amounts.empty()) return {};
    std::ranges::sort(amounts);
    return {double(amounts[(amounts.size() - 1) * 98 / 100]), double(amounts.back())};
}

std::string formatText(const ChangeScale& scale) {
    return scale.lockedMin ? fmt::format("{:g}", *scale.lockedMin) : "auto";
}

std::optional<ChangeScale> parseChangeScale(const std::string& text) {
    if (text == "auto") return ChangeScale{std::nullopt};
    const auto minutes = minutesIn(text);
    if (!minutes || !(*minutes > 0 && *minutes <= ChangeScale::maxLockedMin)) return std::nullopt;
    return ChangeScale{*minutes};
}

ChangeScale changeScaleIn(const std::map<std::string, std::string>& view) {
    const auto found = view.find(changeScaleKey);
    if (found == view.end()) return {};
    return parseChangeScale(found->second).value_or(ChangeScale());
}

LegendScale legendScaleOf(const ChangeScale& scale, const ChangeSpread& spread) {
    if (!scale.lockedMin) return legendScale(std::max(spread.percentile98, 1.0));
    const LegendScale round = legendScale(*scale.lockedMin);
    // The scale ends exactly at lockedMin: with four fields on each side if round fields end elsewhere.
    if (round.top == *scale.lockedMin) return round;
    return {*scale.lockedMin, *scale.lockedMin / 4};
}

}  // namespace noonmark
