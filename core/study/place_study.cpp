#include "core/study/place_study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/csv_text.h"
#include "core/base/json_number.h"
#include "core/base/memory_guard.h"
#include "core/city/trees/tree.h"
#include "core/describe/figure_text.h"
#include "core/engines/shade_trees.h"
#include "core/measures/places/place_run.h"
#include "core/receivers/place_names.h"
#include "core/study/text/error_text.h"
#include "core/study/text/review_text.h"

namespace noonmark {

namespace {

std::optional<LonLat> locate(const std::optional<LongestStay>& stay, const PlaceReceivers& cells,
                             std::size_t place, const Frame& frame) {
    if (!stay) return std::nullopt;
    const std::uint32_t cell = cells.receivers.cells[cells.receiverOf(place, stay->cell)];
    return frame.lonLatFromLocal(glm::dvec2(cells.receivers.position(cell)));
}

void warnOfEmptyPlaces(const PlaceReceivers& cells, PlaceStudy& study) {
    for (std::size_t i = 0; i < study.places.size(); ++i)
        if (cells.cellCount(i) == 0)
            study.warnings.push_back({WarningKind::leftOut,
                                      "the place has no open ground as large as a cell; choose smaller cells",
                                      study.places[i].place.name});
}

Warnings warnOfUnmeasured(const City& baseline, const City* scenario) {
    Warnings warnings = warnOfTrees(baseline.trees);
    if (warnings.empty() && scenario != nullptr) warnings = warnOfTrees(scenario->trees);
    return warnings;
}

void addColumns(TreeColumns columns, PlaceStudy& study) {
    for (PlaceTimeline& place : study.places)
        for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
            if (isAmong(columns, column)) place.withTrees.push_back({{}, column});
}

/// Adds one day after the other to places.
struct DayAdder {
    const PlaceReceivers& cells;
    const Frame& frame;
    bool keepsSteps;

    void add(DayTimeline day, std::size_t place, PlaceDays& to) const {
        to.sums.add(day);
        to.longestIncrementalAt.push_back(locate(day.incremental.longest, cells, place, frame));
        if (!keepsSteps) day.steps.clear();
        to.days.push_back(std::move(day));
    }
    void add(PlaceTrees::Shaded shaded, std::size_t place, PlaceTimeline& timeline) const {
        for (ShadedPlace& with : timeline.withTrees)
            add(with.column == TreeColumns::evergreen ? std::move(shaded.evergreen)
                                                      : std::move(shaded.seasonal),
                place, static_cast<PlaceDays&>(with));
    }
};

Result<PlaceStudy> computePlaceStudy(const City& baseline, const City* scenario,
                                     const std::vector<Place>& places, const PlaceStudySettings& settings,
                                     const Engine& engine, Progress& progress, std::stop_token stop) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    const auto cells = placeReceiversOnPlaces(cities, places, {.cellM = settings.cellM}, stop);
    if (!cells) return tl::make_unexpected(cells.error());
    const auto period = validate(settings.period);
    if (!period) return tl::make_unexpected(period.error());
    const auto sun = computeDaylightSteps(*period, observerOfPlaces(baseline), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    PlaceStudy study{.engine = std::string(engine.stepMaskEngineName(cities, cells->receivers)),
                     .cellM = settings.cellM};
    study.stepMinutes = sun->stepMinutes;
    for (const Place& place : places) study.places.emplace_back().place = place;
    const PlaceTrees trees(baseline, scenario, *cells, *sun);
    study.treesUsed = trees.treesUsed();
    const bool hasTrees = study.treesUsed > 0;
    if (hasTrees) addColumns(settings.trees, study);
    warnOfEmptyPlaces(*cells, study);
    const TimelineSettings wanted{settings.allSteps || hasTrees, settings.longestStays};
    const DayAdder days{*cells, baseline.frame, settings.allSteps};
    const auto take = [&](std::size_t ofDay, std::span<const PlaceShadow> shadows) -> Result<void> {
        tbb::parallel_for(std::size_t{0}, shadows.size(), [&](std::size_t i) {
            PlaceTimeline& timeline = study.places[i];
            DayTimeline day = computeTimeline(shadows[i], wanted);
            if (hasTrees) days.add(trees.shade(i, ofDay, shadows[i], day, wanted, stop), i, timeline);
            days.add(std::move(day), i, static_cast<PlaceDays&>(timeline));
        });
        return {};
    };
    if (auto done = shadePlaces(engine, baseline, scenario, *cells, *sun, take, progress, stop); !done)
        return tl::make_unexpected(done.error());
    return study;
}

}  // namespace

Result<PlaceStudy> runPlaceStudy(const City& baseline, const City* scenario, const std::vector<Place>& places,
                                 const PlaceStudySettings& settings, const Engine& engine, Progress& progress,
                                 std::stop_token stop) {
    const City before = withTreesFor(baseline, settings.trees);
    std::optional<City> after;
    if (scenario != nullptr) after = withTreesFor(*scenario, settings.trees);
    if (after && scenario->trees == baseline.trees) after->trees = before.trees;
    return guardMemory({.what = "timelines of places"}, [&] {
        auto study = computePlaceStudy(before, after ? &*after : nullptr, places, settings, engine, progress,
                                       std::move(stop));
        if (study && settings.trees == TreeColumns::without) {
            const Warnings first = warnOfUnmeasured(baseline, scenario);
            study->warnings.insert(study->warnings.begin(), first.begin(), first.end());
        }
        return study;
    });
}

namespace {

using Json = nlohmann::ordered_json;

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
                  {"duration_min", round4(shadow.minutes)},
                  {"intervals", intervals},
                  {"largest_m2", round4(shadow.largestM2)},
                  {"largest_at", timeOr(shadow.largestAt)},
                  {"area_hours_m2h", round4(shadow.areaHoursM2)},
                  {"share_of_theoretical", share(shadow.areaHoursM2, day.theoreticalM2h())}};
        if (!shadow.longest) return json;
        json["longest_stay_min"] = round4(shadow.longest->minutes);
        json["longest_stay_longer_by_up_to_min"] = round4(shadow.longest->errorMin);
        json["longest_stay"] = spanJson(shadow.longest->when);
        return json;
    }

    // Without trees, and then the same with them.
    [[nodiscard]] Json day(const PlaceTimeline& place, std::size_t day) const {
        Json json = describe(place.days[day]);
        addShadow(json, place, day, {});
        for (const ShadedPlace& with : place.withTrees) addShadow(json, with, day, suffixOf(with.column));
        return json;
    }

    [[nodiscard]] Json steps(const PlaceTimeline& place, std::size_t day) const {
        Json steps = Json::array();
        for (std::size_t i = 0; i < place.days[day].steps.size(); ++i) {
            const PlaceStep& step = place.days[day].steps[i];
            Json& json = steps.emplace_back(Json{{"at", time(step.at)}});
            json.update(figuresJson(placeStepFigures().of(step)));
            for (const ShadedPlace& with : place.withTrees)
                json.update(
                    figuresJson({placeStepFiguresWithTrees(with.column), &with.days[day].steps.at(i)}));
        }
        return steps;
    }

    static Json sums(const AreaHours& sums) { return figuresJson(areaHoursFigures().of(sums)); }

    static void addTrees(Json& json, const AreaHours& sums, TreeColumns column) {
        json.update(figuresJson({areaHoursFiguresWithTrees(column), &sums}));
    }

    [[nodiscard]] Json period(const PlaceTimeline& place) const {
        const PlaceSums& all = place.sums;
        Json months = Json::object(), quarters = Json::object(), whole = sums(all.all());
        for (const auto& [month, one] : all.months()) months[month] = sums(one);
        for (std::size_t i = 0; i < quarterNames.size(); ++i)
            if (all.quarters()[i].days > 0) quarters[quarterNames[i]] = sums(all.quarters()[i]);
        for (const ShadedPlace& with : place.withTrees) {
            addTrees(whole, with.sums.all(), with.column);
            for (const auto& [month, one] : with.sums.months()) addTrees(months[month], one, with.column);
            for (std::size_t i = 0; i < quarterNames.size(); ++i)
                if (with.sums.quarters()[i].days > 0)
                    addTrees(quarters[quarterNames[i]], with.sums.quarters()[i], with.column);
        }
        return {{"sums", whole},
                {"months", months},
                {"quarters", quarters},
                {"day_of_most_shadow", maximum(all.maxScenarioDay())},
                {"day_of_most_incremental", maximum(all.maxIncrementalDay())},
                {"largest_incremental_m2", round4(all.largestIncrementalM2())},
                {"largest_incremental_at", timeOr(all.largestIncrementalAt())}};
    }

private:
    static Json describe(const DayTimeline& day) {
        return {{"day", formatText(day.day)},
                {"sunlit_min", round4(day.sunlitMinutes)},
                {"times_too_late_by_up_to_min", round4(day.stepMinutes)},
                {"theoretical_m2h", round4(day.theoreticalM2h())}};
    }

    void addShadow(Json& json, const PlaceDays& place, std::size_t day, const std::string& suffix) const {
        const DayTimeline& own = place.days[day];
        json["full_cover_min" + suffix] = round4(own.fullCoverMin);
        json["all_sun_taken_min" + suffix] = round4(own.allSunTakenMin);
        const auto add = [&](const char* kind, const ShadowOnPlace& shadow) {
            const Json all = summary(shadow, own);  // items() refers to it
            for (const auto& [key, value] : all.items()) json[kind][key + suffix] = value;
        };
        add("baseline", own.baseline);
        add("scenario", own.scenario);
        add("incremental", own.incremental);
        add("gained", own.gained);
        if (const std::optional<LonLat>& at = place.longestIncrementalAt[day])
            json["incremental"]["longest_stay_at" + suffix] = {{"lon", at->lonDeg}, {"lat", at->latDeg}};
    }

    [[nodiscard]] Json timeOr(const std::optional<Instant>& at) const {
        return at ? Json(time(*at)) : Json();
    }
    [[nodiscard]] Json spanJson(const TimeSpan& span) const {
        return {{"from", time(span.from)}, {"to", time(span.to)}, {"minutes", round4(span.minutes())}};
    }
    static double share(double part, double whole) { return whole > 0 ? roundAsText(part / whole, 6) : 0; }
    static Json maximum(const std::optional<MaxShadowDay>& maximum) {
        if (!maximum) return {};
        return {{"day", formatText(maximum->day)}, {"m2h", round4(maximum->areaHoursM2)}};
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
              {"polygon_m2", round4(area(place.place))},
              {"area_m2", place.days.empty() ? 0 : round4(place.days.front().areaM2)},
              {"cell_m", study.cellM},
              {"step_min", round4(study.stepMinutes)},
              {"engine", study.engine}};
    if (place.days.size() == 1) {
        json.update(writer.day(place, 0));
        json["steps"] = writer.steps(place, 0);
    } else {
        Json days = Json::array();
        for (std::size_t i = 0; i < place.days.size(); ++i) {
            days.push_back(writer.day(place, i));
            if (!place.days[i].steps.empty()) days.back()["steps"] = writer.steps(place, i);
        }
        json.update(writer.period(place));
        json["days"] = days;
    }
    if (study.treesUsed > 0) json["trees_used"] = study.treesUsed;
    json["warnings"] = warningsJson(study.warnings);
    return json;
}

std::string timelineCsv(const PlaceStudy& study, const TimelineLabels& labels) {
    const TimelineWriter writer(labels.zone);
    std::vector<std::string> columns = listColumns(placeStepFigures().rows());
    columns.insert(columns.begin(), {"place", "day", "at"});
    if (!study.places.empty())
        for (const ShadedPlace& with : study.places.front().withTrees)
            std::ranges::move(listColumns(placeStepFiguresWithTrees(with.column)),
                              std::back_inserter(columns));
    CsvText csv(columns);
    for (const PlaceTimeline& place : study.places)
        for (std::size_t day = 0; day < place.days.size(); ++day)
            for (std::size_t i = 0; i < place.days[day].steps.size(); ++i) {
                const PlaceStep& step = place.days[day].steps[i];
                csv.text(place.place.name).text(formatText(place.days[day].day)).text(writer.time(step.at));
                addFigures(csv, placeStepFigures().of(step));
                for (const ShadedPlace& with : place.withTrees)
                    addFigures(csv, {placeStepFiguresWithTrees(with.column), &with.days[day].steps.at(i)});
                csv.endRow();
            }
    return csv.take();
}

}  // namespace noonmark
