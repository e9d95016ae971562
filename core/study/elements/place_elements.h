#pragma once

#include <array>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/choice.h"
#include "core/describe/text.h"
#include "core/io/elements/read_glazing.h"
#include "core/receivers/parcels/parcel_lines.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/points/point_list.h"
#include "core/study/elements/face_choice.h"
#include "core/study/study.h"

namespace noonmark {

/// Where the points of a study lie.
enum class ElementPlaces { facades, windows, plane, lines, points };
inline constexpr std::array elementPlaceChoices{
    Choice{ElementPlaces::facades, "facades", NM_TEXT("on facades")},
    Choice{ElementPlaces::windows, "windows", NM_TEXT("at windows of a file")},
    Choice{ElementPlaces::plane, "plane", NM_TEXT("on a level plane")},
    Choice{ElementPlaces::lines, "lines", NM_TEXT("on lines around a parcel")},
    Choice{ElementPlaces::points, "points", NM_TEXT("at single points")}};
/// "facades", "windows", "plane", "lines", "points"
inline std::string_view nameOf(ElementPlaces places) {
    return keyOf<ElementPlaces>(elementPlaceChoices, places);
}

/// What the names in ElementSettings mean in a project and its city. The caller looks it up before the points
/// are placed (app/input/load_project.h). All are equal, since the names are compared.
struct ElementParts {
    std::vector<Footprint> facedPlace;  ///< the polygons of FaceChoice::place
    std::vector<Footprint> parcel;      ///< the polygons of ElementSettings::parcel
    std::vector<std::string> proposed;  ///< ids of the buildings that the existing city lacks
    OwnStoreys storeys;                 ///< of towers that were designed in the project
    std::optional<ModelPlace> model;    ///< of the windows' IFC, where a user placed it
    bool operator==(const ElementParts& /*other*/) const { return true; }
};

struct ElementSettings {
    ElementPlaces places = ElementPlaces::facades;
    /// Facades: names or ids, in any case, one or several ("A,B") in a text; empty: all of the region.
    std::vector<std::string> buildings;
    bool proposed = false;   ///< facades: those of new and changed buildings only; `buildings` is not read
    FacadeSettings facades;  ///< its storeyM also numbers the floors of windows
    FaceChoice faces;        ///< of facades and windows, those that are measured
    std::filesystem::path windows;  ///< file of the windows
    GlazingFileSettings glazingFile;
    /// Above the mean of the region's ground, of lines of the parcel's: 0 to maxPlaneHeightM.
    double planeHeightM = 0;
    std::string parcel;  ///< lines: a lot, region or place of the project by name, or a polygon file
    LineSettings lines;
    std::vector<ListedPoint> points;   ///< points: where they are, ids unique;
    std::filesystem::path pointsFile;  ///< the file they were read from; empty: none
    ElementParts parts;
    bool operator==(const ElementSettings&) const = default;
};

/// The points of a study.
struct PlacedElements {
    PointReceivers receivers;
    std::vector<GlazingFacts> facts;  ///< of the receivers; empty unless they are windows of a file
    double planeM = 0;                ///< local z of a plane
    Warnings warnings;                ///< from reading and placing
};

/// Places the points that the settings ask for, in the region and with the cells of `settings`; lines and
/// listed points also outside the region. Error: a setting out of range, a building that does not exist or
/// lies outside the region, no points, what readGlazing() refuses, cancelled().
Result<PlacedElements> placeElements(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop);

}  // namespace noonmark
