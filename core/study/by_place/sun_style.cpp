#include <fmt/format.h>

#include "core/describe/text.h"
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

ColourScale makeScale(const SunByPlace& sun, const PlaceColours& colours) {
    std::vector<double> hours;
    for (const SunOfPlace& of : sun.sun) hours.push_back(of.meanHours);
    return makeScaleOf(hours, sun, colours);
}

LayerStyle makeStyle(const SunByPlace& sun, const PlaceColours& colours) {
    const std::vector<ColourClass> classes = styleClasses(makeScale(sun, colours));
    return {"Hours of sun a day",
            graduatedStyle(StyledShape::polygons, "hours_mean", classes),
            {},
            makePartStyles(sun, colours)};
}

}  // namespace noonmark
