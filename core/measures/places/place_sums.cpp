#include "core/measures/places/place_sums.h"

#include <fmt/format.h>

#include "core/describe/text.h"

namespace noonmark {

namespace {

void takeMore(std::optional<MostShadow>& most, CivilDate day, double areaHoursM2) {
    if (areaHoursM2 > (most ? most->areaHoursM2 : 0)) most = MostShadow{day, areaHoursM2};
}

}  // namespace

void AreaHours::add(const DayTimeline& day) {
    ++days;
    sunlitHours += day.sunlitMinutes / 60;
    theoreticalM2h += day.theoreticalM2h();
    baselineM2h += day.baseline.areaHoursM2;
    scenarioM2h += day.scenario.areaHoursM2;
    incrementalM2h += day.incremental.areaHoursM2;
    gainedM2h += day.gained.areaHoursM2;
}

Quarter quarterOf(CivilDate day) {
    const unsigned at = unsigned(day.month()) * 100 + unsigned(day.day());
    if (at < 321 || at >= 1221) return Quarter::fromDecember;
    if (at < 621) return Quarter::fromMarch;
    return at < 921 ? Quarter::fromJune : Quarter::fromSeptember;
}

void PlaceSums::add(const DayTimeline& day) {
    all_.add(day);
    quarters_[std::size_t(quarterOf(day.day))].add(day);
    months_[fmt::format("{:04}-{:02}", int(day.day.year()), unsigned(day.day.month()))].add(day);
    takeMore(mostScenario_, day.day, day.scenario.areaHoursM2);
    takeMore(mostIncremental_, day.day, day.incremental.areaHoursM2);
    if (day.incremental.largestM2 > largestM2_) {
        largestM2_ = day.incremental.largestM2;
        largestAt_ = day.incremental.largestAt;
    }
}

namespace {

constexpr int digits = 4;       // of numbers in JSON
constexpr int shareDigits = 6;  // of shares

Figure area(double PlaceStep::*member, std::string_view key, std::string_view label,
            std::string_view definition) {
    return figure(member, {.key = key,
                           .label = label,
                           .definition = definition,
                           .decimals = 2,
                           .jsonDecimals = digits,
                           .unit = FigureUnit::squareMetres});
}

Figure areaHours(double AreaHours::*member, std::string_view key, std::string_view label,
                 std::string_view definition) {
    return figure(member, {.key = key,
                           .label = label,
                           .definition = definition,
                           .jsonDecimals = digits,
                           .unit = FigureUnit::squareMetreHours});
}

Figure share(double (*get)(const AreaHours&), std::string_view key, std::string_view label) {
    return derivedFigure(get, {.key = key,
                               .label = label,
                               .definition = NM_TEXT("of the theoretical area x hours"),
                               .jsonDecimals = shareDigits,
                               .unit = FigureUnit::share,
                               .shownDecimals = 3});
}

}  // namespace

const Figures<PlaceStep>& placeStepFigures() {
    static const Figures<PlaceStep> figures{
        area(&PlaceStep::baselineM2, "baseline_m2", NM_TEXT("Baseline"),
             NM_TEXT("area in shadow in the baseline")),
        area(&PlaceStep::scenarioM2, "scenario_m2", NM_TEXT("Scenario"),
             NM_TEXT("area in shadow in the scenario")),
        area(&PlaceStep::incrementalM2, "incremental_m2", NM_TEXT("Incremental"),
             NM_TEXT("area in shadow in the scenario, lit in the baseline")),
        area(&PlaceStep::gainedM2, "gained_m2", NM_TEXT("Gained"),
             NM_TEXT("area lit in the scenario, in shadow in the baseline")),
    };
    return figures;
}

const Figures<AreaHours>& areaHoursFigures() {
    static const Figures<AreaHours> figures{
        figure(&AreaHours::days, {.key = "days", .label = NM_TEXT("Days"), .use = FigureUse::basis}),
        figure(&AreaHours::sunlitHours, {.key = "sunlit_h",
                                         .label = NM_TEXT("Hours of sun"),
                                         .definition = NM_TEXT("hours with the sun above the horizon"),
                                         .jsonDecimals = digits,
                                         .use = FigureUse::basis}),
        areaHours(&AreaHours::theoreticalM2h, "theoretical_m2h", NM_TEXT("Theoretical"),
                  NM_TEXT("area x sunlit hours: without any shadow")),
        areaHours(&AreaHours::baselineM2h, "baseline_m2h", NM_TEXT("Baseline"),
                  NM_TEXT("area x hours in shadow in the baseline")),
        areaHours(&AreaHours::scenarioM2h, "scenario_m2h", NM_TEXT("Scenario"),
                  NM_TEXT("area x hours in shadow in the scenario")),
        areaHours(&AreaHours::incrementalM2h, "incremental_m2h", NM_TEXT("Incremental"),
                  NM_TEXT("area x hours in shadow in the scenario, lit in the baseline")),
        areaHours(&AreaHours::gainedM2h, "gained_m2h", NM_TEXT("Gained"),
                  NM_TEXT("area x hours lit in the scenario, in shadow in the baseline")),
        share([](const AreaHours& sums) { return sums.shareOf(sums.baselineM2h); }, "baseline_share",
              NM_TEXT("Share of baseline")),
        share([](const AreaHours& sums) { return sums.shareOf(sums.scenarioM2h); }, "scenario_share",
              NM_TEXT("Share of scenario")),
        share([](const AreaHours& sums) { return sums.shareOf(sums.incrementalM2h); }, "incremental_share",
              NM_TEXT("Share of incremental")),
    };
    return figures;
}

}  // namespace noonmark
