#include "core/measures/places/place_sums.h"

#include <fmt/format.h>
#include <algorithm>
#include <bit>

#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

bool hasBit(std::span<const std::uint64_t> words, std::uint32_t bit) {
    return (words[bit / 64] >> (bit % 64) & 1U) != 0;
}

}  // namespace

StepAreas weighStep(const PlaceShadow& shadow, std::size_t step, const StepCounts& counts) {
    const auto before = shadow.baseline.at(step), after = shadow.scenario.at(step);
    double baseline = double(counts.baseline), scenario = double(counts.scenario),
           incremental = double(counts.incremental),
           gained = double(counts.baseline + counts.incremental - counts.scenario);
    StepCounts centres = counts;
    for (const WeightedCell& cell : shadow.uneven) {
        const bool was = hasBit(before, cell.bit), is = hasBit(after, cell.bit);
        baseline += was ? cell.extra : 0;
        scenario += is ? cell.extra : 0;
        incremental += is && !was ? cell.extra : 0;
        gained += was && !is ? cell.extra : 0;
        if (!cell.isBeside) continue;
        centres.baseline -= was ? 1 : 0;
        centres.scenario -= is ? 1 : 0;
        centres.incremental -= is && !was ? 1 : 0;
    }
    // Shares that add up to nothing leave a rounding error, which is no shadow.
    const auto area = [&](double cells, std::size_t count) {
        return count == 0 ? 0 : std::max(0.0, cells * shadow.cellAreaM2);
    };
    return {area(baseline, counts.baseline), area(scenario, counts.scenario),
            area(incremental, counts.incremental),
            area(gained, counts.baseline + counts.incremental - counts.scenario), centres};
}

std::size_t countCentres(const PlaceShadow& shadow) {
    const auto beside = std::ranges::count_if(shadow.uneven, &WeightedCell::isBeside);
    return shadow.baseline.receivers - std::size_t(beside);
}

StepMasks dropEdgeCells(const PlaceShadow& shadow, const StepMasks& masks) {
    StepMasks kept = masks;
    for (const WeightedCell& cell : shadow.uneven)
        for (std::size_t step = 0; cell.isBeside && step < kept.steps; ++step)
            kept.at(step)[cell.bit / 64] &= ~(std::uint64_t{1} << cell.bit % 64);
    return kept;
}

std::uint64_t bitsAt(std::span<const std::uint64_t> words, std::size_t bit) {
    const std::size_t word = bit / 64, shift = bit % 64;
    if (word >= words.size()) return 0;
    std::uint64_t bits = words[word] >> shift;
    if (shift != 0 && word + 1 < words.size()) bits |= words[word + 1] << (64 - shift);
    return bits;
}

std::size_t countEdges(std::span<const std::uint64_t> words, std::span<const NeighbourCells> neighbours) {
    std::size_t edges = 0;
    for (const NeighbourCells& pairs : neighbours)
        for (std::uint32_t done = 0; done < pairs.count; done += 64) {
            const std::uint32_t left = std::min(64U, pairs.count - done);
            const std::uint64_t differ =
                bitsAt(words, pairs.first + done) ^ bitsAt(words, pairs.second + done);
            edges += std::size_t(std::popcount(differ & ~std::uint64_t{0} >> (64 - left)));
        }
    return edges;
}

namespace {

void takeMore(std::optional<MaxShadowDay>& maximum, CivilDate day, double areaHoursM2) {
    if (areaHoursM2 > (maximum ? maximum->areaHoursM2 : 0)) maximum = MaxShadowDay{day, areaHoursM2};
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
    takeMore(maxScenarioDay_, day.day, day.scenario.areaHoursM2);
    takeMore(maxIncrementalDay_, day.day, day.incremental.areaHoursM2);
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

std::span<const Figure> placeStepFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(placeStepFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(placeStepFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::span<const Figure> areaHoursFiguresWithTrees(TreeColumns column) {
    // The first three are those without any shadow.
    static const std::span<const Figure> rows = areaHoursFigures().rows().subspan(3);
    static const FiguresWithTrees evergreen(rows, TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(rows, TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

}  // namespace noonmark
