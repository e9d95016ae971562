#include "core/study/text/timeline_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/csv_text.h"
#include "core/base/json_number.h"
#include "core/describe/figure_text.h"
#include "core/measures/places/place_sums.h"
#include "core/receivers/place_names.h"
#include "core/study/text/error_words.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return roundAsText(value, 4); }

/// Writes what belongs to one place.
class TimelineWriter {
public:
    explicit TimelineWriter(const Zone& zone) : zone_(zone) {}

    [[nodiscard]] std::string time(Instant at) const {
        return zone_.text(std::chrono::round<std::chrono::seconds>(at));
    }

    [[nodiscard]] Json summary(const ShadowOnPlace& shadow, const DayTimeline& day) const {
        Json intervals = Json::array();
        for (const TimeSpan& span : shadow.intervals) intervals.push_back(spanJson(span));
        Json json{{"enters", timeOr(shadow.enters())},
                  {"exits", timeOr(shadow.exits())},
                  {"duration_min", rounded(shadow.minutes)},
                  {"intervals", intervals},
                  {"largest_m2", rounded(shadow.largestM2)},
                  {"largest_at", timeOr(shadow.largestAt)},
                  {"area_hours_m2h", rounded(shadow.areaHoursM2)},
                  {"share_of_theoretical", share(shadow.areaHoursM2, day.theoreticalM2h())}};
        if (!shadow.longest) return json;
        json["longest_stay_min"] = rounded(shadow.longest->minutes);
        json["longest_stay_longer_by_up_to_min"] = rounded(shadow.longest->errorMin);
        json["longest_stay"] = spanJson(shadow.longest->when);
        return json;
    }

    [[nodiscard]] Json day(const DayTimeline& day, const std::optional<LonLat>& longestAt) const {
        Json json{{"day", formatText(day.day)},
                  {"sunlit_min", rounded(day.sunlitMinutes)},
                  {"times_too_late_by_up_to_min", rounded(day.stepMinutes)},
                  {"theoretical_m2h", rounded(day.theoreticalM2h())},
                  {"full_cover_min", rounded(day.fullCoverMin)},
                  {"all_sun_taken_min", rounded(day.allSunTakenMin)},
                  {"baseline", summary(day.baseline, day)},
                  {"scenario", summary(day.scenario, day)},
                  {"incremental", summary(day.incremental, day)},
                  {"gained", summary(day.gained, day)}};
        if (longestAt)
            json["incremental"]["longest_stay_at"] = {{"lon", longestAt->lonDeg}, {"lat", longestAt->latDeg}};
        return json;
    }

    [[nodiscard]] Json steps(const DayTimeline& day) const {
        Json steps = Json::array();
        for (const PlaceStep& step : day.steps)
            steps.emplace_back(Json{{"at", time(step.at)}}).update(figuresJson(placeStepFigures().of(step)));
        return steps;
    }

    static Json sums(const AreaHours& sums) { return figuresJson(areaHoursFigures().of(sums)); }

    [[nodiscard]] Json period(const PlaceSums& all) const {
        Json months = Json::object(), quarters = Json::object();
        for (const auto& [month, one] : all.months()) months[month] = sums(one);
        for (std::size_t i = 0; i < quarterNames.size(); ++i)
            if (all.quarters()[i].days > 0) quarters[quarterNames[i]] = sums(all.quarters()[i]);
        return {{"sums", sums(all.all())},
                {"months", months},
                {"quarters", quarters},
                {"day_of_most_shadow", most(all.mostScenario())},
                {"day_of_most_incremental", most(all.mostIncremental())},
                {"largest_incremental_m2", rounded(all.largestIncrementalM2())},
                {"largest_incremental_at", timeOr(all.largestIncrementalAt())}};
    }

private:
    [[nodiscard]] Json timeOr(const std::optional<Instant>& at) const {
        return at ? Json(time(*at)) : Json();
    }
    [[nodiscard]] Json spanJson(const TimeSpan& span) const {
        return {{"from", time(span.from)}, {"to", time(span.to)}, {"minutes", rounded(span.minutes())}};
    }
    static double share(double part, double whole) { return whole > 0 ? roundAsText(part / whole, 6) : 0; }
    static Json most(const std::optional<MostShadow>& most) {
        if (!most) return {};
        return {{"day", formatText(most->day)}, {"m2h", rounded(most->areaHoursM2)}};
    }

    const Zone& zone_;
};

}  // namespace

Json timelineJson(const PlaceStudy& study, const PlaceTimeline& place, const TimelineLabels& labels) {
    const TimelineWriter writer(labels.zone);
    Json json{{"place", place.place.name},
              {"kind", nameOf(place.place.kind)},
              {"source", place.place.source},
              {"from", labels.from},
              {"to", labels.to.empty() ? Json() : Json(labels.to)},
              {"zone", labels.zone.name()},
              {"polygon_m2", rounded(area(place.place))},
              {"area_m2", place.days.empty() ? 0 : rounded(place.days.front().areaM2)},
              {"cell_m", study.cellM},
              {"step_min", rounded(study.stepMinutes)},
              {"engine", study.engine}};
    if (place.days.size() == 1) {
        json.update(writer.day(place.days.front(), place.longestIncrementalAt.front()));
        json["steps"] = writer.steps(place.days.front());
    } else {
        Json days = Json::array();
        for (std::size_t i = 0; i < place.days.size(); ++i) {
            days.push_back(writer.day(place.days[i], place.longestIncrementalAt[i]));
            if (!place.days[i].steps.empty()) days.back()["steps"] = writer.steps(place.days[i]);
        }
        json.update(writer.period(place.sums));
        json["days"] = days;
    }
    json["warnings"] = warningsJson(study.warnings);
    return json;
}

std::string timelineCsv(const PlaceStudy& study, const TimelineLabels& labels) {
    const TimelineWriter writer(labels.zone);
    std::vector<std::string> columns = listColumns(placeStepFigures().rows());
    columns.insert(columns.begin(), {"place", "day", "at"});
    CsvText csv(columns);
    for (const PlaceTimeline& place : study.places)
        for (const DayTimeline& day : place.days)
            for (const PlaceStep& step : day.steps) {
                csv.text(place.place.name).text(formatText(day.day)).text(writer.time(step.at));
                addFigures(csv, placeStepFigures().of(step));
                csv.endRow();
            }
    return csv.take();
}

}  // namespace noonmark
