#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/map_context.h"
#include "core/geo/frame.h"
#include "core/io/context/coast.h"

namespace noonmark {

struct ContextSettings {
    /// Most features of one file that are drawn; more would be a whole country.
    static constexpr std::size_t maxFeatures = 1'000'000;
    /// Features farther from the frame's origin are left out and counted; areas that reach nearer are cut to
    /// the square of twice this side about it.
    double farAwayM = 60000;
    bool waterOnly = false;          ///< areas of water and nothing else
    std::optional<std::string> crs;  ///< "EPSG:2263", for files that state none
};

struct ContextRead {
    MapContext context;
    Warnings warnings;
    std::size_t features = 0;      ///< number of features read
    std::vector<CoastLine> coast;  ///< of an OpenStreetMap file; the sea beside it is among the areas
};

/// Reads what a map draws for orientation into the frame of a city: of an OpenStreetMap file by its tags
/// (context_tags.h); of any other vector format features whose field `kind` names a ContextKind, or whose
/// columns bear OpenStreetMap's keys. The sea is what lies on the right of coastlines within the box that the
/// file covers, or that of the coastlines where it states none (coast.h). Shapes are drawn as they are,
/// without repair. Error: the file cannot be read, is damaged, states no CRS, has no such feature (not for
/// OpenStreetMap) or too many; cancelled(). Some 10 us a feature. Backend: read_context_gdal.cpp.
Result<ContextRead> readContext(const std::filesystem::path& file, const ContextSettings& settings,
                                const Frame& frame, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
