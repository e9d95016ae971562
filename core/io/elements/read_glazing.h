#pragma once

// The folder core/io/elements reads windows (this file) and writes the results of point receivers
// (write_elements.h).

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/receivers/points/glazing_receivers.h"

namespace noonmark {

/// Where a model that a user placed stands.
struct ModelPlace {
    LonLat origin;
    double northDeg = 0;  ///< azimuth of its y axis from true north, clockwise
    double scale = 1;     ///< factor on its coordinates
    bool operator==(const ModelPlace&) const = default;
};

struct GlazingFileSettings {
    static constexpr std::size_t maxWindows = 2'000'000;

    std::string idField;             ///< any case; empty: id, window, window_id, name or the feature's number
    std::optional<std::string> crs;  ///< "EPSG:7415", for files that state none
    /// Heights of the file are metres above the ground below the window; else they are elevations above the
    /// datum of the city, on flat ground without an elevation also metres above it.
    bool aboveGround = false;
    std::optional<ModelPlace> place;  ///< of an IFC; nothing: where it states
    double farAwayM = 60000;  ///< windows farther from the frame's origin are left out, with a warning
    bool operator==(const GlazingFileSettings&) const = default;
};

struct GlazingRead {
    std::vector<GlazingShape> windows;
    Warnings warnings;
    std::size_t features = 0;  ///< number of features read
};

/// Reads windows from every layer of a file in any vector format that GDAL reads: points, or polygons of
/// panes, both with z. A multi-geometry gives a window for each piece ("12/1", "12/2"). Fields, in any case:
/// azimuth (or facing, orientation), degrees from true north; floor (or storey, level); room (or room_id);
/// dwelling (or flat, apartment, unit, household). A feature that cannot
/// be used is left out with a warning: no geometry, neither point nor polygon, no height, coordinates that
/// are no numbers, too far away.
///
/// Of CityJSON and CityGML the surfaces that are marked as Window or Door, of IFC its windows and doors.
///
/// Error: the file cannot be read, is damaged, states no CRS, lacks the id field, has more than maxWindows
/// features, or holds no usable window (the error states why); cancelled(). Some 5 us a window. Backend:
/// read_glazing_gdal.cpp.
Result<GlazingRead> readGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                const City& city, Progress& progress, const std::stop_token& stop);

/// Reads the surfaces of CityJSON or CityJSONSeq that are marked as Window or Door (level of detail 3): of
/// each object those of its geometry of the highest level of detail that has some. Their ids are those of the
/// surfaces' attributes ("id" or "name"), else "OBJECT window 1", "OBJECT door 1". Heights are elevations,
/// whatever `settings` says of them. A surface that cannot be used is left out with a warning. The whole file
/// is held in memory. Error: the file cannot be read or is no CityJSON, states no coordinate reference
/// system, has too many or no such surfaces; cancelled().
Result<GlazingRead> readCityJsonGlazing(const std::filesystem::path& file,
                                        const GlazingFileSettings& settings, const City& city,
                                        const std::stop_token& stop);

/// Reads the surfaces of windows and doors of CityGML (level of detail 3): of each building or part those of
/// the highest level of detail that has some. Their ids are those of the windows, else "OBJECT window 1",
/// "OBJECT door 1". Heights are elevations, whatever `settings` says of them. Error: as readCityGml(), or no
/// such surfaces, too many, all too far away.
Result<GlazingRead> readCityGmlGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                       const City& city, Progress& progress, const std::stop_token& stop);

/// Reads the windows and doors of an IFC (2x3 or 4) where the user placed it, else where the file states that
/// it stands: each the rectangle
/// around its body in the outer face of its wall, with its name and the number of its storey. It stands as
/// high as the building of the city at its place that is as tall as the file's, else on the ground. Those
/// that open to no side, as inner doors, are left out with a warning. Error: the file cannot be read, has
/// no place, has no windows or too many, all are too far away. Some 20 ms for each window in a building of
/// 100,000 triangles.
Result<GlazingRead> readIfcGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                   const City& city, const std::stop_token& stop);

}  // namespace noonmark
