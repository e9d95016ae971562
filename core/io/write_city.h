#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/styles/qgis_style.h"

namespace noonmark {

/// A column of numbers, one per building, repeated for each part of the building.
struct BuildingColumn {
    std::string name;
    std::vector<double> values;  ///< in the order of City::buildings
};

/// Writes a GeoPackage (EPSG:4326) with a polygon layer `buildings`, one feature per part, in the city's
/// order, with the columns
/// - building_id: text, the same for all parts of a building, unique among buildings
/// - source_id: text, of the part
/// - name, status: text, of the building
/// - height: metres from the ground to the part's top
/// - min_height: metres from the ground to the part's underside; 0 for a part that stands on the ground
/// - ground_elevation: metres, of the ground under the building, in the city's vertical datum; empty for a
///   flat city at 0
/// - height_source: "measured", "levels", "assumed" or "mesh"
/// - hangs: 1 for an overhang, else 0
///
/// and the columns of `figures`. `style`: the layer's style in QGIS, stored in the file.
///
/// readCity() in the same frame gives the same prisms back, coordinates to 1 mm. Buildings on terrain stand
/// on it again if the terrain file is read too, otherwise on flat ground.
///
/// A layer of polygons cannot hold a mesh: a part with a mesh is written as the prism of its footprint from
/// bottomM to topM, keeps "mesh" as its height source, and gives one of the returned `leftOut` warnings.
/// Terrain and trees are not written and give a warning each, too. Written beside the target and renamed, so
/// that a killed process leaves no incomplete file. Error: the file cannot be written. Backend:
/// write_city_gdal.cpp.
Result<Warnings> writeCityGeoPackage(const std::filesystem::path& file, const City& city,
                                     const std::vector<BuildingColumn>& figures = {},
                                     const LayerStyle& style = {});

}  // namespace noonmark
