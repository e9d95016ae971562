#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/engines/api/step_sets.h"
#include "core/receivers/place.h"
#include "core/study/by_place/cell_groups.h"

namespace noonmark {

/// For each place without a name of its own the place with a name that holds most of it or, if none does, the
/// one that lies along more than a fifth of its outline, as its index; none: there is none, or it has a
/// name. Streets and facades hold nothing and are part of nothing. Incomplete after a stop request. O(n log n
/// + pairs that meet).
std::vector<std::optional<std::size_t>> findWholes(const std::vector<Place>& places,
                                                   const std::stop_token& stop = {});

/// The seasons that the months belong to ("2026-01"), December to February first. Named winter to autumn as
/// they are at the latitude; within the tropics without a name.
std::vector<SunSeason> listSeasons(const std::vector<std::string>& months, double latDeg);

/// Whether a month ("2026-01") belongs to the season.
bool isIn(const SunSeason& season, const std::string& month);

/// Days of each month of the period, in order (monthsOf() in step_sets.h), with those on which the sun does
/// not rise.
std::vector<double> countDays(const SunSteps& sun);

/// The mean of the days of a period.
struct MeanDay {
    std::vector<float> grossMin;  ///< of each receiver, minutes in shadow
    double sunlitMin = 0;         ///< minutes with the sun above the horizon
};
/// From the minutes of all sets. `sun`: with a day.
MeanDay averageDay(const ShadowBreakdown& sums, const SunSteps& sun);

/// The same as a field over the grid, as `sums` state its engine.
ShadowField makeField(const ShadowBreakdown& sums, const MeanDay& day, const Receivers& receivers,
                      const SunSteps& sun);

/// States the figures of the period, its months and seasons of the places of a group in `sun`, which is of
/// all places of `made`. `sums`: by month, of which `day` is the mean day. Places without a cell have NaN.
void takeMonths(const SunByPlace& made, const CellGroup& group, const ShadowBreakdown& sums,
                const MeanDay& day, std::vector<SunOfPlace>& sun);

/// Adds the figures of the next date. Places without a cell have NaN.
void takeDate(const SunByPlace& made, const CellGroup& group, const MeanDay& day,
              std::vector<SunOfPlace>& sun);

}  // namespace noonmark
