#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// One parcel of a land register.
struct Parcel {
    std::string name;                 ///< from its field; may be empty, or equal to that of another parcel
    std::vector<Footprint> polygons;  ///< disjoint, local metres; at least one
};

struct ParcelSettings {
    /// Maximum number of parcels from one file: the parcels of a whole city would fill a project with unused
    /// lots.
    static constexpr std::size_t maxParcels = 5000;

    std::string nameField;         ///< any case; empty: the first of name, lot, parcel, apn, bbl, id, or none
    std::string layer;             ///< empty: every layer
    std::optional<Region> within;  ///< only parcels whose middle lies in this region
    std::vector<std::string> names;  ///< only parcels with these names; empty: all
};

/// Reads the polygons of a map in any format (formats/format.h). Error: the file cannot be read, has no CRS,
/// or lacks the field or layer (the advice lists those that exist); a name that no parcel has, no parcel in
/// the region, or more than maxParcels; cancelled(). Cost: some 5 us per feature, and some 50 us for each
/// one returned. Backend: read_parcels_gdal.cpp.
Result<std::vector<Parcel>> readParcels(const std::filesystem::path& file, const ParcelSettings& settings,
                                        const Frame& frame, const std::stop_token& stop);

}  // namespace noonmark
