#include "scenarios/weights/weight_templates.h"

#include <cmath>

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr double tropicDeg = 23.44, subtropicsDeg = 40, coldDeg = 55;

// Months of the northern half of the earth, and hours.
struct Season {
    const char* name;
    unsigned firstMonth, lastMonth;
    int fromHour, toHour;
    double weight;
};

month monthAt(unsigned northern, double latitudeDeg) {
    return month(latitudeDeg < 0 ? (northern + 5) % 12 + 1 : northern);
}

WeightedInterval seasonInterval(const Season& season, double latitudeDeg) {
    const month first = monthAt(season.firstMonth, latitudeDeg),
                last = monthAt(season.lastMonth, latitudeDeg);
    return {.name = season.name,
            .first = first / 1,
            .last = month_day(last, (2000y / last / std::chrono::last).day()),
            .from = hours(season.fromHour),
            .to = hours(season.toHour),
            .weight = season.weight};
}

TimeWeights makeSeasons(const char* name, const std::vector<Season>& seasons, double latitudeDeg) {
    TimeWeights table{name, {}};
    for (const Season& season : seasons) table.intervals.push_back(seasonInterval(season, latitudeDeg));
    return table;
}

std::vector<Season> comfortSeasons(double fromEquatorDeg) {
    if (fromEquatorDeg < tropicDeg) return {{"hot all year", 1, 12, 10, 17, 1}};
    if (fromEquatorDeg < subtropicsDeg)
        return {{"hot months", 6, 8, 10, 18, 1},
                {"before the hot months", 4, 5, 11, 17, 0.5},
                {"after the hot months", 9, 10, 11, 17, 0.5},
                {"winter", 12, 2, 9, 16, -0.5}};
    if (fromEquatorDeg < coldDeg)
        return {{"hot months", 6, 8, 11, 17, 1},
                {"before the hot months", 5, 5, 12, 16, 0.5},
                {"after the hot months", 9, 9, 12, 16, 0.5},
                {"winter", 11, 2, 9, 16, -1},
                {"early spring", 3, 3, 9, 17, -0.5}};
    return {{"hot month", 7, 7, 12, 16, 0.5}, {"winter", 10, 4, 9, 17, -1}};
}

Season growingSeason(double fromEquatorDeg) {
    if (fromEquatorDeg < tropicDeg) return {"growing season", 1, 12, 6, 20, -1};
    if (fromEquatorDeg < subtropicsDeg) return {"growing season", 3, 10, 6, 20, -1};
    if (fromEquatorDeg < coldDeg) return {"growing season", 4, 9, 6, 20, -1};
    return {"growing season", 5, 8, 6, 20, -1};
}

}  // namespace

TimeWeights makeComfortWeights(double latitudeDeg) {
    return makeSeasons("pedestrian comfort", comfortSeasons(std::abs(latitudeDeg)), latitudeDeg);
}

TimeWeights makePlantWeights(double latitudeDeg) {
    return makeSeasons("plants", {growingSeason(std::abs(latitudeDeg))}, latitudeDeg);
}

}  // namespace noonmark
