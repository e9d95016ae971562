#pragma once

// The folder core/io/citygml reads CityGML 1.0, 2.0 and 3.0. loadCityGml() (this file) reads the file as a
// stream, one top-level object at a time, into the plain values of CityJSON
// (core/io/cityjson/cityjson_model.h); citygml_reference_gdal.cpp settles reference system and order of the
// axes; the rest is that of CityJSON. gml_object.h collects geometries, knows the names of elements and
// chooses among the geometries of an object.

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/crs.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

struct CityGmlData {
    CityJsonData city;  ///< `crs` as the file states it, vertices in its order of axes
    struct Envelope {
        glm::dvec3 low, high;
    };
    std::optional<Envelope> envelope;   ///< of the whole model
    std::vector<FileOpening> openings;  ///< if they are wanted; in the file's order of axes
    std::size_t outsideExtent = 0;      ///< objects that are no part of `city`
};

/// What is wanted besides buildings and terrain.
enum class GmlContent { buildings, openings };

/// Reads the buildings, the terrain and the plants of CityGML; what else it holds is listed. No file that it
/// refers to is opened; where objects refer to surfaces of others in it, it is read three times. Memory: that
/// of one object, and some 3 KB for each building. Error: streamXml()'s, not CityGML, too large (40 million
/// corners), no level of detail.
Result<CityGmlData> loadCityGml(const std::filesystem::path& file, const ReadSettings& settings,
                                Progress& progress, const std::stop_token& stop,
                                GmlContent wanted = GmlContent::buildings);

/// A reference system as CityGML names it, as parseCrs() (core/geo/crs.h) takes it: the names of
/// the German surveys ("urn:adv:crs:ETRS89_UTM33*DE_DHHN2016_NH") become EPSG's; others are unchanged.
std::string translateReference(const std::string& stated);

/// Whether its coordinates are degrees. False for unknown systems.
bool isGeographicReference(const std::string& stated);

/// Tells which objects may lie in an extent and aroundExtentM around it, before the order of the axes is
/// settled: those that do in one of the two orders. Backend: citygml_reference_gdal.cpp.
class GmlExtent {
public:
    /// `stated`: as the file names its system; the settings' where that is unknown. Without any, all may.
    GmlExtent(const ReadSettings& settings, const std::string& stated);
    [[nodiscard]] bool mayTouch(const std::vector<glm::dvec3>& vertices) const;

private:
    LonLatBox box_;
    std::optional<CrsToLonLat> crs_;
};

/// Brings the vertices into the order easting or longitude first, and `city.crs` into the form that
/// parseCrs() takes; empty if the one of `settings` is to be used. The order is that of the system's
/// authority if it is named by a URN or address, else easting or longitude first, unless only the other order
/// puts the buildings into the system's area, or into the model's envelope; or where both do, unless nine of
/// ten buildings would be mirror images. Error: no system is stated, or it is unknown and the settings have
/// none.
Result<void> settleReference(CityGmlData& data, const ReadSettings& settings,
                             const std::filesystem::path& file);

}  // namespace noonmark
