#include "core/io/styles/qgis_style.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/escaped_text.h"

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

}  // namespace noonmark
