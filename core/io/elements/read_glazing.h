#pragma once

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

// The folder core/io/elements reads windows (this file) and writes the results of point receivers
// (write_elements.h).

struct GlazingFileSettings {
    static constexpr std::size_t maxWindows = 2'000'000;

    std::string idField;             ///< any case; empty: id, window, window_id, name or the feature's number
    std::optional<std::string> crs;  ///< "EPSG:7415", for files that state none
    /// Heights of the file are metres above the ground below the window; else they are elevations above the
    /// datum of the city, on flat ground without an elevation also metres above it.
    bool aboveGround = false;
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
/// Of CityJSON and CityGML the surfaces that are marked as Window or Door, of IFC its windows and doors
/// (model_glazing.h).
///
/// Error: the file cannot be read, is damaged, states no CRS, lacks the id field, has more than maxWindows
/// features, or holds no usable window (the error states why); cancelled(). Some 5 us a window. Backend:
/// read_glazing_gdal.cpp.
Result<GlazingRead> readGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                const City& city, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
