#include "core/study/by_place/place_errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

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

double enoughShare(const SampledPlaces::Part& part, const Minutes& minutes, const SunlitTime& time) {
    return meanOf(part, [&](std::size_t cell) {
        const double sunMin = (time.minutes - sumOfSets(minutes, cell)) / sumOfDays(time);
        return sunMin >= 60 * time.enoughHours ? 1.0 : 0.0;
    });
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

ShownError errorOfShares(std::string_view key, const SampledPlaces& places, const ComparedSets& compared,
                         const SunlitTime& time, const std::string& of = {}) {
    return overPlaces(
        key, places,
        [&](const auto& part) {
            return enoughShare(part, compared.minutes, time) - enoughShare(part, compared.reference, time);
        },
        of);
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
    sample.cells.erase(std::ranges::unique(sample.cells).begin(), sample.cells.end());
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

std::vector<ShownError> listPeriodErrors(const SampledPlaces& places, const ComparedSets& compared,
                                         const SunlitTime& time) {
    if (places.places.empty()) return {};
    return {errorOfMeans("place_mean", places, compared, time), errorOfMonths(places, compared, time),
            errorOfShares("place_enough", places, compared, time)};
}

std::vector<ShownError> listDateErrors(const SampledPlaces& places, const ComparedSets& compared,
                                       const SunlitTime& time, const std::string& date) {
    if (places.places.empty()) return {};
    return {errorOfMeans("place_date", places, compared, time, date),
            errorOfShares("place_below", places, compared, time, date)};
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

}  // namespace noonmark
