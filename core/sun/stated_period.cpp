#include "core/sun/stated_period.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/base/json_number.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

// Files state the rule of sunrise by the sun's altitude: some -0.83 degrees at its upper limb, about 0 at its
// centre.
constexpr double centreFromDeg = -0.5;

std::chrono::minutes readOffset(const Json& window, const char* key) {
    constexpr int maxMin = 12 * 60;  // as in parseSolarHours()
    const int minutes = wholeNumberIn<int>(window, key, 0);
    if (minutes < -maxMin || minutes > maxMin) throw std::out_of_range(key);
    return std::chrono::minutes(minutes);
}

std::optional<SolarHours> readWindow(const Json& json) {
    const Json window = json.value("window", Json());
    if (!window.is_object()) return std::nullopt;
    return SolarHours{readOffset(window, "after_sunrise_min"), readOffset(window, "before_sunset_min"),
                      window.value("sunrise_altitude_deg", -1.0) > centreFromDeg ? SunriseRule::centre
                                                                                 : SunriseRule::upperLimb};
}

Json withoutNulls(const Json& json) {
    Json kept = Json::object();
    for (const auto& [key, value] : json.items())
        if (!value.is_null() && !value.is_object()) kept[key] = value;
    return kept;
}

std::optional<Period> readAsked(const Json& json) {
    if (!json.contains("start")) return std::nullopt;
    Period period;
    if (const auto window = readWindow(json)) period.window = window;
    const bool isSound = readFieldsJson(periodFields().of(period), withoutNulls(json)) &&
                         checkRanges(periodFields().of(period));
    return isSound ? std::optional(period) : std::nullopt;
}

}  // namespace

StatedPeriod statePeriod(const Period& period) { return {formatText(period), period}; }

StatedPeriod readStatedPeriod(const Json& json) {
    if (!json.is_object()) return {};
    try {
        return {json.value("text", std::string()), readAsked(json)};
    } catch (const std::exception&) {  // a member of another kind, or a number that is none of a period
        return {};
    }
}

}  // namespace noonmark
