#pragma once

#include "core/measures/error_sample.h"
#include "core/measures/shown_error.h"
#include "core/study/by_place/cell_groups.h"

namespace noonmark {

/// Cells of some places, on which the figures of places are held against the ray reference.
struct SampledPlaces {
    struct Part {
        std::vector<std::size_t> at;  ///< of SampledPlaces::cells
        std::vector<double> shares;   ///< of each, of which the sum is 1
    };
    std::vector<Part> places;
    std::vector<std::uint32_t> cells;  ///< ascending
};

/// Chooses places that have cells, spread evenly over all, and up to four cells of each: as a sample of the
/// place its mean is less exact than that of all its cells, so that the errors found are too large rather
/// than too small. Half as many cells as the sample of the study has.
SampledPlaces samplePlaces(const CellGroup& group, const ErrorSampleSettings& settings, std::size_t steps);

/// What hours of sun are computed from.
struct SunlitTime {
    double minutes = 0;        ///< of the period, with the sun above the horizon
    std::vector<double> days;  ///< of each set of steps
    double enoughHours = 0;    ///< of sun a day
};

/// Errors, and what those of shares are found from.
struct PlaceErrorList {
    std::vector<ShownError> errors{};
    std::vector<SampledShares> shares{};
};

/// Of the mean over the period, a month and the share with enough sun.
PlaceErrorList listPeriodErrors(const SampledPlaces& places, const ComparedSets& compared,
                                const SunlitTime& time);
/// The error of the share of the area with so many hours of sun a day.
ShownError errorOfShares(const SampledShares& sampled, double enoughHours);
/// Of the mean of each place over the period, minutes a day, absolute.
std::vector<double> listMeanDifferences(const SampledPlaces& places, const ComparedSets& compared,
                                        const SunlitTime& time);
/// Of the mean and the share with less than enough sun on a date.
PlaceErrorList listDateErrors(const SampledPlaces& places, const ComparedSets& compared,
                              const SunlitTime& time, const std::string& date);
/// Of what changes from one city to another over the period.
std::vector<ShownError> listChangeErrors(const SampledPlaces& places, const ComparedSets& before,
                                         const ComparedSets& after, const SunlitTime& time, double lossMin);

/// Warns in the first city's answer of places without figures, beyond its terrain and on its
/// water; states in all why places have none. `all`: the cells of all places. Error: cancelled().
Result<void> warnOfPlaces(std::span<const City* const> cities, std::vector<SunByPlace>& made,
                          const CellGroup& all, const std::stop_token& stop);

}  // namespace noonmark
