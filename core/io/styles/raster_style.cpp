#include "core/io/styles/raster_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/escaped_text.h"

namespace noonmark {

namespace {

/// A colour from this value of the file on, or, of classes, up to it.
struct StyleItem {
    double value;
    Rgb colour;
    std::string label;
};

constexpr int smoothStops = 32;  // between which QGIS interpolates; the eye sees no difference to the ramp

std::string styleNumber(double value) { return std::isinf(value) ? "inf" : fmt::format("{:.10g}", value); }

std::string smoothLabel(double shown, std::string_view unit) {
    return unit.empty() ? fmt::format("{:.4g}", shown) : fmt::format("{:.4g} {}", shown, unit);
}

std::vector<StyleItem> smoothItems(const ColourScale& scale) {
    std::vector<StyleItem> items;
    for (int i = 0; i <= smoothStops; ++i) {
        const double shown = std::lerp(scale.low, scale.high, double(i) / smoothStops);
        items.push_back({scale.valueOf(shown), scale.colourOf(shown), smoothLabel(shown, scale.unit())});
    }
    return items;
}

// A class of sun from 2 to 4 h is one of shadow from the sunlit time less 4 h up to that less 2 h.
std::vector<StyleItem> classItems(const ColourScale& scale) {
    std::vector<StyleItem> items;
    for (const ColourClass& one : scale.classes()) {
        const double end = scale.quantity.isSun() ? one.low : one.high;
        items.push_back({std::isinf(end) ? std::abs(end) : scale.valueOf(end), one.colour, one.label});
    }
    return items;
}

std::vector<StyleItem> itemsOf(const ColourScale& scale) {
    std::vector<StyleItem> items = scale.breaks.empty() ? smoothItems(scale) : classItems(scale);
    std::ranges::sort(items, {}, &StyleItem::value);
    return items;
}

std::string transparencyOf(const ColourScale& scale) {
    if (!scale.leavesZeroFree()) return "            <rasterTransparency/>\n";
    return R"(            <rasterTransparency>
                <singleValuePixelList>
                    <pixelListEntry min="0" max="0" percentTransparent="100"/>
                </singleValuePixelList>
            </rasterTransparency>
)";
}

std::string itemText(const StyleItem& item) {
    return fmt::format(
        "                    <item value=\"{}\" color=\"#{:02x}{:02x}{:02x}\" alpha=\"255\" label=\"{}\"/>\n",
        styleNumber(item.value), item.colour.red, item.colour.green, item.colour.blue, escapeXml(item.label));
}

std::string shaderOf(const std::vector<StyleItem>& items, bool discrete) {
    std::string text;
    for (const StyleItem& item : items) text += itemText(item);
    return fmt::format(R"(            <rastershader>
                <colorrampshader colorRampType="{}" classificationMode="1" clip="0">
{}                </colorrampshader>
            </rastershader>
)",
                       discrete ? "DISCRETE" : "INTERPOLATED", text);
}

}  // namespace

std::string rasterStyle(const ColourScale& scale) {
    const std::vector<StyleItem> items = itemsOf(scale);
    const auto finite = [](const StyleItem& item) { return std::isfinite(item.value); };
    const auto last = std::ranges::find_if(items.rbegin(), items.rend(), finite);
    return fmt::format(R"(
<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis version="3.22.0" styleCategories="Symbology">
    <pipe>
        <rasterrenderer type="singlebandpseudocolor" band="1" opacity="1" alphaBand="-1" classificationMin="{}" classificationMax="{}">
{}{}        </rasterrenderer>
    </pipe>
</qgis>
)",
                       styleNumber(items.front().value), styleNumber(last->value), transparencyOf(scale),
                       shaderOf(items, !scale.breaks.empty()));
}

}  // namespace noonmark
