#include "core/io/read_region.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>

#include "core/base/gdal_calls.h"
#include "core/describe/text.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/readable_text.h"
#include "core/io/footprints/ogr_polygons.h"

namespace noonmark {

namespace {

using BoxSides = std::array<double, 4>;  // west, south, east, north

std::optional<BoxSides> parseBox(std::string_view text) {
    BoxSides box{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < box.size(); ++i) {
        while (at != end && (*at == ' ' || (i > 0 && *at == ','))) ++at;
        const auto [next, error] = std::from_chars(at, end, box[i]);
        if (error != std::errc{} || (i < 3 && (next == end || (*next != ',' && *next != ' '))))
            return std::nullopt;
        at = next;
    }
    return at == end ? std::optional(box) : std::nullopt;
}

Result<Region> regionOfBox(const BoxSides& box, const Frame& frame, const std::string& text) {
    const auto [west, south, east, north] = box;
    const auto region = makeRegionFromLonLatBox(frame, west, south, east, north);
    if (!region) return region;
    for (const LonLat corner :
         {LonLat{west, south}, LonLat{east, south}, LonLat{east, north}, LonLat{west, north}})
        if (auto near = checkedNear(corner, frame, "region " + text); !near)
            return tl::make_unexpected(near.error());
    return region;
}

Result<void> addLayer(OGRLayer& layer, const Frame& frame, const std::string& where, Region& region) {
    std::optional<PolygonLayer> reader;
    for (const OGRFeatureUniquePtr& feature : layer) {
        const OGRGeometry* geometry = feature->GetGeometryRef();
        if (geometry == nullptr) continue;
        if (!reader) {
            auto made = PolygonLayer::of(layer.GetSpatialRef(), frame, where);
            if (!made) return tl::make_unexpected(made.error());
            reader = *std::move(made);
        }
        auto pieces = reader->polygons(*geometry);
        if (!pieces) return tl::make_unexpected(pieces.error());
        std::ranges::move(*pieces, std::back_inserter(region.polygons));
    }
    return {};
}

Result<Region> regionOfFile(const std::filesystem::path& file, const Frame& frame) {
    const GdalCalls calls;
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset) return tl::make_unexpected(dataset.error());
    Region region{file.stem().string(), {}};
    for (OGRLayer* layer : (*dataset)->GetLayers())
        if (auto added = addLayer(*layer, frame, file.string(), region); !added)
            return tl::make_unexpected(added.error());
    if (StopScope::isStopped()) return cancelled();
    if (region.polygons.empty())
        return failure(NM_TEXT("The file holds no polygon with an area"), file.string(),
                       NM_TEXT("Draw the region as a polygon"));
    return region;
}

bool isWkt(std::string_view text) {
    const std::string start = foldText(text.substr(0, 24));
    return start.starts_with("polygon") || start.starts_with("multipolygon");
}

Result<Region> regionOfWkt(const std::string& text, const Frame& frame) {
    const GdalCalls calls;
    OGRGeometry* made = nullptr;
    const OGRErr error = OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &made);
    const std::unique_ptr<OGRGeometry> geometry(made);
    if (error != OGRERR_NONE || !geometry)
        return failure(
            NM_TEXT("It is not a polygon in well-known text"), text,
            NM_TEXT("Give degrees, longitude first: POLYGON ((-73.98 40.76, -73.97 40.76, -73.97 40.77, "
                    "-73.98 40.76))"));
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    const auto reader = PolygonLayer::of(&degrees, frame, "polygon");
    if (!reader) return tl::make_unexpected(reader.error());
    auto pieces = reader->polygons(*geometry);
    if (!pieces) return tl::make_unexpected(pieces.error());
    if (pieces->empty())
        return failure(NM_TEXT("The polygon has no area"), text, NM_TEXT("Give at least three corners"));
    return Region{"polygon", *std::move(pieces)};
}

}  // namespace

Result<Region> readRegion(const std::string& boxOrFile, const Frame& frame) {
    if (const auto box = parseBox(boxOrFile)) return regionOfBox(*box, frame, boxOrFile);
    if (isWkt(boxOrFile)) return regionOfWkt(boxOrFile, frame);
    std::error_code ignored;
    if (std::filesystem::exists(boxOrFile, ignored)) return regionOfFile(boxOrFile, frame);
    return failure(
        NM_TEXT("There is no such file, and the text is neither four numbers nor a polygon"),
        "region '" + boxOrFile + "'",
        NM_TEXT("Give west,south,east,north in degrees, for example -73.99,40.75,-73.98,40.76, a polygon "
                "as well-known text, or a polygon file"));
}

}  // namespace noonmark
