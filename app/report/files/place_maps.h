#pragma once

#include "app/report/files/output_folder.h"
#include "core/io/files/file_tags.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// How the maps of places look.
struct PlaceMapLook {
    PlaceColours colours{};
    int widthPx = 1920;
    double cellM = 2;  ///< of the raster; doubled until it has at most 16 million cells
    FileTags tags{};
};

/// "sun_by_place.png", "sun_by_place.tif" and its style for QGIS.
const std::vector<std::string>& placeMapNames();

/// Adds the map of the places as the window shows it: a picture, and a raster whose cells have the figures of
/// the smallest place that holds their centre. Bands: hours of sun a day over the period, those on each date,
/// and, where a baseline is compared, the change in minutes. Of the last of the cities. Needs a
/// QGuiApplication.
void addPlaceMaps(OutputFolder& files, std::shared_ptr<const SunOfCities> sun, const City& city,
                  const PlaceMapLook& look);

}  // namespace noonmark
