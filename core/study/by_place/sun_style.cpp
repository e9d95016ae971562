#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/study/by_place/place_errors.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

ColourScale makeScaleOf(const std::vector<double>& hours, const SunByPlace& sun,
                        const PlaceColours& colours) {
    return makeThresholdScale(colours.legend, colours.thresholdHours.value_or(sun.settings.enoughHours),
                              hours);
}

// The same classes in the same colours, in whole minutes of shadow, so that the legend can be read.
ColourScale asShadow(const ColourScale& hours, double possibleHours) {
    ColourScale minutes = hours;
    minutes.quantity = {ShownAs::shadow, minutesPerHour * possibleHours};
    minutes.paintsZero = true;
    minutes.low = std::max(0.0, shadowMinOf(hours.high, possibleHours));
    minutes.high = shadowMinOf(hours.low, possibleHours);
    std::ranges::reverse(minutes.breaks);
    for (double& at : minutes.breaks) at = std::round(shadowMinOf(at, possibleHours));
    return minutes;
}

ColourScale makeShownScale(const std::vector<double>& hours, const SunByPlace& sun,
                           const PlaceColours& colours, const ShownSunOrShadow& shown) {
    const ColourScale scale = makeScaleOf(hours, sun, colours);
    return shown.isShadow ? asShadow(scale, shown.possibleHours) : scale;
}

ShownSunOrShadow chooseShown(const PlaceColours& colours, double possibleHours) {
    return {colours.legend.show == ShownAs::shadow && possibleHours > 0, possibleHours};
}

std::string_view unitOf(const ShownSunOrShadow& shown) {
    return shown.isShadow ? "Minutes of shadow a day" : "Hours of sun a day";
}

// In tables of all columns.
std::string suffixOf(const PlaceColours& colours) {
    const TreeColumns column = colours.column.value_or(TreeColumns::without);
    return column == TreeColumns::without ? std::string() : noonmark::suffixOf(column);
}

// A place without cells has none.
LayerStyle makePartStyle(const SunByPlace& sun, const PlaceColours& colours, const SunPart& part) {
    std::vector<double> hours;
    for (const SunOfPlace& one : sun.sun)
        if (part.index < (one.*part.hours).size()) hours.push_back((one.*part.hours)[part.index]);
    const ShownSunOrShadow shown = chooseShown(colours, part.possibleHours);
    const std::string name = part.of == SunPart::Of::season ? sun.seasons[part.index].label : part.key;
    return {
        fmt::format("{}, {}", unitOf(shown), name),
        graduatedStyle(StyledShape::polygons,
                       (shown.isShadow ? shadowColumn(part.key) : hoursColumn(part.key)) + suffixOf(colours),
                       styleClasses(makeShownScale(hours, sun, colours, shown)))};
}

// Dates first.
std::vector<LayerStyle> makePartStyles(const SunByPlace& sun, const PlaceColours& colours) {
    std::vector<LayerStyle> styles;
    const std::vector<SunPart> parts = listParts(sun);
    for (const bool isDate : {true, false})
        for (const SunPart& part : parts)
            if ((part.of == SunPart::Of::date) == isDate) styles.push_back(makePartStyle(sun, colours, part));
    return styles;
}

}  // namespace

double ShownSunOrShadow::of(double sunHours) const {
    return isShadow ? shadowMinOf(sunHours, possibleHours) : sunHours;
}

ShownSunOrShadow chooseShown(const SunByPlace& sun, const PlaceColours& colours) {
    if (!colours.date) return chooseShown(colours, sun.possibleHours);
    const CivilDate& date = sun.settings.dates[*colours.date];
    return chooseShown(colours, possibleHoursOn(sun, [&](const CivilDate& day) { return day == date; }));
}

double hoursOf(const SunOfPlace& of, std::optional<std::size_t> date) {
    if (!date) return of.meanHours;
    return *date < of.dateHours.size() ? of.dateHours[*date] : SunOfPlace::none;
}

ColourScale makeScale(const SunByPlace& sun, const PlaceColours& colours) {
    std::vector<double> hours;
    for (const SunOfPlace& of : sun.sun) hours.push_back(hoursOf(of, colours.date));
    return makeShownScale(hours, sun, colours, chooseShown(sun, colours));
}

LayerStyle makeStyle(const SunByPlace& sun, const PlaceColours& colours) {
    const std::vector<ColourClass> classes = styleClasses(makeScale(sun, colours));
    const ShownSunOrShadow shown = chooseShown(sun, colours);
    return {std::string(unitOf(shown)),
            graduatedStyle(StyledShape::polygons,
                           (shown.isShadow ? shadowColumn("mean") : hoursColumn("mean")) + suffixOf(colours),
                           classes),
            {},
            makePartStyles(sun, colours)};
}

namespace {

/// Less is rounding.
constexpr double noChangeMin = 1e-3;

SunChange changeOf(const SunOfPlace& before, const SunOfPlace& after, double lossMin) {
    if (before.ofCells.empty()) return {};
    SunChange change{after.meanHours - before.meanHours, 0, 0, 0};
    const bool anyInside = std::ranges::any_of(before.ofCells, &SunOfCell::isInside);
    double all = 0, lost = 0;
    for (std::size_t i = 0; i < before.ofCells.size(); ++i) {
        const SunOfCell& cell = before.ofCells[i];
        const double gainMin = 60 * (double(after.ofCells[i].hours) - double(cell.hours));
        all += double(cell.share);
        if (-gainMin > lossMin + noChangeMin) lost += double(cell.share);
        if (anyInside && !cell.isInside) continue;
        if (gainMin < -noChangeMin) change.maxLossMin = std::max(change.maxLossMin, -gainMin);
        if (gainMin > noChangeMin) change.maxGainMin = std::max(change.maxGainMin, gainMin);
    }
    change.lostShare = lost / all;
    return change;
}

// Cells hold float hours: compared with 4.1 as float, 4.1 is enough. `hoursOf`: of the cell with an index.
template <class HoursOf>
double enoughShareOf(const SunOfPlace& of, double hours, const HoursOf& hoursOf) {
    double all = 0, enough = 0;
    for (std::size_t i = 0; i < of.ofCells.size(); ++i) {
        const auto share = double(of.ofCells[i].share);
        all += share;
        if (hoursOf(i) >= float(hours)) enough += share;
    }
    return enough / all;
}

// NaN: no receiver.
bool isSameMinute(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool hasCells(const SunByPlace& sun) {
    return std::ranges::any_of(sun.sun, [](const SunOfPlace& of) { return !of.ofCells.empty(); });
}

void restate(std::vector<SunOfPlace>& sun, double hours) {
    for (SunOfPlace& of : sun) {
        if (of.ofCells.empty()) continue;
        of.enoughShare = computeEnoughShare(of, hours);
        for (std::size_t date = 0; date < of.dateHoursOfCells.size(); ++date)
            of.belowShare[date] = computeBelowShare(of, date, hours);
    }
}

void restate(SunByPlace& sun, double hours) {
    sun.settings.enoughHours = hours;
    restate(sun.sun, hours);
    for (SunWithTrees& with : sun.withTrees) restate(with.sun, hours);
    for (const SampledShares& shares : sun.sampledShares)
        for (ShownError& error : sun.errors)
            if (error.facts.key == shares.key && error.of == shares.of) error = errorOfShares(shares, hours);
}

// On the same cells.
bool haveSameCells(const SunWithTrees& one, const SunWithTrees& other) {
    return one.column == other.column &&
           std::ranges::equal(one.sun, other.sun, [](const SunOfPlace& a, const SunOfPlace& b) {
               return std::ranges::equal(a.ofCells, b.ofCells, {}, &SunOfCell::hours, &SunOfCell::hours) &&
                      a.dateHoursOfCells == b.dateHoursOfCells;
           });
}

}  // namespace

double computeEnoughShare(const SunOfPlace& of, double hours) {
    return enoughShareOf(of, hours, [&](std::size_t i) { return of.ofCells[i].hours; });
}

double computeBelowShare(const SunOfPlace& of, std::size_t date, double hours) {
    if (of.ofCells.empty()) return SunOfPlace::none;
    return 1 - enoughShareOf(of, hours, [&](std::size_t i) { return of.dateHoursOfCells[date][i]; });
}

std::optional<SunOfCities> withEnough(const SunOfCities& sun, double hours) {
    if (!hasCells(sun.baseline)) return std::nullopt;
    SunOfCities restated = sun;
    restate(restated.baseline, hours);
    for (ComparedSun& compared : restated.compared) restate(compared.sun, hours);
    return restated;
}

bool haveSameShadow(const SunOfCities& one, const SunOfCities& other) {
    const auto same = [](const SunByPlace& a, const SunByPlace& b) {
        return hasCells(a) && hasCells(b) && a.name == b.name &&
               std::ranges::equal(a.field.grossMin, b.field.grossMin, isSameMinute) &&
               std::ranges::equal(a.withTrees, b.withTrees, haveSameCells) &&
               a.settings.dates == b.settings.dates && a.months == b.months;
    };
    return one.baseline.places == other.baseline.places && same(one.baseline, other.baseline) &&
           std::ranges::equal(one.compared, other.compared, same, &ComparedSun::sun, &ComparedSun::sun);
}

namespace {

std::vector<SunChange> listChanges(const std::vector<SunOfPlace>& before,
                                   const std::vector<SunOfPlace>& after, double lossMin) {
    std::vector<SunChange> changes;
    for (std::size_t i = 0; i < before.size(); ++i) changes.push_back(changeOf(before[i], after[i], lossMin));
    return changes;
}

}  // namespace

std::vector<SunChange> computeChanges(const SunByPlace& before, const SunByPlace& after) {
    return listChanges(before.sun, after.sun, before.settings.lossMin);
}

std::vector<std::vector<SunChange>> computeChangesWithTrees(const SunByPlace& before,
                                                            const SunByPlace& after) {
    std::vector<std::vector<SunChange>> changes;
    for (const SunWithTrees& with : after.withTrees)
        changes.push_back(listChanges(sunInColumn(before, with.column), with.sun, before.settings.lossMin));
    return changes;
}

}  // namespace noonmark
