#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/describe/text.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

constexpr double minutesOfHour = 60;

Amount hoursOf(double hours) { return {hours * minutesOfHour, FigureUnit::hours}; }
Amount countOf(std::size_t count) { return {double(count), FigureUnit::none, 0}; }

// Over the area of the places; NaN: none has a cell. `of`: NaN counts as no cell.
template <class Of>
double meanOver(const SunByPlace& sun, Of of) {
    double area = 0, sum = 0;
    for (std::size_t i = 0; i < sun.sun.size(); ++i)
        if (const double value = of(i); !std::isnan(value)) {
            area += sun.sun[i].areaM2;
            sum += sun.sun[i].areaM2 * value;
        }
    return area > 0 ? sum / area : SunOfPlace::none;
}

Sentence countDark(const SunByPlace& sun) {
    std::size_t dark = 0, all = 0;
    for (const SunOfPlace& place : sun.sun) {
        if (std::isnan(place.meanHours)) continue;
        ++all;
        if (place.meanHours < sun.settings.enoughHours) ++dark;
    }
    return {NM_TEXT("%1 of %2 places have less than %3 of sun a day"),
            {countOf(dark), countOf(all), hoursOf(sun.settings.enoughHours)}};
}

Sentence describeMean(const SunByPlace& sun) {
    return {NM_TEXT("On average over their area %1, of %2 a day with the sun up."),
            {hoursOf(meanOver(sun, [&](std::size_t i) { return sun.sun[i].meanHours; })),
             hoursOf(sun.possibleHours)}};
}

Sentence describeLosses(const ComparedSun& compared) {
    constexpr double minuteHours = 1.0 / 60;  // less is left to the table
    std::size_t losing = 0;
    double largest = 0;
    for (const SunChange& change : compared.changes) {
        if (change.meanHours < -minuteHours) ++losing;
        largest = std::fmax(largest, change.maxLossMin);
    }
    return {NM_TEXT("%1 takes more than a minute of sun a day from %2 places, at most %3 at one spot."),
            {compared.sun.name, countOf(losing), Amount{largest, FigureUnit::minutes}}};
}

// Of "2026-01".
std::chrono::year_month parseMonth(const std::string& name) {
    int year = 0;
    unsigned month = 0;
    std::from_chars(name.data(), name.data() + 4, year);
    std::from_chars(name.data() + 5, name.data() + 7, month);
    return std::chrono::year(year) / std::chrono::month(month);
}

double monthHours(const SunByPlace& sun, std::size_t month) {
    return meanOver(sun, [&](std::size_t i) {
        return month < sun.sun[i].monthHours.size() ? sun.sun[i].monthHours[month] : SunOfPlace::none;
    });
}

Bars monthBars(const SunOfCities& sun) {
    Bars bars{.title = NM_TEXT("Hours of sun a day by month"), .series = {sun.baseline.name}};
    for (const ComparedSun& compared : sun.compared) bars.series.push_back(compared.sun.name);
    for (std::size_t month = 0; month < sun.baseline.months.size(); ++month) {
        Bars::Group group{
            parseMonth(sun.baseline.months[month]), {monthHours(sun.baseline, month)}, BarTone::sun};
        for (const ComparedSun& compared : sun.compared)
            group.values.push_back(monthHours(compared.sun, month));
        bars.groups.push_back(std::move(group));
    }
    return bars;
}

std::vector<std::size_t> listMostChanged(const SunOfCities& sun) {
    constexpr std::size_t maxCharted = 12;  // names below the bars stay readable
    const auto largest = [&](std::size_t place) {
        double change = 0;
        for (const ComparedSun& compared : sun.compared)
            change = std::fmax(change, std::abs(compared.changes[place].meanHours));
        return change;
    };
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < sun.baseline.sun.size(); ++i)
        if (largest(i) > 0) places.push_back(i);
    std::ranges::stable_sort(places, std::ranges::greater{}, largest);
    if (places.size() > maxCharted) places.resize(maxCharted);
    return places;
}

Bars placeBars(const SunOfCities& sun) {
    Bars bars{.title = NM_TEXT("Hours of sun a day of the places that change most"),
              .groupName = NM_TEXT("places"),
              .series = {sun.baseline.name}};
    for (const ComparedSun& compared : sun.compared) bars.series.push_back(compared.sun.name);
    for (const std::size_t place : listMostChanged(sun)) {
        Bars::Group group{sun.baseline.places[place].name, {sun.baseline.sun[place].meanHours}, BarTone::sun};
        for (const ComparedSun& compared : sun.compared)
            group.values.push_back(compared.sun.sun[place].meanHours);
        bars.groups.push_back(std::move(group));
    }
    return bars;
}

// Of several cities side by side, each with what changes against the baseline.
std::vector<Bars> chartsOf(const SunOfCities& sun) {
    const Bars months = monthBars(sun), places = placeBars(sun);
    if (sun.compared.empty()) return {months};
    return {months, changesOf(months, NM_TEXT("Change of the hours of sun a day by month")), places,
            changesOf(places, NM_TEXT("Change of the hours of sun a day of these places"))};
}

}  // namespace

AnswerPage makePage(const SunOfCities& sun) {
    const SunByPlace& shown = sun.compared.empty() ? sun.baseline : sun.compared.back().sun;
    AnswerPage page{countDark(shown), {describeMean(shown)}, chartsOf(sun)};
    for (const ComparedSun& compared : sun.compared) page.findings.push_back(describeLosses(compared));
    return page;
}

}  // namespace noonmark
