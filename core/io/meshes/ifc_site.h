#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/geo/frame.h"

namespace noonmark {

/// What an IFC file states about its place on earth.
struct IfcSite {
    std::optional<LonLat> place;          ///< of the site's origin (IfcSite)
    std::optional<double> elevationM;     ///< of the same
    std::optional<double> trueNorthDeg;   ///< true north from the model's +y, clockwise; only if it is not 0
    std::string mapConversion;            ///< "EPSG:25832 428000, 5444000"; empty: none
    std::string mapCrs;                   ///< of IfcMapConversion: "EPSG:25832"
    std::optional<glm::dvec2> mapOrigin;  ///< easting and northing of the model's origin there
    glm::dvec2 mapAxis{1, 0};             ///< direction of the model's x axis there
    std::optional<double> mapHeightM;     ///< of the model's origin there
};

/// Where a model's origin lies, and how it is turned.
struct IfcPlace {
    LonLat origin;
    double northDeg = 0;  ///< azimuth of the model's +y from true north, clockwise
    std::string words;    ///< where this is stated: "IfcSite"
    double elevationM = 0;
};

/// The place that the file states: on a map (IfcMapConversion) if its system is known, else that of its site.
/// Nothing where it states none, or 0, 0.
std::optional<IfcPlace> findPlace(const IfcSite& site);

/// Reads the file once, statement by statement; what was found so far if it is stopped.
IfcSite readIfcSite(const std::filesystem::path& file, const std::stop_token& stop);

/// How the warning of a place that is not used begins.
inline constexpr std::string_view unusedIfcPlace = "the IFC states where it stands, which is not used";

/// One line for a warning, with the options that state the same: "true north is 50 deg clockwise of its y
/// axis
/// (--mesh-north -50)"; empty if the file states nothing.
std::string describe(const IfcSite& site);

}  // namespace noonmark
