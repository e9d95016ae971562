#include <fmt/format.h>
#include <algorithm>
#include <cmath>

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

/// Styles by the hours of parts of the period.
class PartStyles {
public:
    PartStyles(const SunByPlace& sun, const PlaceColours& colours) : sun_(sun), colours_(colours) {}

    // `of`: hours of a place by part; a place without cells has none.
    void add(const std::string& name, const std::string& key, std::vector<double> SunOfPlace::*of,
             std::size_t part) {
        std::vector<double> hours;
        for (const SunOfPlace& one : sun_.sun)
            if (part < (one.*of).size()) hours.push_back((one.*of)[part]);
        const auto classes = styleClasses(makeScaleOf(hours, sun_, colours_));
        styles_.push_back({fmt::format("Hours of sun a day, {}", name),
                           graduatedStyle(StyledShape::polygons, hoursColumn(key), classes)});
    }
    [[nodiscard]] std::vector<LayerStyle> take() && { return std::move(styles_); }

private:
    const SunByPlace& sun_;
    const PlaceColours& colours_;
    std::vector<LayerStyle> styles_;
};

std::vector<LayerStyle> makePartStyles(const SunByPlace& sun, const PlaceColours& colours) {
    PartStyles styles(sun, colours);
    for (std::size_t i = 0; i < sun.settings.dates.size(); ++i) {
        const std::string date = formatText(sun.settings.dates[i]);
        styles.add(date, date, &SunOfPlace::dateHours, i);
    }
    for (std::size_t i = 0; i < sun.seasons.size(); ++i)
        styles.add(sun.seasons[i].label, sun.seasons[i].key, &SunOfPlace::seasonHours, i);
    for (std::size_t i = 0; i < sun.months.size(); ++i)
        styles.add(sun.months[i], sun.months[i], &SunOfPlace::monthHours, i);
    return std::move(styles).take();
}

}  // namespace

double hoursOf(const SunOfPlace& of, std::optional<std::size_t> date) {
    if (!date) return of.meanHours;
    return *date < of.dateHours.size() ? of.dateHours[*date] : SunOfPlace::none;
}

ColourScale makeScale(const SunByPlace& sun, const PlaceColours& colours) {
    std::vector<double> hours;
    for (const SunOfPlace& of : sun.sun) hours.push_back(hoursOf(of, colours.date));
    return makeScaleOf(hours, sun, colours);
}

LayerStyle makeStyle(const SunByPlace& sun, const PlaceColours& colours) {
    const std::vector<ColourClass> classes = styleClasses(makeScale(sun, colours));
    return {"Hours of sun a day",
            graduatedStyle(StyledShape::polygons, "hours_mean", classes),
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
    for (std::size_t i = 0; i < before.withTrees.size(); ++i)
        changes.push_back(
            listChanges(before.withTrees[i].sun, after.withTrees[i].sun, before.settings.lossMin));
    return changes;
}

}  // namespace noonmark
