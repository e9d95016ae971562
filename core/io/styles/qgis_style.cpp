#include "core/io/styles/qgis_style.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/safe_text.h"

namespace noonmark {

namespace {

std::string option(const char* name, std::string_view value) {
    return fmt::format(R"(<Option type="QString" name="{}" value="{}"/>)", name, value);
}

std::string outlineOptions(const StyleOutline& outline) {
    return option("outline_color", outline.colour) + option("outline_style", "solid") +
           option("outline_width", fmt::format("{:g}", outline.widthMm)) + option("outline_width_unit", "MM");
}

/// How QGIS calls the symbols of a shape.
struct SymbolKind {
    const char* type;
    const char* layerClass;
    int geometryType;
};
constexpr std::array symbolKinds{SymbolKind{"marker", "SimpleMarker", 0}, SymbolKind{"line", "SimpleLine", 1},
                                 SymbolKind{"fill", "SimpleFill", 2}};

const SymbolKind& kindOf(StyledShape shape) { return symbolKinds.at(std::size_t(shape)); }

std::string symbolOptions(StyledShape shape, const std::string& fill, const StyleOutline& outline) {
    switch (shape) {
        case StyledShape::points:
            return option("color", fill) + option("name", "circle") + option("size", "2") +
                   option("size_unit", "MM") + outlineOptions(outline);
        case StyledShape::lines:
            return option("line_color", fill) + option("line_style", "solid") + option("line_width", "0.5") +
                   option("line_width_unit", "MM");
        case StyledShape::polygons:
            return option("color", fill) + option("style", "solid") + outlineOptions(outline);
    }
    return {};
}

std::string symbol(StyledShape shape, std::size_t name, const std::string& fill,
                   const StyleOutline& outline) {
    return fmt::format(
        R"(<symbol type="{}" name="{}"><layer class="{}"><Option type="Map">{}</Option></layer></symbol>)",
        kindOf(shape).type, name, kindOf(shape).layerClass, symbolOptions(shape, fill, outline));
}

std::string symbolsOf(StyledShape shape, std::span<const ColourClass> classes, const StyleOutline& outline) {
    std::string symbols;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const Rgb colour = classes[i].colour;
        symbols +=
            symbol(shape, i, fmt::format("{},{},{},255", colour.red, colour.green, colour.blue), outline);
    }
    return "<symbols>" + symbols + "</symbols>";
}

std::string qml(StyledShape shape, const std::string& renderer) {
    return fmt::format(
        "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n<qgis version=\"3.22.0\" "
        "styleCategories=\"Symbology\">{}<layerGeometryType>{}</layerGeometryType></qgis>",
        renderer, kindOf(shape).geometryType);
}

// QGIS wants numbers.
double finiteBound(double value) {
    constexpr double beyondAllFigures = 1e9;
    return std::clamp(value, -beyondAllFigures, beyondAllFigures);
}

std::string sqlText(std::string_view text) {
    std::string sql = "'";
    for (const char letter : text) sql += letter == '\'' ? std::string("''") : std::string(1, letter);
    return sql + "'";
}

// A continuous scale in steps of its ticks.
ColourScale inClasses(ColourScale scale) {
    if (!scale.breaks.empty()) return scale;
    const int steps = std::max(2, int(std::lround((scale.high - scale.low) / scale.tick)));
    for (int i = 1; i < steps; ++i)
        scale.breaks.push_back(std::lerp(scale.low, scale.high, double(i) / steps));
    return scale;
}

}  // namespace

std::string singleStyle(const std::string& fill, const StyleOutline& outline) {
    return qml(StyledShape::polygons, "<renderer-v2 type=\"singleSymbol\"><symbols>" +
                                          symbol(StyledShape::polygons, 0, fill, outline) +
                                          "</symbols></renderer-v2>");
}

std::string graduatedStyle(StyledShape shape, std::string_view column, std::span<const ColourClass> classes,
                           const StyleOutline& outline) {
    std::string ranges;
    for (std::size_t i = 0; i < classes.size(); ++i)
        ranges += fmt::format(
            R"(<range lower="{:.10g}" upper="{:.10g}" symbol="{}" label="{}" render="true"/>)",
            finiteBound(classes[i].low), finiteBound(classes[i].high), i, escapeXml(classes[i].label));
    return qml(shape, fmt::format(R"(<renderer-v2 type="graduatedSymbol" attr="{}" )"
                                  R"(graduatedMethod="GraduatedColor"><ranges>{}</ranges>{}</renderer-v2>)",
                                  column, ranges, symbolsOf(shape, classes, outline)));
}

std::string categorizedStyle(StyledShape shape, std::string_view column, std::span<const ColourClass> classes,
                             const StyleOutline& outline) {
    std::string categories;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const std::string label = escapeXml(classes[i].label);
        categories +=
            fmt::format(R"(<category value="{}" symbol="{}" label="{}" render="true"/>)", label, i, label);
    }
    return qml(shape,
               fmt::format(R"(<renderer-v2 type="categorizedSymbol" attr="{}"><categories>{}</categories>)"
                           R"({}</renderer-v2>)",
                           column, categories, symbolsOf(shape, classes, outline)));
}

std::vector<ColourClass> styleClasses(const ColourScale& scale, double factor) {
    std::vector<ColourClass> classes = inClasses(scale).classes();
    for (ColourClass& one : classes) {
        one.low *= factor;
        one.high *= factor;
    }
    return classes;
}

std::vector<std::string> styleTableSql() {
    return {
        R"sql(CREATE TABLE IF NOT EXISTS layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  f_table_catalog TEXT(256), f_table_schema TEXT(256), f_table_name TEXT(256), f_geometry_column TEXT(256),
  styleName TEXT(30), styleQML TEXT, styleSLD TEXT, useAsDefault BOOLEAN, description TEXT, owner TEXT(30),
  ui TEXT(30), update_time DATETIME DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now'))))sql",
        "INSERT OR IGNORE INTO gpkg_contents (table_name, data_type, identifier) VALUES ('layer_styles', "
        "'attributes', 'layer_styles')"};
}

std::string addStyleSql(std::string_view layer, std::string_view geometryColumn, const LayerStyle& style,
                        bool isDefault) {
    return fmt::format(
        "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, "
        "styleName, styleQML, styleSLD, useAsDefault, description, owner) VALUES ('', '', {}, {}, {}, {}, "
        "'', {}, {}, 'Noonmark')",
        sqlText(layer), sqlText(geometryColumn), sqlText(style.name), sqlText(style.qml), int(isDefault),
        sqlText(style.description));
}

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
    if (!scale.leavesZeroUncoloured()) return "            <rasterTransparency/>\n";
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

std::string rasterStyle(const ColourScale& scale, std::size_t band) {
    const std::vector<StyleItem> items = itemsOf(scale);
    const auto finite = [](const StyleItem& item) { return std::isfinite(item.value); };
    const auto last = std::ranges::find_if(items.rbegin(), items.rend(), finite);
    return fmt::format(R"(
<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis version="3.22.0" styleCategories="Symbology">
    <pipe>
        <rasterrenderer type="singlebandpseudocolor" band="{}" opacity="1" alphaBand="-1" classificationMin="{}" classificationMax="{}">
{}{}        </rasterrenderer>
    </pipe>
</qgis>
)",
                       band, styleNumber(items.front().value), styleNumber(last->value),
                       transparencyOf(scale), shaderOf(items, !scale.breaks.empty()));
}

}  // namespace noonmark
