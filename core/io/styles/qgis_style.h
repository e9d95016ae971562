#pragma once

// The folder core/io/styles writes styles of QGIS (QML): qgis_style.h (this file) those of the layers of a
// GeoPackage, with the SQL of the table that QGIS takes them from by itself, puts one into a file that GDAL
// writes, and makes those of rasters.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/measures/colour_scale.h"

class GDALDataset;
class OGRLayer;

namespace noonmark {

/// A style of QGIS for a layer.
struct LayerStyle {
    std::string name;
    std::string qml;  ///< empty: none
    std::string description{};
    std::vector<LayerStyle> others{};  ///< to choose instead of it, in QGIS
};

enum class StyledShape { points, lines, polygons };

/// The line around polygons and points.
struct StyleOutline {
    std::string colour = "90,90,90,255";  ///< red, green, blue and opacity, 0 to 255 each
    double widthMm = 0.1;
};

/// QML that draws all polygons alike. `fill`: as the colour of an outline.
std::string singleStyle(const std::string& fill, const StyleOutline& outline);

/// QML that colours features by the numbers of a column, in its unit.
std::string graduatedStyle(StyledShape shape, std::string_view column, std::span<const ColourClass> classes,
                           const StyleOutline& outline = {});

/// QML that colours features by the values of a column, which are the labels of the classes.
std::string categorizedStyle(StyledShape shape, std::string_view column, std::span<const ColourClass> classes,
                             const StyleOutline& outline = {});

/// The classes of a scale, with the bounds of a column that holds `factor` times what the scale shows. A
/// continuous scale gets classes as wide as its ticks.
std::vector<ColourClass> styleClasses(const ColourScale& scale, double factor = 1);

/// SQL that creates the table of styles of a GeoPackage where it is missing: two statements.
std::vector<std::string> styleTableSql();
/// SQL that adds a style of a layer to that table, without its others.
std::string addStyleSql(std::string_view layer, std::string_view geometryColumn, const LayerStyle& style,
                        bool isDefault = true);

/// Puts the style of a layer into the GeoPackage that is being written; nothing where it has no QML. Errors
/// are GDAL's: see GdalCalls.
void writeLayerStyle(GDALDataset& geoPackage, OGRLayer& layer, const LayerStyle& style);

/// The colours of a map as a style of QGIS (QML) for a band of a raster, counted from 1. QGIS takes it by
/// itself if the file lies beside the raster under its name. The values are those of the file, minutes of
/// shadow (of a score, the score); the labels are in the unit shown. What the scale leaves free is
/// transparent.
std::string rasterStyle(const ColourScale& scale, std::size_t band = 1);

}  // namespace noonmark
