#pragma once

#include <memory>
#include <vector>

#include "core/geo/lon_lat.h"
#include "core/io/read_city.h"

namespace noonmark {

/// The part of a city to read.
struct ReadExtent {
    /// Only the features that touch this box are read, from footprints with a spatial index; other files are
    /// read whole. Finding none is no error.
    LonLatBox box;
    /// A terrain that was read before in the same frame: files of terrain are not read. Null: they are,
    /// whole.
    std::shared_ptr<const Terrain> terrain;
    /// The box around each of the files, in their order: files that do not touch `box` are not opened. Empty:
    /// unknown.
    std::vector<LonLatBox> fileBoxes{};
};

/// readCity() of a part, in the frame of `settings`, which must be set. Buildings are complete if the box
/// contains all their features, and the same to the last bit and in the same order as in the whole city.
Result<CityRead> readCityExtent(const std::vector<std::filesystem::path>& files, const ReadSettings& settings,
                                const ReadExtent& window, Progress& progress, std::stop_token stop);

}  // namespace noonmark
