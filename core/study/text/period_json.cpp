#include "core/study/text/period_json.h"

#include <algorithm>

#include "core/describe/field_json.h"
#include "core/sun/period_fields.h"
#include "core/sun/sun_events.h"

namespace noonmark {

namespace {

// Its fields; null where one does not apply. The sunrise rule is stated by the altitude in `window`.
nlohmann::ordered_json askedJson(const Period& period) {
    const Described asked = periodFields().of(period);
    const auto applying = fieldsJson(asked);
    nlohmann::ordered_json json;
    for (const Field& field : asked.fields) {
        const std::string key(field.key);
        if (field.needs.empty()) json[key] = applying.value(key, nlohmann::ordered_json());
    }
    return json;
}

}  // namespace

nlohmann::ordered_json periodJson(const Period& period, const SunSteps& sun, const Observer& observer) {
    nlohmann::ordered_json json{{"text", formatText(period)}};
    json.update(askedJson(period));
    json["counted_step_min"] = sun.stepMinutes;
    json["hours_min_per_day"] = sun.days.empty() ? 0 : sun.countedMinutes / double(sun.days.size());
    json["day_rounding_min"] = sun.maxOffADayMin;
    if (period.window)
        json["window"] = {{"after_sunrise_min", period.window->afterSunrise.count()},
                          {"before_sunset_min", period.window->beforeSunset.count()},
                          {"sunrise_altitude_deg",
                           computeSunriseAltitudeDeg(period.window->rule, relativeAirDensity(observer))}};
    json["days_without_sun"] = std::ranges::count(sun.days, 0U, &SunDay::count);
    return json;
}

nlohmann::ordered_json observerJson(const Observer& observer) {
    return {{"lon_deg", observer.place.lonDeg},
            {"lat_deg", observer.place.latDeg},
            {"elevation_m", observer.elevationM},
            {"pressure_hpa", observer.pressureHPa},
            {"temperature_c", observer.temperatureC}};
}

nlohmann::ordered_json sunFrameJson(const City& city, const StudySettings& settings, const SunSteps& sun) {
    const SunFrameFacts facts = computeSunFrame(city, settings);
    return {{"north_turned_deg", facts.convergenceDeg},
            {"vertical_turned_deg", facts.tiltDeg},
            {"farthest_from_observer_m", facts.farthestM},
            {"vertical_error_deg", facts.verticalErrorDeg},
            {"steps_levelled", sun.levelled}};
}

nlohmann::ordered_json regionJson(const Region& region, const Frame& frame) {
    const Box2 box = bounds(region);
    const LonLat low = frame.lonLatFromLocal(glm::dvec2(box.low));
    const LonLat high = frame.lonLatFromLocal(glm::dvec2(box.high));
    double areaM2 = 0;
    for (const Footprint& polygon : region.polygons) areaM2 += area(polygon);
    return {{"name", region.name},
            {"polygons", region.polygons.size()},
            {"area_m2", areaM2},
            {"extent_lonlat", {low.lonDeg, low.latDeg, high.lonDeg, high.latDeg}}};
}

}  // namespace noonmark
