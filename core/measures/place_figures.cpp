#include "core/measures/place_figures.h"

#include "core/describe/text.h"

namespace noonmark {

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
