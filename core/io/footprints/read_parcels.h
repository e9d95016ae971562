#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"
#include "core/receivers/region.h"

namespace noonmark {

/// One parcel of a register.
struct Parcel {
    std::string name;                 ///< as its field says; may be empty or that of another parcel
    std::vector<Footprint> polygons;  ///< disjoint, local metres; at least one
};

struct ParcelSettings {
    /// Most parcels that a file may give: a whole city's would fill a project with lots that nobody builds
    /// on.
    static constexpr std::size_t mostParcels = 5000;

    std::string nameField;         ///< any case; empty: the first of name, lot, parcel, apn, bbl, id, or none
    std::string layer;             ///< empty: every layer
    std::optional<Region> within;  ///< those alone whose middle lies in it
    std::vector<std::string> names;  ///< those alone; empty: all
};

/// The polygons of a file of any vector format GDAL knows (GeoPackage, GeoJSON, Shapefile). Error: it cannot
/// be read, has no CRS, no such field or layer (with those that it has), a name that no parcel bears, no
/// parcel in the region, or more than mostParcels; cancelled(). Cost: some 5 us a feature, and some 50 us for
/// those that are given back. Backend: read_parcels_gdal.cpp.
Result<std::vector<Parcel>> readParcels(const std::filesystem::path& file, const ParcelSettings& settings,
                                        const Frame& frame, const std::stop_token& stop);

}  // namespace noonmark
