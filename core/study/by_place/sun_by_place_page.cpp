#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

Amount hoursOf(double hours) { return {hours * minutesPerHour, FigureUnit::hours}; }
Amount shadowOf(double sunHours, double possibleHours) {
    return {(possibleHours - sunHours) * minutesPerHour, FigureUnit::minutes, 0};
}
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

// On a date. Its shadow is known only where it is a day of the period.
SunOrShadow on(const SunByPlace& sun, std::size_t date, const SunOrShadow& as) {
    const CivilDate& wanted = sun.settings.dates[date];
    return {as.show, possibleHoursOn(sun, [&](const CivilDate& day) { return day == wanted; })};
}

Sentence countDark(const SunByPlace& sun, const SunOrShadow& as) {
    std::size_t dark = 0, all = 0;
    for (const SunOfPlace& place : sun.sun) {
        if (std::isnan(place.meanHours)) continue;
        ++all;
        if (place.meanHours < sun.settings.enoughHours) ++dark;
    }
    return {as.isSun() ? NM_TEXT("%1 of %2 places have less than %3 of sun a day")
                       : NM_TEXT("%1 of %2 places lie in shadow for more than %3 a day"),
            {countOf(dark), countOf(all), as.amount(sun.settings.enoughHours)}};
}

Sentence countDarkOn(const SunByPlace& sun, std::size_t date, const SunOrShadow& as) {
    std::size_t dark = 0, all = 0;
    for (const SunOfPlace& place : sun.sun) {
        if (date >= place.dateHours.size() || std::isnan(place.dateHours[date])) continue;
        ++all;
        if (place.dateHours[date] < sun.settings.enoughHours) ++dark;
    }
    const SunOrShadow then = on(sun, date, as);
    return {then.isSun() ? NM_TEXT("On %1, %2 of %3 places have less than %4.")
                         : NM_TEXT("On %1, %2 of %3 places lie in shadow for more than %4."),
            {formatText(sun.settings.dates[date]), countOf(dark), countOf(all),
             then.amount(sun.settings.enoughHours)}};
}

// The places with names of their own that have least and most sun; nothing of fewer than two.
std::optional<Sentence> describeExtremes(const SunByPlace& sun, const SunOrShadow& as) {
    std::vector<std::size_t> named;
    for (std::size_t i = 0; i < sun.sun.size(); ++i)
        if (hasOwnName(sun.places[i]) && !std::isnan(sun.sun[i].meanHours)) named.push_back(i);
    if (named.size() < 2) return std::nullopt;
    const auto [minimum, maximum] =
        std::ranges::minmax(named, {}, [&](std::size_t i) { return sun.sun[i].meanHours; });
    return Sentence{as.isSun() ? NM_TEXT("%1 has the least sun, %2 a day, and %3 the most, %4.")
                               : NM_TEXT("%1 has the most shadow, %2 a day, and %3 the least, %4."),
                    {sun.places[minimum].name, as.amount(sun.sun[minimum].meanHours),
                     sun.places[maximum].name, as.amount(sun.sun[maximum].meanHours)}};
}

Sentence describeMean(const SunByPlace& sun, const SunOrShadow& as) {
    return {as.isSun() ? NM_TEXT("On average over their area %1 a day, of %2 without any shadow.")
                       : NM_TEXT("On average over their area %1 of shadow a day, of %2 of daylight."),
            {as.amount(meanOver(sun, [&](std::size_t i) { return sun.sun[i].meanHours; })),
             hoursOf(sun.possibleHours)}};
}

// What wanted shade leaves of the sun.
std::vector<Sentence> describeWithTrees(const SunByPlace& sun, const SunOrShadow& as) {
    std::vector<Sentence> sentences;
    for (const SunWithTrees& with : sun.withTrees) {
        const double hours = meanOver(sun, [&](std::size_t i) { return with.sun[i].meanHours; });
        sentences.push_back({with.column == TreeColumns::evergreen
                                 ? NM_TEXT("With trees as evergreens it is %1 a day.")
                                 : NM_TEXT("With trees that lose their leaves by season it is %1 a day."),
                             {as.amount(hours)}});
    }
    return sentences;
}

struct SunLosses {
    std::size_t places = 0;  // that lose more than a minute a day; less is left to the table
    double largestMin = 0;   // at one spot
};

SunLosses sumUpLosses(const std::vector<SunChange>& changes) {
    constexpr double minuteHours = 1.0 / 60;
    SunLosses losses;
    for (const SunChange& change : changes) {
        if (change.meanHours < -minuteHours) ++losses.places;
        losses.largestMin = std::fmax(losses.largestMin, change.maxLossMin);
    }
    return losses;
}

Sentence describeLosses(const ComparedSun& compared, const SunOrShadow& as) {
    const SunLosses losses = sumUpLosses(compared.changes);
    const Amount largest{losses.largestMin, FigureUnit::minutes};
    if (losses.places == 1)
        return {
            as.isSun()
                ? NM_TEXT("%1 takes more than a minute of sun a day from one place, at most %2 at one spot.")
                : NM_TEXT("%1 adds more than a minute of shadow a day to one place, at most %2 at one spot."),
            {compared.sun.name, largest}};
    return {as.isSun()
                ? NM_TEXT("%1 takes more than a minute of sun a day from %2 places, at most %3 at one spot.")
                : NM_TEXT("%1 adds more than a minute of shadow a day to %2 places, at most %3 at one spot."),
            {compared.sun.name, countOf(losses.places), largest}};
}

// Trees that a scenario plants or fells change nothing in the column without them.
std::vector<Sentence> describeLossesWithTrees(const ComparedSun& compared) {
    std::vector<Sentence> sentences;
    for (std::size_t i = 0; i < std::min(compared.changesWithTrees.size(), compared.sun.withTrees.size());
         ++i) {
        const SunLosses losses = sumUpLosses(compared.changesWithTrees[i]);
        sentences.push_back(
            {compared.sun.withTrees[i].column == TreeColumns::evergreen
                 ? NM_TEXT("With trees as evergreens their number is %1, at most %2 at one spot.")
                 : NM_TEXT(
                       "With trees that lose their leaves by season their number is %1, at most %2 at one "
                       "spot."),
             {countOf(losses.places), Amount{losses.largestMin, FigureUnit::minutes}}});
    }
    return sentences;
}

double monthHours(const SunOfPlace& of, std::size_t month) {
    return month < of.monthHours.size() ? of.monthHours[month] : SunOfPlace::none;
}

double monthHours(const SunByPlace& sun, std::size_t month) {
    return meanOver(sun, [&](std::size_t i) { return monthHours(sun.sun[i], month); });
}

// `hoursOf`: of a city and the index of a month.
template <class HoursOf>
Bars monthBars(const SunOfCities& sun, const HoursOf& hoursOf) {
    Bars bars{.title = NM_TEXT("Hours of sun a day by month"), .series = {sun.baseline.name}};
    for (const ComparedSun& compared : sun.compared) bars.series.push_back(compared.sun.name);
    for (std::size_t month = 0; month < sun.baseline.months.size(); ++month) {
        Bars::Group group{
            monthOfKey(sun.baseline.months[month]), {hoursOf(sun.baseline, month)}, BarTone::sun};
        for (const ComparedSun& compared : sun.compared) group.values.push_back(hoursOf(compared.sun, month));
        bars.groups.push_back(std::move(group));
    }
    return bars;
}

double possibleIn(const SunByPlace& sun, std::size_t month) {
    const auto wanted = monthOfKey(sun.months[month]);
    return possibleHoursOn(sun,
                           [wanted](const CivilDate& day) { return day.year() / day.month() == wanted; });
}

// As minutes of shadow where the days of the months are known.
Bars barsAsShown(Bars hours, const SunOfCities& sun, const SunOrShadow& as) {
    if (as.isSun() || sun.baseline.months.empty() || std::isnan(possibleIn(sun.baseline, 0))) return hours;
    hours.title = NM_TEXT("Minutes of shadow a day by month");
    for (std::size_t month = 0; month < hours.groups.size(); ++month) {
        hours.groups[month].tone = BarTone::amount;
        for (double& value : hours.groups[month].values)
            value = shadowOf(value, possibleIn(sun.baseline, month)).value;
    }
    return hours;
}

// In minutes, as the table and the map state changes.
Bars changesInMinutes(const Bars& hours, std::string_view title) {
    Bars changes = changesOf(hours, title);
    for (Bars::Group& group : changes.groups)
        for (double& value : group.values) value *= minutesPerHour;
    return changes;
}

bool isShadow(const Bars& bars) { return !bars.groups.empty() && bars.groups.front().tone != BarTone::sun; }

std::vector<Bars> monthCharts(const SunOfCities& sun, const Bars& months, const SunOrShadow& as) {
    const Bars shown = barsAsShown(months, sun, as);
    if (sun.compared.empty()) return {shown};
    return {shown, isShadow(shown)
                       ? changesOf(shown, NM_TEXT("Change of the minutes of shadow a day by month"))
                       : changesInMinutes(shown, NM_TEXT("Change of the minutes of sun a day by month"))};
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
    const auto& all = sun.baseline.places;
    const bool anyNamed = std::ranges::any_of(all, hasOwnName);  // the others are stated by their kind's row
    for (std::size_t i = 0; i < all.size(); ++i)
        if (largest(i) > 0 && (hasOwnName(all[i]) || !anyNamed)) places.push_back(i);
    std::ranges::stable_sort(places, std::ranges::greater{}, largest);
    if (places.size() > maxCharted) places.resize(maxCharted);
    return places;
}

Bars placeBars(const SunOfCities& sun, const SunOrShadow& as) {
    Bars bars{.title = as.isSun() ? NM_TEXT("Hours of sun a day of the places that change most")
                                  : NM_TEXT("Minutes of shadow a day of the places that change most"),
              .groupName = NM_TEXT("places"),
              .series = {sun.baseline.name}};
    const auto shown = [&](double hours) {
        return as.isSun() ? hours : shadowOf(hours, as.possibleHours).value;
    };
    for (const ComparedSun& compared : sun.compared) bars.series.push_back(compared.sun.name);
    for (const std::size_t place : listMostChanged(sun)) {
        Bars::Group group{sun.baseline.places[place].name,
                          {shown(sun.baseline.sun[place].meanHours)},
                          as.isSun() ? BarTone::sun : BarTone::amount};
        for (const ComparedSun& compared : sun.compared)
            group.values.push_back(shown(compared.sun.sun[place].meanHours));
        bars.groups.push_back(std::move(group));
    }
    return bars;
}

Bars changesOfPlaces(const Bars& places) {
    return isShadow(places)
               ? changesOf(places, NM_TEXT("Change of the minutes of shadow a day of these places"))
               : changesInMinutes(places, NM_TEXT("Change of the minutes of sun a day of these places"));
}

// Of several cities side by side, each with what changes against the baseline.
std::vector<Bars> chartsOf(const SunOfCities& sun, const SunOrShadow& as) {
    std::vector<Bars> charts = monthCharts(
        sun,
        monthBars(sun, [](const SunByPlace& city, std::size_t month) { return monthHours(city, month); }),
        as);
    if (sun.compared.empty()) return charts;
    charts.push_back(placeBars(sun, as));
    charts.push_back(changesOfPlaces(charts.back()));
    return charts;
}

double meanLossMin(const ComparedSun& compared) {
    return -minutesPerHour *
           meanOver(compared.sun, [&](std::size_t i) { return compared.changes[i].meanHours; });
}

Amount inMinutes(double minutes) { return {minutes, FigureUnit::minutes}; }

// Of several scenarios, which takes less: the one with the smallest mean loss against that with the largest.
std::vector<Sentence> judgeCities(const SunOfCities& sun) {
    if (sun.compared.size() < 2) return {};
    const auto [minimum, maximum] = std::ranges::minmax_element(sun.compared, {}, meanLossMin);
    if (meanLossMin(*minimum) == meanLossMin(*maximum))
        return {{NM_TEXT("%1 and %2 take the same sun: %3 a day on average over the places."),
                 {minimum->sun.name, maximum->sun.name, inMinutes(meanLossMin(*minimum))}}};
    return {{NM_TEXT("%1 takes less sun than %2: %3 against %4 a day on average over the places."),
             {minimum->sun.name, maximum->sun.name, inMinutes(meanLossMin(*minimum)),
              inMinutes(meanLossMin(*maximum))}}};
}

Sentence headlineOf(const std::string& name, const SunOfPlace& of, double enoughHours,
                    const SunOrShadow& as) {
    if (std::isnan(of.meanHours)) return {NM_TEXT("%1: no open ground was measured"), {name}};
    return {as.isSun() ? NM_TEXT("%1: %2 of sun a day; %3 of its area has %4 or more")
                       : NM_TEXT("%1: %2 of shadow a day; %3 of its area has %4 or less"),
            {name, as.amount(of.meanHours), Amount{of.enoughShare, FigureUnit::share, 0},
             as.amount(enoughHours)}};
}

Sentence describeWithTrees(const SunWithTrees& with, std::size_t place, double enoughHours,
                           const SunOrShadow& as) {
    const std::vector<Sentence::Argument> arguments{as.amount(with.sun[place].meanHours),
                                                    Amount{with.sun[place].enoughShare, FigureUnit::share, 0},
                                                    as.amount(enoughHours)};
    if (with.column == TreeColumns::evergreen)
        return {as.isSun() ? NM_TEXT("With trees as evergreens: %1; %2 of its area has %3 or more.")
                           : NM_TEXT("With trees as evergreens: %1; %2 of its area has %3 or less."),
                arguments};
    return {as.isSun()
                ? NM_TEXT("With trees that lose their leaves by season: %1; %2 of its area has %3 or more.")
                : NM_TEXT("With trees that lose their leaves by season: %1; %2 of its area has %3 or less."),
            arguments};
}

Sentence describeDate(const SunByPlace& sun, std::size_t place, std::size_t date, const SunOrShadow& as) {
    const SunOfPlace& of = sun.sun[place];
    const SunOrShadow then = on(sun, date, as);
    return {then.isSun() ? NM_TEXT("On %1 it has %2; %3 of its area has less than %4.")
                         : NM_TEXT("On %1 it lies in shadow for %2; %3 of its area for more than %4."),
            {formatText(sun.settings.dates[date]), then.amount(of.dateHours[date]),
             Amount{of.belowShare[date], FigureUnit::share, 0}, then.amount(sun.settings.enoughHours)}};
}

Sentence describeChange(const ComparedSun& compared, std::size_t place, const SunOrShadow& as) {
    const SunChange& change = compared.changes[place];
    const double lossMin = -minutesPerHour * change.meanHours;
    if (lossMin < 0)
        return {as.isSun() ? NM_TEXT("%1 gives it %2 of sun a day, at most %3 at one spot.")
                           : NM_TEXT("%1 reduces its shadow by %2 a day, at most %3 at one spot."),
                {compared.sun.name, inMinutes(-lossMin), inMinutes(change.maxGainMin)}};
    return {as.isSun() ? NM_TEXT("%1 takes %2 of sun a day from it, at most %3 at one spot.")
                       : NM_TEXT("%1 adds %2 of shadow a day to it, at most %3 at one spot."),
            {compared.sun.name, inMinutes(lossMin), inMinutes(change.maxLossMin)}};
}

}  // namespace

std::chrono::year_month monthOfKey(std::string_view key) {
    int year = 0;
    unsigned month = 0;
    if (key.size() == 7 && key[4] == '-') {
        std::from_chars(key.data(), key.data() + 4, year);
        std::from_chars(key.data() + 5, key.data() + 7, month);
    }
    return std::chrono::year(year) / std::chrono::month(month);
}

SunOfPlace averagePlaces(const SunByPlace& sun) {
    SunOfPlace all;
    for (const SunOfPlace& place : sun.sun) {
        all.cells += place.cells;
        all.areaM2 += place.areaM2;
    }
    all.meanHours = meanOver(sun, [&](std::size_t i) { return sun.sun[i].meanHours; });
    all.enoughShare = meanOver(sun, [&](std::size_t i) { return sun.sun[i].enoughShare; });
    for (std::size_t month = 0; month < sun.months.size(); ++month)
        all.monthHours.push_back(monthHours(sun, month));
    return all;
}

bool SunOrShadow::isSun() const { return show == ShownAs::sun || std::isnan(possibleHours); }

Amount SunOrShadow::amount(double sunHours) const {
    return isSun() ? hoursOf(sunHours) : shadowOf(sunHours, possibleHours);
}

double possibleHoursOn(const SunByPlace& sun, const std::function<bool(const CivilDate&)>& has) {
    std::size_t steps = 0, days = 0;
    for (const SunDay& day : sun.daylight.days) {
        if (!has(day.date)) continue;
        steps += day.count;
        ++days;
    }
    return days == 0 ? SunOfPlace::none
                     : double(steps) * sun.daylight.stepMinutes / minutesPerHour / double(days);
}

AnswerPage makePage(const SunOfCities& sun, ShownAs show) {
    const SunByPlace& shown = shownCity(sun);
    const SunOrShadow as{show, sun.baseline.possibleHours};
    AnswerPage page{countDark(shown, as), {describeMean(shown, as)}, chartsOf(sun, as)};
    for (Sentence& sentence : describeWithTrees(shown, as)) page.findings.push_back(std::move(sentence));
    for (Sentence& sentence : judgeCities(sun)) page.findings.push_back(std::move(sentence));
    for (const ComparedSun& compared : sun.compared) {
        page.findings.push_back(describeLosses(compared, as));
        std::ranges::move(describeLossesWithTrees(compared), std::back_inserter(page.findings));
    }
    for (std::size_t date = 0; date < shown.settings.dates.size(); ++date)
        page.findings.push_back(countDarkOn(shown, date, as));
    if (const auto extremes = describeExtremes(shown, as)) page.findings.push_back(*extremes);
    return page;
}

AnswerPage makePage(const SunOfCities& sun, std::size_t place, ShownAs show) {
    const SunByPlace& shown = shownCity(sun);
    const SunOfPlace& of = shown.sun[place];
    const SunOrShadow as{show, sun.baseline.possibleHours};
    AnswerPage page{headlineOf(shown.places[place].name, of, shown.settings.enoughHours, as)};
    if (std::isnan(of.meanHours)) return page;
    for (const SunWithTrees& with : shown.withTrees)
        page.findings.push_back(describeWithTrees(with, place, shown.settings.enoughHours, as));
    for (const ComparedSun& compared : sun.compared)
        page.findings.push_back(describeChange(compared, place, as));
    for (std::size_t date = 0; date < of.dateHours.size(); ++date)
        page.findings.push_back(describeDate(shown, place, date, as));
    page.charts =
        monthCharts(sun,
                    monthBars(sun, [place](const SunByPlace& city,
                                           std::size_t month) { return monthHours(city.sun[place], month); }),
                    as);
    return page;
}

}  // namespace noonmark
