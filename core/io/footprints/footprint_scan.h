#pragma once

#include <map>
#include <utility>

#include "core/geo/lon_lat.h"
#include "core/io/footprints/place_features.h"
#include "core/io/formats/format.h"

namespace noonmark {

/// What a file of buildings holds, found in one pass that stores no footprints: for plans of studies that are
/// larger than memory.
struct FootprintScan {
    /// Side of a cell of `tallestM`, degrees.
    static constexpr double cellDeg = 0.02;
    using Cell = std::pair<int, int>;  ///< floor(longitude / cellDeg), floor(latitude / cellDeg)

    Frame frame;                        ///< as readFootprints() chooses it
    LonLatBox box = emptyLonLatBox;     ///< around all features
    std::size_t features = 0;           ///< usable as buildings
    bool indexed = true;                ///< an extent of it is read without the rest
    bool hasTerrain = false;            ///< the file has a terrain too, which is not divided
    std::map<Cell, double> tallestM{};  ///< highest top above the ground among the features that touch a
                                        ///< cell; of a roof whose ground is unknown, at most its elevation

    void add(const UnplacedFeature& feature);
    void add(const Building& building, const Frame& frame);

private:
    void add(const LonLatBox& own, double heightM);
};

/// The same of a file of this format, which states its place. A file without a spatial index is read whole.
/// Errors as readCity().
Result<FootprintScan> scanBuildings(const std::filesystem::path& file, const Format& format,
                                    const ReadSettings& settings, Progress& progress, std::stop_token stop);

/// Errors as readFootprints(). Some 10 us a feature; memory 24 bytes a feature. Backend:
/// read_footprints_gdal.cpp.
Result<FootprintScan> scanFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                     Progress& progress, std::stop_token stop);

}  // namespace noonmark
