#include "core/study/text/point_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>

#include "core/base/csv_text.h"
#include "core/base/json_number.h"
#include "core/base/safe_text.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/tree_shade.h"

namespace noonmark {

namespace {

using PointJson = nlohmann::ordered_json;

std::string dayText(CivilDate date) {
    constexpr std::array months{"January", "February", "March",     "April",   "May",      "June",
                                "July",    "August",   "September", "October", "November", "December"};
    return fmt::format("{} {}", unsigned(date.day()), months[unsigned(date.month()) - 1]);
}

std::string clockText(std::chrono::minutes time) {
    return fmt::format("{:02}:{:02}", time.count() / 60, time.count() % 60);
}

std::string durationText(double minutes) {
    const long whole = std::lround(minutes);
    if (whole < 60) return fmt::format("{} min", whole);
    return fmt::format("{} h {:02} min", whole / 60, whole % 60);
}

std::string seasonText(const SeasonOfLoss& season, std::size_t daysOfYear) {
    const std::string when =
        season.days == int(daysOfYear) ? std::string("all year")
        : season.first == season.last
            ? "on " + dayText(season.first)
            : fmt::format("between {} and {}", dayText(season.first), dayText(season.last));
    return fmt::format("{}, mostly {}-{}", when, clockText(season.mostlyFrom), clockText(season.mostlyTo));
}

std::string describeLosses(const PointStudy& study) {
    const auto& losses = study.losses;
    if (losses.empty()) return "The proposal takes no sun from this point on any day of the year.";
    const auto amount = [](const SeasonOfLoss& season) {
        return season.minutesPerDay < 1 ? std::string("less than 1 min a day")
                                        : fmt::format("{} a day", durationText(season.minutesPerDay));
    };
    std::string text = fmt::format("The proposal takes {} from this point {}", amount(losses.front()),
                                   seasonText(losses.front(), study.sun.dayCount()));
    if (losses.size() > 1)
        text += fmt::format(", and {} {}", amount(losses[1]), seasonText(losses[1], study.sun.dayCount()));
    if (losses.size() > 2) {
        const int days =
            std::accumulate(losses.begin() + 2, losses.end(), 0,
                            [](int sum, const SeasonOfLoss& season) { return sum + season.days; });
        text += fmt::format(", and some on {}", countOf(std::uint64_t(days), "other day"));
    }
    return text + ".";
}

// The building that makes most of the skyline.
std::string widestObstacle(const PointStudy& study, const City& city) {
    const auto widths = skylineWidthsDeg(study.baseline, study.question.facingDeg);
    if (widths.empty()) return {};
    const auto widest = std::ranges::max_element(widths, {}, [](const auto& entry) { return entry.second; });
    return fmt::format("; {} makes {:.0f} degrees of its skyline", nameOfObstacle(city, widest->first),
                       widest->second);
}

std::string describeDay(const PointStudy& study, const City& city) {
    const auto& bands = study.baseline.sunlit;
    const double minutes =
        std::accumulate(bands.begin(), bands.end(), 0.0,
                        [](double sum, const SunBand& band) { return sum + band.minutes(); });
    const auto months = sumMonths(study.baseline.minutes);
    const double year = std::accumulate(months.begin(), months.end(), 0.0);
    const double share = study.possibleMin > 0 ? 100 * year / study.possibleMin : 0;
    const std::string day = bands.empty() ? "gets no sun"
                                          : fmt::format("gets {} of sun in {}", durationText(minutes),
                                                        countOf(bands.size(), "band"));
    return fmt::format("On {} this point {}, and over the year {:.0f} % of the time the sun is up{}.",
                       dayText(study.question.day), day, share, widestObstacle(study, city));
}

PointJson bandsJson(const std::vector<SunBand>& bands, const Zone& zone) {
    PointJson list = PointJson::array();
    for (const SunBand& band : bands)
        list.push_back({{"from", zone.text(std::chrono::round<std::chrono::seconds>(band.from))},
                        {"to", zone.text(std::chrono::round<std::chrono::seconds>(band.to))},
                        {"minutes", roundAsText(band.minutes(), 2)}});
    return list;
}

PointJson shadedJson(const PointView& view, const City& city, const Zone& zone) {
    PointJson list = PointJson::array();
    for (const ShadedTime& time : view.shadedTimes)
        list.push_back({{"from", zone.text(std::chrono::round<std::chrono::seconds>(time.when.from))},
                        {"to", zone.text(std::chrono::round<std::chrono::seconds>(time.when.to))},
                        {"minutes", roundAsText(time.when.minutes(), 2)},
                        {"building", nameOfObstacle(city, time.building)}});
    return list;
}

// Each sunlit run of steps is too long or too short by up to a step, at random at each of its ends: two
// standard deviations of their sum over the year.
double computeYearErrorMin(const PointView& view, const SunSteps& sun) {
    std::size_t runs = 0;
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i)
            runs += view.shaded[i] == 0 && (i == day.first || view.shaded[i - 1] != 0) ? 1 : 0;
    return 2 * sun.stepMinutes * std::sqrt(double(runs) / 6);
}

PointJson errorJson(const PointView& view, const PointStudy& study) {
    return {{"sunlit_end_s", 0.1},
            {"unseen_shorter_than_min", std::min(1.0, study.question.stepMinutes)},
            {"year_min", roundAsText(computeYearErrorMin(view, study.sun), 1)}};
}

std::string clockText(const SunBand& band, const Zone& zone) {
    const auto clock = [&zone](Instant at) {
        return zone.text(std::chrono::round<std::chrono::minutes>(at)).substr(11, 5);
    };
    return clock(band.from) + "-" + clock(band.to);
}

PointJson skylineJson(const PointView& view) {
    PointJson list = PointJson::array();
    for (const SkylinePlace& place : view.skyline)
        list.push_back({roundAsText(place.azimuthDeg, 4), roundAsText(place.altitudeDeg, 4)});
    return list;
}

PointJson stretchesJson(const PointView& view, const City& city) {
    PointJson list = PointJson::array();
    for (const SkylineStretch& stretch : view.stretches)
        list.push_back({{"from_deg", roundAsText(stretch.fromDeg, 3)},
                        {"to_deg", roundAsText(stretch.toDeg, 3)},
                        {"building", nameOfObstacle(city, stretch.building)}});
    return list;
}

PointJson crownJson(const SeenCrown& crown, const City& city) {
    const auto highest = std::ranges::max(crown.columns, {}, &CrownColumn::highDeg);
    const auto lowest = std::ranges::min(crown.columns, {}, &CrownColumn::lowDeg);
    const std::string id =
        city.trees && crown.tree < city.trees->trees.size() ? city.trees->trees[crown.tree].sourceId : "";
    return {{"tree", id},
            {"from_deg", roundAsText(crown.columns.front().azimuthDeg, 2)},
            {"to_deg", roundAsText(std::fmod(crown.columns.back().azimuthDeg, 360.0), 2)},
            {"low_deg", roundAsText(lowest.lowDeg, 2)},
            {"high_deg", roundAsText(highest.highDeg, 2)},
            {"distance_m", roundAsText(crown.distanceM, 1)},
            {"transmissivity_in_leaf", roundAsText(crown.leafOnTransmissivity, 4)},
            {"transmissivity_bare", roundAsText(crown.leafOffTransmissivity, 4)}};
}

PointJson listRounded(std::span<const double> values) {
    PointJson list = PointJson::array();
    for (const double value : values) list.push_back(roundAsText(value, 1));
    return list;
}

// Nearest first.
PointJson crownsJson(const PointCrowns& crowns, const City& city) {
    PointJson list = PointJson::array();
    for (auto crown = crowns.seen.rbegin(); crown != crowns.seen.rend(); ++crown)
        list.push_back(crownJson(*crown, city));
    return {{"used", crowns.weighed},
            {"leaf_on_day_of_year", crowns.leafDays.on},
            {"leaf_off_day_of_year", crowns.leafDays.off},
            {"in_leaf_on_the_day", crowns.inLeaf},
            {"crowns", list}};
}

PointJson takenJson(const PointCrowns& crowns) {
    PointJson list = PointJson::array();
    for (const TreeMinutes& one : listTakenByTree(crowns))
        list.push_back({{"tree", crowns.trees->trees[one.tree].sourceId},
                        {"species", crowns.trees->trees[one.tree].species},
                        {"day_min_evergreen", roundAsText(one.dayEvergreen, 2)},
                        {"day_min_seasonal", roundAsText(one.daySeasonal, 2)},
                        {"year_min_evergreen", roundAsText(one.yearEvergreen, 1)},
                        {"year_min_seasonal", roundAsText(one.yearSeasonal, 1)}});
    return list;
}

void addCrowns(PointJson& json, const PointCrowns& crowns, const City& city, bool wall, const Zone& zone) {
    json["trees"] = crownsJson(crowns, city);
    json["taken_by_tree"] = takenJson(crowns);
    for (const TreeColumns column : PointCrowns::columns) {
        const PointShade& shade = crowns.of(column);
        const std::string trees = suffixOf(column);
        json["sunlit" + trees] = bandsJson(shade.sunlit, zone);
        json["sunlit_min" + trees] = roundAsText(shade.dayMin, 2);
        json["minutes_by_month" + trees] = listRounded(sumMonths(shade.minutes));
        json["svf" + trees] = roundAsText(shade.sky.skyView, 5);
        if (wall) json["vsc_pct" + trees] = roundAsText(shade.sky.skyComponentPct, 3);
    }
}

void addView(PointJson& json, const PointView& view, const PointStudy& study, const City& city,
             const Zone& zone) {
    json["skyline"] = skylineJson(view);
    json["skyline_buildings"] = stretchesJson(view, city);
    json["sunlit"] = bandsJson(view.sunlit, zone);
    json["shaded"] = shadedJson(view, city, zone);
    json["error"] = errorJson(view, study);
    PointJson hours = PointJson::array();
    for (const auto& month : view.minutes) hours.push_back(listRounded(month));
    json["minutes_by_month"] = listRounded(sumMonths(view.minutes));
    json["minutes_by_month_and_hour"] = hours;
    if (view.crowns) addCrowns(json, *view.crowns, city, study.question.facingDeg.has_value(), zone);
    json["svf"] = roundAsText(view.factors.skyView, 5);
    if (study.question.facingDeg) json["vsc_pct"] = roundAsText(view.factors.skyComponentPct, 3);
}

}  // namespace

std::string nameOfObstacle(const City& city, std::uint32_t building) {
    if (building == SkyObstacles::terrain) return "the terrain";
    if (building == SkyObstacles::ownWall) return "the wall itself";
    if (building >= city.buildings.size()) return "a building";
    const Building& found = *city.buildings[building];
    return found.name.empty() ? found.sourceId : found.name;
}

std::string describe(const PointStudy& study, const City& city) {
    return study.scenario ? describeLosses(study) : describeDay(study, city);
}

PointJson pointJson(const PointStudy& study, const City& city, const City* scenarioCity, const Zone& zone) {
    PointJson json;
    json["at"] = {study.question.at.lonDeg, study.question.at.latDeg};
    json["height_m"] =
        roundAsText(double(study.position.z) - double(groundAt(city, glm::dvec2(study.position))), 3);
    json["on_roof"] = study.onRoof;
    if (study.question.facingDeg) json["facing_deg"] = *study.question.facingDeg;
    json["day"] = formatText(study.question.day);
    json["zone"] = zone.name();
    json["step_minutes"] = study.question.stepMinutes;
    addView(json, study.baseline, study, city, zone);
    if (study.scenario) {
        PointJson scenario;
        addView(scenario, *study.scenario, study, scenarioCity != nullptr ? *scenarioCity : city, zone);
        json["scenario"] = scenario;
    }
    json["sentence"] = describe(study, city);
    json["seconds"] = roundAsText(study.seconds, 4);
    return json;
}

PointJson pointCasesJson(const std::vector<PointCaseFigures>& cases, bool wall) {
    PointJson list = PointJson::array();
    for (const PointCaseFigures& figures : cases) {
        PointJson one{{"name", figures.name}};
        if (!figures.why.empty()) {
            one["not_measured"] = figures.why;
        } else {
            one["day_min"] = roundAsText(figures.dayMin, 2);
            one["year_min"] = roundAsText(figures.yearMin, 1);
            one["svf"] = roundAsText(figures.skyView, 5);
            if (wall) one["vsc_pct"] = roundAsText(figures.skyComponentPct, 3);
            for (const PointCaseShade& with : figures.withTrees) {
                const std::string trees = suffixOf(with.column);
                one["day_min" + trees] = roundAsText(with.dayMin, 2);
                one["year_min" + trees] = roundAsText(with.yearMin, 1);
                one["svf" + trees] = roundAsText(with.skyView, 5);
                if (wall) one["vsc_pct" + trees] = roundAsText(with.skyComponentPct, 3);
            }
        }
        list.push_back(std::move(one));
    }
    return list;
}

std::map<std::uint32_t, double> skylineWidthsDeg(const PointView& view,
                                                 const std::optional<double>& facingDeg) {
    std::map<std::uint32_t, double> widths;
    for (const SkylineStretch& stretch : view.stretches) {
        const double width = std::fmod(stretch.toDeg - stretch.fromDeg + 360, 360);
        // From the left end of what the wall faces, which is 180 degrees wide; beyond 360 it begins again.
        const double from = facingDeg ? std::fmod(stretch.fromDeg - *facingDeg + 90 + 720, 360) : 0;
        const double to = from + width;
        const double seen =
            facingDeg ? std::max(0.0, std::min(to, 180.0) - from) + std::max(0.0, std::min(to, 540.0) - 360)
                      : width;
        if (seen > 0) widths[stretch.building] += seen;
    }
    return widths;
}

std::string sunlitText(const std::vector<SunBand>& sunlit, const Zone& zone) {
    std::string text;
    for (const SunBand& band : sunlit) text += (text.empty() ? "" : ", ") + clockText(band, zone);
    return text.empty() ? "not at all" : text;
}

std::string treesText(const PointCrowns& crowns) {
    const auto hours = [](const MonthHours& minutes) {
        const auto months = sumMonths(minutes);
        return std::accumulate(months.begin(), months.end(), 0.0) / 60;
    };
    return fmt::format(
        "{:.0f} min on the day and {:.0f} h in the year with their seasons, {:.0f} min and {:.0f} h "
        "as evergreens",
        crowns.seasonal.dayMin, hours(crowns.seasonal.minutes), crowns.evergreen.dayMin,
        hours(crowns.evergreen.minutes));
}

std::string takenText(const PointCrowns& crowns) {
    constexpr std::size_t maximum = 3;
    const std::vector<TreeMinutes> trees = listTakenByTree(crowns);
    std::string text;
    for (std::size_t i = 0; i < std::min(maximum, trees.size()); ++i) {
        const Tree& tree = crowns.trees->trees[trees[i].tree];
        text += fmt::format(
            "{}{} {:.0f} min on the day, {:.1f} h in the year", i > 0 ? "; " : "",
            tree.species.empty() ? tree.sourceId : fmt::format("{} ({})", tree.species, tree.sourceId),
            trees[i].daySeasonal, trees[i].yearSeasonal / 60);
    }
    if (trees.size() > maximum) text += fmt::format("; {} more", trees.size() - maximum);
    return text;
}

std::string treesSkyText(const PointCrowns& crowns, bool wall) {
    std::string text = fmt::format("sky view factor {:.3f} with their seasons, {:.3f} as evergreens",
                                   crowns.seasonal.sky.skyView, crowns.evergreen.sky.skyView);
    if (wall)
        text += fmt::format("; vertical sky component {:.1f} % and {:.1f} %",
                            crowns.seasonal.sky.skyComponentPct, crowns.evergreen.sky.skyComponentPct);
    return text;
}

std::string shadedText(const PointView& view, const City& city, const Zone& zone) {
    std::string text;
    for (const ShadedTime& time : view.shadedTimes)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", nameOfObstacle(city, time.building),
                            clockText(time.when, zone));
    return text.empty() ? "nothing" : text;
}

std::string pointCsv(const PointStudy& study) {
    std::vector<std::string> columns{"month", "hour"};
    std::vector<const MonthHours*> values;
    const auto add = [&](const std::string& name, const MonthHours& minutes) {
        columns.push_back(name);
        values.push_back(&minutes);
    };
    const auto addView = [&](const std::string& name, const PointView& view) {
        add(name, view.minutes);
        if (!view.crowns) return;
        for (const TreeColumns column : PointCrowns::columns)
            add(name + suffixOf(column), view.crowns->of(column).minutes);
    };
    addView("baseline_min", study.baseline);
    if (study.scenario) addView("scenario_min", *study.scenario);
    CsvText csv(columns);
    for (std::size_t month = 0; month < study.baseline.minutes.size(); ++month)
        for (std::size_t hour = 0; hour < study.baseline.minutes[month].size(); ++hour) {
            csv.whole(month + 1).whole(hour);
            for (const MonthHours* minutes : values) csv.number((*minutes)[month][hour], 2);
            csv.endRow();
        }
    return csv.take();
}

}  // namespace noonmark
