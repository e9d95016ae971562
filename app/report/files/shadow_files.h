#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/report/files/output_folder.h"
#include "core/io/shadows/write_shadows.h"

namespace noonmark {

enum class ShadowFormat { dxf, geoPackage, geoJson, svg };

struct ShadowFileSettings {
    std::set<ShadowFormat> formats{ShadowFormat::dxf, ShadowFormat::geoPackage};
    DrawingPlane plane = DrawingPlane::local;
    double scale = 2000;  ///< of SVG
};

/// The names of the files of a drawing: shadows.dxf, shadows.gpkg; shadows.geojson, and buildings, places,
/// fan, isochrones and distances .geojson; shadows_TIME.svg for each time. Before the drawing is made, some
/// of them may not come about.
std::vector<std::string> shadowFileNames(const std::vector<DrawnTime>& times,
                                         const ShadowFileSettings& settings);

/// Adds the files to a folder's set. `drawing` must live until the set is written.
void addShadowFiles(OutputFolder& files, const ShadowDrawing& drawing, const ShadowFileSettings& settings);

}  // namespace noonmark
