#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark::bench {

/// Where and when the experiments are made.
struct BenchSite {
    City city;
    std::string name;                       ///< of the city, for pages
    std::string zone = "America/New_York";  ///< IANA
    /// Of experiments on one day; those on a year take its calendar year.
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    double sideM = 800;      ///< of the squares whose ground is measured; cells of 1 m unless said
    std::uint32_t seed = 1;  ///< of every random choice
};

/// `sideM` around the middle of the city, or its whole where it is smaller.
Region pickMiddleSquare(const City& city, double sideM);

/// Squares around randomly chosen buildings, moved so that they lie inside the city where it is large enough.
std::vector<Region> pickRandomSquares(const BenchSite& site, int count);

/// Days of the site's year, chosen at random, in order.
std::vector<CivilDate> pickRandomDays(const BenchSite& site, int count);

/// Every minute of `hours` a day around noon: 6 h begin at 9:00, as in the paper.
Result<SunSteps> computeSunOver(const BenchSite& site, CivilDate start, int days, double hours = 6);
Result<SunSteps> computeYearSun(const BenchSite& site, double hours = 6);

/// The hour from noon of the site's date, every minute.
Result<SunSteps> makeNoonHour(const BenchSite& site);

/// Every minute from sunrise to sunset.
Result<SunSteps> daylightOf(const BenchSite& site, CivilDate date);

/// `count` steps of one day of `sun` from `first` on, as a day of its own.
SunSteps stretchOf(const SunSteps& sun, std::size_t first, std::size_t count);

/// Those of `cellsASide` that make cells of the sizes that receivers may have.
std::vector<int> chooseResolutions(const BenchSite& site, std::vector<int> cellsASide);

/// The ground of the middle square, cut into so many cells a side (cells are 0.25 to 10 m).
Result<Receivers> placeReceiversAt(const BenchSite& site, int cellsASide, const std::stop_token& stop);

/// The same in cells of 1 m.
Result<Receivers> pickMiddleReceivers(const BenchSite& site, const std::stop_token& stop);

/// Whole squares of 8 x 8 cells, chosen at random until at least `count` receivers are in (all where there
/// are fewer): neighbours stay together, so that a cell costs an engine what it costs among all.
Receivers sampleOf(const Receivers& receivers, std::size_t count, std::uint32_t seed);

}  // namespace noonmark::bench
