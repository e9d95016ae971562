#include "app/gui/docks/study_form/period_preset.h"

#include <QObject>
#include <algorithm>

namespace noonmark {

namespace {

using std::chrono::sys_days;

int daysUntil(CivilDate first, CivilDate last) { return int((sys_days(last) - sys_days(first)).count()) + 1; }

Period withDays(Period period, CivilDate first, CivilDate last) {
    period.start = first;
    period.days = daysUntil(first, last);
    return period;
}

// Of a long time all its sun is asked for, not that of some hours of the clock.
Period withSeason(Period period, CivilDate first, CivilDate last) {
    if (!period.window) period.window = SolarHours{};
    return withDays(std::move(period), first, last);
}

}  // namespace

QString nameOf(PeriodPreset preset, double latitudeDeg) {
    switch (preset) {
        case PeriodPreset::today:
            return QObject::tr("Today");
        case PeriodPreset::march:
            return QObject::tr("21 March");
        case PeriodPreset::june:
            return QObject::tr("21 June");
        case PeriodPreset::december:
            return QObject::tr("21 December");
        case PeriodPreset::growingSeason:
            return latitudeDeg < 0 ? QObject::tr("Growing season (October to April)")
                                   : QObject::tr("Growing season (April to October)");
        case PeriodPreset::year:
            return QObject::tr("Whole year");
        case PeriodPreset::own:
            return QObject::tr("Own dates");
    }
    return {};
}

Period applied(PeriodPreset preset, Period period, CivilDate today, double latitudeDeg) {
    using namespace std::chrono;
    const auto year = period.start.year();
    const auto oneDay = [&](CivilDate date) { return withDays(period, date, date); };
    switch (preset) {
        case PeriodPreset::today:
            return oneDay(today);
        case PeriodPreset::march:
            return oneDay(year / March / 21);
        case PeriodPreset::june:
            return oneDay(year / June / 21);
        case PeriodPreset::december:
            return oneDay(year / December / 21);
        case PeriodPreset::growingSeason:
            if (latitudeDeg < 0)
                return withSeason(period, year / October / 1, (year + years(1)) / April / 30);
            return withSeason(period, year / April / 1, year / October / 31);
        case PeriodPreset::year:
            return withSeason(period, year / January / 1, year / December / 31);
        case PeriodPreset::own:
            break;
    }
    return period;
}

PeriodPreset presetOf(const Period& period, CivilDate today, double latitudeDeg) {
    return *std::ranges::find_if(allPeriodPresets, [&](PeriodPreset preset) {
        const Period there = applied(preset, period, today, latitudeDeg);
        return there.start == period.start && there.days == period.days;
    });
}

}  // namespace noonmark
