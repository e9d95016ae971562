#include "core/study/by_place/place_errors.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/city/map_context.h"
#include "core/city/terrain/post_grid.h"
#include "core/measures/places/place_cells.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr std::size_t cellsOfPart = 4;

std::vector<std::size_t> choosePlaces(const CellGroup& group, std::size_t count, std::uint32_t seed) {
    std::vector<std::size_t> withCells, chosen;
    for (std::size_t i = 0; i < group.cells.size(); ++i)
        if (!group.cells[i].empty()) withCells.push_back(i);
    std::mt19937 random(seed);
    std::ranges::sample(withCells, std::back_inserter(chosen), std::ptrdiff_t(count), random);
    return chosen;
}

std::vector<CountedCell> chooseCells(const std::vector<CountedCell>& all, std::mt19937& random) {
    std::vector<CountedCell> counted, chosen;
    std::ranges::copy_if(all, std::back_inserter(counted), [](const auto& one) { return one.share > 0; });
    std::ranges::sample(counted, std::back_inserter(chosen), std::ptrdiff_t(cellsOfPart), random);
    return chosen;
}

// The same of engine and reference.
using Minutes = std::vector<std::vector<double>>;

double sumOfSets(const Minutes& minutes, std::size_t cell) {
    double sum = 0;
    for (const auto& ofSet : minutes) sum += ofSet[cell];
    return sum;
}

template <class ValueAt>
double meanOf(const SampledPlaces::Part& part, const ValueAt& valueAt) {
    double mean = 0;
    for (std::size_t i = 0; i < part.at.size(); ++i) mean += part.shares[i] * valueAt(part.at[i]);
    return mean;
}

double sumOfDays(const SunlitTime& time) {
    return std::max(1.0, std::accumulate(time.days.begin(), time.days.end(), 0.0));
}

// Minutes of shadow a day.
double meanShadow(const SampledPlaces::Part& part, const Minutes& minutes, const SunlitTime& time) {
    return meanOf(part, [&](std::size_t cell) { return sumOfSets(minutes, cell) / sumOfDays(time); });
}

template <class Off>
std::vector<double> listOff(const SampledPlaces& places, const Off& offOf) {
    std::vector<double> off;
    for (const SampledPlaces::Part& part : places.places) off.push_back(std::abs(offOf(part)));
    return off;
}

template <class Off>
ShownError overPlaces(std::string_view key, const SampledPlaces& places, const Off& offOf,
                      const std::string& of = {}) {
    return sumUpError(key, listOff(places, offOf), of);
}

ShownError errorOfMeans(std::string_view key, const SampledPlaces& places, const ComparedSets& compared,
                        const SunlitTime& time, const std::string& of = {}) {
    return sumUpError(key, listMeanDifferences(places, compared, time), of);
}

SampledShares sampleShares(std::string_view key, const SampledPlaces& places, const ComparedSets& compared,
                           const SunlitTime& time, const std::string& of = {}) {
    SampledShares sampled{.key = std::string(key), .of = of};
    const auto sunMin = [&](const Minutes& minutes, std::size_t cell) {
        return (time.minutes - sumOfSets(minutes, cell)) / sumOfDays(time);
    };
    for (const SampledPlaces::Part& part : places.places) {
        auto& cells = sampled.places.emplace_back();
        for (std::size_t i = 0; i < part.at.size(); ++i)
            cells.push_back({sunMin(compared.minutes, part.at[i]), sunMin(compared.reference, part.at[i]),
                             part.shares[i]});
    }
    return sampled;
}

ShownError errorOfMonths(const SampledPlaces& places, const ComparedSets& compared, const SunlitTime& time) {
    std::vector<double> off;
    for (const SampledPlaces::Part& part : places.places)
        for (std::size_t month = 0; month < compared.minutes.size(); ++month)
            off.push_back(std::abs(meanOf(part, [&](std::size_t cell) {
                return (compared.minutes[month][cell] - compared.reference[month][cell]) / time.days[month];
            })));
    return sumUpError("place_month", std::move(off));
}

// More shadow a day than before, at each cell.
std::vector<double> listLosses(const Minutes& before, const Minutes& after, const SunlitTime& time) {
    std::vector<double> losses;
    for (std::size_t cell = 0; cell < before.front().size(); ++cell)
        losses.push_back((sumOfSets(after, cell) - sumOfSets(before, cell)) / sumOfDays(time));
    return losses;
}

}  // namespace

SampledPlaces samplePlaces(const CellGroup& group, const ErrorSampleSettings& settings, std::size_t steps) {
    const std::size_t count = std::max<std::size_t>(1, sampleSize(settings, steps) / 2 / cellsOfPart);
    std::mt19937 random(settings.seed);
    std::vector<std::vector<CountedCell>> chosen;
    SampledPlaces sample;
    for (const std::size_t place : choosePlaces(group, count, settings.seed)) {
        chosen.push_back(chooseCells(group.cells[place], random));
        for (const CountedCell& one : chosen.back()) sample.cells.push_back(one.cell);
    }
    std::ranges::sort(sample.cells);
    sample.cells.erase(std::unique(sample.cells.begin(), sample.cells.end()), sample.cells.end());
    for (const auto& cells : chosen) {
        SampledPlaces::Part part;
        double all = 0;
        for (const CountedCell& one : cells) all += one.share;
        for (const CountedCell& one : cells) {
            const auto at = std::ranges::lower_bound(sample.cells, one.cell) - sample.cells.begin();
            part.at.push_back(std::size_t(at));
            part.shares.push_back(one.share / all);
        }
        if (!part.at.empty()) sample.places.push_back(std::move(part));
    }
    return sample;
}

std::vector<double> listMeanDifferences(const SampledPlaces& places, const ComparedSets& compared,
                                        const SunlitTime& time) {
    return listOff(places, [&](const auto& part) {
        return meanShadow(part, compared.minutes, time) - meanShadow(part, compared.reference, time);
    });
}

ShownError errorOfShares(const SampledShares& sampled, double enoughHours) {
    std::vector<double> off;
    for (const auto& cells : sampled.places) {
        double difference = 0;
        for (const SampledShares::Cell& cell : cells) {
            const auto counts = [&](double sunMin) { return sunMin >= 60 * enoughHours ? cell.share : 0; };
            difference += counts(cell.sunMin) - counts(cell.referenceMin);
        }
        off.push_back(std::abs(difference));
    }
    return sumUpError(sampled.key, std::move(off), sampled.of);
}

PlaceErrorList listPeriodErrors(const SampledPlaces& places, const ComparedSets& compared,
                                const SunlitTime& time) {
    if (places.places.empty()) return {};
    const SampledShares shares = sampleShares("place_enough", places, compared, time);
    return {{errorOfMeans("place_mean", places, compared, time), errorOfMonths(places, compared, time),
             errorOfShares(shares, time.enoughHours)},
            {shares}};
}

PlaceErrorList listDateErrors(const SampledPlaces& places, const ComparedSets& compared,
                              const SunlitTime& time, const std::string& date) {
    if (places.places.empty()) return {};
    const SampledShares shares = sampleShares("place_below", places, compared, time, date);
    return {
        {errorOfMeans("place_date", places, compared, time, date), errorOfShares(shares, time.enoughHours)},
        {shares}};
}

std::vector<ShownError> listChangeErrors(const SampledPlaces& places, const ComparedSets& before,
                                         const ComparedSets& after, const SunlitTime& time, double lossMin) {
    if (places.places.empty()) return {};
    const std::vector<double> losses = listLosses(before.minutes, after.minutes, time);
    const std::vector<double> truths = listLosses(before.reference, after.reference, time);
    std::vector<double> off;
    for (std::size_t cell = 0; cell < losses.size(); ++cell)
        off.push_back(std::abs(losses[cell] - truths[cell]));
    const auto mean = [&](const auto& part, const std::vector<double>& values) {
        return meanOf(part, [&](std::size_t cell) { return values[cell]; });
    };
    const auto lost = [&](const auto& part, const std::vector<double>& values) {
        return meanOf(part, [&](std::size_t cell) { return values[cell] > lossMin ? 1.0 : 0.0; });
    };
    return {overPlaces("place_change", places,
                       [&](const auto& part) { return mean(part, losses) - mean(part, truths); }),
            sumUpError("cell_change", std::move(off)),
            overPlaces("place_lost", places,
                       [&](const auto& part) { return lost(part, losses) - lost(part, truths); })};
}

namespace {

bool isBuiltOver(std::span<const City* const> cities, const Place& place) {
    constexpr double nothingM2 = 0.01;
    const auto built = findBuiltGround(cities, std::span(&place, 1));
    const double openM2 = area(findOpenGround(place, built.front()));
    return openM2 < nothingM2;
}

// They stay in the tables, without figures.
void listPlacesWithoutCells(std::span<const City* const> cities, std::vector<SunByPlace>& all) {
    SunByPlace& baseline = all.front();
    for (std::size_t i = 0; i < baseline.places.size(); ++i) {
        if (baseline.sun[i].cells > 0) continue;
        const Place& place = baseline.places[i];
        const auto why = isBuiltOver(cities, place) ? PlaceStatus::builtOver : PlaceStatus::betweenCells;
        for (SunByPlace& made : all) made.sun[i].status = why;
        baseline.warnings.push_back(
            {WarningKind::leftOut, fmt::format("a place without figures: {}", describe(why)), place.name});
    }
}

// In the tables of all cities, and once as a warning.
void remark(std::vector<SunByPlace>& all, std::size_t place, PlaceRemark remark) {
    for (SunByPlace& made : all) made.sun[place].remarks.push_back(remark);
    const auto choices = placeRemarkChoices();
    const auto choice = std::ranges::find(choices, remark, &Choice<PlaceRemark>::value);
    all.front().warnings.push_back(
        {WarningKind::assumed, fmt::format("a place {}", choice->label), all.front().places[place].name});
}

bool isBeyond(const Terrain& terrain, const Place& place, const Grid& grid,
              const std::vector<CountedCell>& cells) {
    const auto columns = std::uint32_t(grid.columns);
    const auto isCellBeyond = [&](const CountedCell& one) {
        return beyondM(terrain.grid, grid.centre(int(one.cell % columns), int(one.cell / columns))) > 0;
    };
    const Box2 box = bounds(place);
    if (cells.empty()) return beyondM(terrain.grid, glm::dvec2(box.low + box.high) / 2.0) > 0;
    return std::ranges::any_of(cells, isCellBeyond);
}

void listPlacesBeyondTerrain(std::vector<SunByPlace>& all, const CellGroup& group) {
    const auto& terrain = all.front().city.terrain;
    if (!terrain) return;
    for (std::size_t i = 0; i < group.cells.size(); ++i)
        if (isBeyond(*terrain, all.front().places[i], group.on.receivers.grid, group.cells[i]))
            remark(all, i, PlaceRemark::beyondTerrain);
}

// They are measured all the same: a lake may be the place that matters.
Result<void> listPlacesOnWater(std::vector<SunByPlace>& made, const CellGroup& all,
                               const std::stop_token& stop) {
    const SunByPlace& baseline = made.front();
    const auto& map = baseline.city.context;
    if (!map || std::ranges::none_of(map->areas,
                                     [](const ContextArea& area) { return area.kind == ContextKind::water; }))
        return {};
    const auto dry =
        placeReceiversInPart(baseline.city, baseline.settings.study.region, all.on.receivers.grid, stop);
    if (!dry) return tl::make_unexpected(dry.error());
    for (std::size_t i = 0; i < all.cells.size(); ++i) {
        const auto wet = std::ranges::count_if(
            all.cells[i], [&](const CountedCell& one) { return dry->kind[one.cell] == CellKind::water; });
        if (2 * std::size_t(wet) > all.cells[i].size()) remark(made, i, PlaceRemark::onWater);
    }
    return {};
}

}  // namespace

Result<void> warnOfPlaces(std::span<const City* const> cities, std::vector<SunByPlace>& made,
                          const CellGroup& all, const std::stop_token& stop) {
    listPlacesWithoutCells(cities, made);
    listPlacesBeyondTerrain(made, all);
    return listPlacesOnWater(made, all, stop);
}

}  // namespace noonmark
