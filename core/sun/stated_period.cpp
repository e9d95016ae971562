#include "core/sun/stated_period.h"

#include <nlohmann/json.hpp>

#include "core/describe/field_json.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

// Files state the rule of sunrise by the sun's altitude: some -0.83 degrees at its upper limb, about 0 at its
// centre.
constexpr double centreFromDeg = -0.5;

std::optional<SolarHours> readWindow(const Json& json) {
    const Json window = json.value("window", Json());
    if (!window.is_object()) return std::nullopt;
    return SolarHours{std::chrono::minutes(window.value("after_sunrise_min", 0)),
                      std::chrono::minutes(window.value("before_sunset_min", 0)),
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
    if (!readFieldsJson(periodFields().of(period), withoutNulls(json))) return std::nullopt;
    return period;
}

}  // namespace

StatedPeriod statePeriod(const Period& period) { return {formatText(period), period}; }

StatedPeriod readStatedPeriod(const Json& json) {
    if (!json.is_object()) return {};
    try {
        return {json.value("text", std::string()), readAsked(json)};
    } catch (const Json::exception&) {  // a member of another kind
        return {};
    }
}

}  // namespace noonmark
