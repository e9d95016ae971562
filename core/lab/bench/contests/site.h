#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark::bench {

/// Place and time of the experiments.
struct BenchSite {
    City city;
    std::string name;                       ///< name of the city, for pages
    std::string zone = "America/New_York";  ///< IANA name
    /// Date of experiments on one day; those over a year use its calendar year.
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    double sideM = 800;      ///< side of the measured squares; cells of 1 m unless stated otherwise
    std::uint32_t seed = 1;  ///< seed of every random choice
};

/// A square of `sideM` around the middle of the city, or the whole city if it is smaller.
Region pickMiddleSquare(const City& city, double sideM);

/// Squares around randomly chosen buildings, moved so that they lie inside the city if it is large enough.
std::vector<Region> pickRandomSquares(const BenchSite& site, int count);

/// Random days of the site's year, in order.
std::vector<CivilDate> pickRandomDays(const BenchSite& site, int count);

/// Steps of an hour in all experiments: one a minute.
inline constexpr int stepsPerHour = 60;

/// Every minute of `hours` per day around noon: 6 h begin at 9:00, as in the paper.
Result<SunSteps> computeSunOver(const BenchSite& site, CivilDate start, int days, double hours = 6);
Result<SunSteps> computeYearSun(const BenchSite& site, double hours = 6);

/// The hour from noon of the site's date, every minute.
Result<SunSteps> makeNoonHour(const BenchSite& site);

/// Every minute from sunrise to sunset.
Result<SunSteps> daylightOf(const BenchSite& site, CivilDate date);

/// `count` steps of one day of `sun` from step `first` on, as a day of their own.
SunSteps sliceSteps(const SunSteps& sun, std::size_t first, std::size_t count);

/// The values of `cellsASide` whose cells have an allowed size.
std::vector<int> chooseResolutions(const BenchSite& site, std::vector<int> cellsASide);

/// Receivers on the ground of the middle square, with `cellsASide` cells along each side (cells are 0.25 to
/// 10 m).
Result<Receivers> placeReceiversAt(const BenchSite& site, int cellsASide, const std::stop_token& stop);

/// The same in cells of 1 m.
Result<Receivers> pickMiddleReceivers(const BenchSite& site, const std::stop_token& stop);

/// A random sample of whole squares of 8 x 8 cells with at least `count` receivers (all if there are fewer).
/// Neighbours stay together, so that a cell costs an engine as much as it does among all cells.
Receivers sampleOf(const Receivers& receivers, std::size_t count, std::uint32_t seed);

}  // namespace noonmark::bench
