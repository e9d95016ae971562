#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/measures/palette.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

/// Classes of hours: whole hours up to eight of them, else two hours each.
struct HourClasses {
    int count = 1;
    double widthHours = 1;
};

HourClasses classesOf(const SunByPlace& sun) {
    constexpr int maxCount = 8;
    double most = 1;
    for (const SunOfPlace& of : sun.sun)
        if (!std::isnan(of.meanHours)) most = std::max(most, of.meanHours);
    const double widthHours = std::ceil(most) > maxCount ? 2 : 1;
    return {int(std::ceil(most / widthHours)), widthHours};
}

std::string rangeQml(const HourClasses& classes, int i) {
    const double lower = i * classes.widthHours, upper = lower + classes.widthHours;
    return fmt::format(
        R"(<range render="true" symbol="{}" lower="{:g}" upper="{:g}" label="{:g} to {:g} h of sun a day"/>)",
        i, lower, upper, lower, upper);
}

std::string symbolQml(const HourClasses& classes, int i) {
    const Rgb colour = shadowRgb(1 - (i + 0.5) / classes.count);
    return fmt::format(
        R"(<symbol type="fill" name="{}" alpha="1" clip_to_extent="1" force_rhr="0"><layer class="SimpleFill" )"
        R"(enabled="1" locked="0" pass="0"><Option type="Map"><Option type="QString" name="color" )"
        R"(value="{},{},{},255"/><Option type="QString" name="outline_color" value="90,90,90,255"/><Option )"
        R"(type="QString" name="outline_width" value="0.1"/><Option type="QString" name="style" )"
        R"(value="solid"/></Option></layer></symbol>)",
        i, colour.red, colour.green, colour.blue);
}

}  // namespace

LayerStyle makeStyle(const SunByPlace& sun) {
    const HourClasses classes = classesOf(sun);
    std::string ranges, symbols;
    for (int i = 0; i < classes.count; ++i) {
        ranges += rangeQml(classes, i);
        symbols += symbolQml(classes, i);
    }
    return {
        "Hours of sun a day",
        fmt::format(
            R"(<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'><qgis version="3.22" )"
            R"(styleCategories="Symbology"><renderer-v2 type="graduatedSymbol" attr="hours_mean" )"
            R"(graduatedMethod="GraduatedColor" symbollevels="0" enableorderby="0" forceraster="0"><ranges>{}</ranges>)"
            R"(<symbols>{}</symbols></renderer-v2><blendMode>0</blendMode><layerGeometryType>2</layerGeometryType></qgis>)",
            ranges, symbols)};
}

}  // namespace noonmark
