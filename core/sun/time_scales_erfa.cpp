#include "core/sun/time_scales.h"

#include <erfa.h>

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr double secondsPerDay = 86400;
constexpr double ttMinusTaiS = 32.184;
constexpr double j2000 = 2451545.0;  // Julian date of 2000-01-01 12:00
constexpr auto epoch = sys_days{2000y / January / 1} + 12h;

double utcDays(Instant at) { return duration<double>(at - epoch).count() / secondsPerDay; }

double ut1MinusUtcS(double utcDaysSinceEpoch) {
    constexpr double measuredS = 0.055;
    constexpr double from = 24 * 365.25;  // 2024
    constexpr double to = 26 * 365.25;    // 2026
    return measuredS * std::clamp((utcDaysSinceEpoch - from) / (to - from), 0.0, 1.0);
}

/// TT - UT1 in seconds before leap seconds were introduced; Espenak and Meeus, for 1900 to 1986.
double ttMinusUt1S(double year) {
    if (year < 1920) {
        const double t = year - 1900;
        return -2.79 + t * (1.494119 + t * (-0.0598939 + t * (0.0061966 - t * 0.000197)));
    }
    if (year < 1941) {
        const double t = year - 1920;
        return 21.20 + t * (0.84493 + t * (-0.076100 + t * 0.0020936));
    }
    const double t = year - (year < 1961 ? 1950 : 1975);
    return year < 1961 ? 29.07 + t * (0.407 + t * (-1 / 233.0 + t / 2547))
                       : 45.45 + t * (1.067 + t * (-1 / 260.0 - t / 718));
}

double taiMinusUtcS(Instant at) {
    const year_month_day date{floor<days>(at)};
    double seconds = 0;
    eraDat(int(date.year()), int(unsigned(date.month())), int(unsigned(date.day())), 0, &seconds);
    return seconds;
}

}  // namespace

double ut1Days(Instant at) {
    const double utc = utcDays(at);
    return utc + ut1MinusUtcS(utc) / secondsPerDay;
}

double ttDays(Instant at) {
    const double utc = utcDays(at);
    const bool leapSeconds = at >= sys_days{1972y / January / 1};
    const double offsetS = leapSeconds ? ttMinusTaiS + taiMinusUtcS(at) : ttMinusUt1S(2000 + utc / 365.25);
    return utc + offsetS / secondsPerDay;
}

Radians earthRotation(double ut1Days) { return {eraEra00(j2000, ut1Days)}; }

}  // namespace noonmark
