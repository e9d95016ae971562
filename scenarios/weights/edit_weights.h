#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "scenarios/weights/time_weights.h"

namespace noonmark {

// Tables to begin with. Which months and hours they name is a rule of thumb of Noonmark's own by latitude,
// degrees, negative in the south, where the seasons are half a year later; it knows no local climate. Hours
// are wall clock.

/// For people who walk and sit outside: shade is wanted at midday and in the afternoon of the hot months, sun
/// in winter; within the tropics shade all year. From 55 degrees only July (January) is hot. Its name is
/// "pedestrian comfort".
TimeWeights makeComfortWeights(double latitudeDeg);

/// For plants: sun is wanted all day (6:00 to 20:00) in the growing season, which is shorter the farther from
/// the equator; all year within the tropics. Its name is "plants".
TimeWeights makePlantWeights(double latitudeDeg);

/// A table with one more interval, and the index of that interval.
struct AddedInterval {
    TimeWeights table;
    std::size_t position = 0;
};

/// Adds an interval of weight 0, all day, on the first free days after the interval `after`, up to the next
/// interval or the end of the year. If no day is free, the new interval takes the later half of the days of
/// `after` with its hours and weight. Error: `after` covers a single day. The table must not be empty.
Result<AddedInterval> addInterval(TimeWeights table, std::size_t after);

/// Removes the interval at `position`. Error: it is the only one.
Result<TimeWeights> removeInterval(TimeWeights table, std::size_t position);

/// Hours of the day in whole months of every year.
struct MonthsAndHours {
    std::chrono::month firstMonth{1}, lastMonth{1};  ///< inclusive, the first not after the last
    int fromHour = 0, toHour = 24;                   ///< wall clock; the end is excluded
};

/// Gives this time one weight, or none. What an interval holds outside of it keeps its exact dates and hours,
/// its name and weight, in up to four pieces for each range of dates and hours. The painted interval joins
/// painted neighbours of the same weight, and the pieces around it of an interval in which it fills a hole.
/// Error: a time without an hour; a weight out of range; or no interval would be left.
Result<TimeWeights> paintWeights(const TimeWeights& table, const MonthsAndHours& time,
                                 std::optional<double> weight);

/// The weight that a table gives one hour of the day in one month.
struct WeightCell {
    bool isHeld = false;   ///< some of its time has a weight
    bool isMixed = false;  ///< some has another weight, or none
    double weight = 0;     ///< mean of the time that has one
};
/// The cells of a table by month and hour.
std::array<std::array<WeightCell, 24>, 12> weightGrid(const TimeWeights& table);

}  // namespace noonmark
