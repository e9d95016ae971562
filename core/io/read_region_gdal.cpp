#include "core/io/read_region.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/city/repair_footprint.h"
#include "core/geo/crs_to_lon_lat.h"
#include "core/geo/distance.h"
#include "core/io/gdal_calls.h"

namespace noonmark {

namespace {

constexpr double farthestM = 200000;
constexpr double longestSideM = 500;  // a straight side of this length is off by some 5 mm at most
constexpr double metresPerDegree = 111320;

using LonLatBox = std::array<double, 4>;  // west, south, east, north

std::optional<LonLatBox> parseBox(std::string_view text) {
    LonLatBox box{};
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

Result<void> checkedPlace(LonLat place, const Frame& frame, const std::string& where) {
    const double metres = greatCircleM(place, frame.origin());
    if (metres <= farthestM) return {};
    return failure(fmt::format("The region lies {:.0f} km from the city", metres / 1000), where,
                   "Check the order of the numbers (west,south,east,north) and the CRS of the file");
}

Result<Region> regionOfBox(const LonLatBox& box, const Frame& frame, const std::string& text) {
    const auto [west, south, east, north] = box;
    const auto region = regionFromLonLatBox(frame, west, south, east, north);
    if (!region) return region;
    for (const LonLat corner :
         {LonLat{west, south}, LonLat{east, south}, LonLat{east, north}, LonLat{west, north}})
        if (auto near = checkedPlace(corner, frame, "region " + text); !near)
            return tl::make_unexpected(near.error());
    return region;
}

// One layer's polygons, from its CRS to local metres.
class LayerReader {
public:
    static Result<LayerReader> of(const OGRSpatialReference* crs, const Frame& frame,
                                  const std::string& where) {
        char* text = nullptr;
        const bool said = crs != nullptr && crs->exportToWkt(&text) == OGRERR_NONE;
        const std::string wkt = said ? text : "";
        CPLFree(text);
        if (!said)
            return failure("The file does not say its coordinate reference system", where,
                           "Save it with its CRS, or as GeoJSON");
        auto toLonLat = CrsToLonLat::of(wkt);
        if (!toLonLat)
            return tl::make_unexpected(Error{toLonLat.error().what, where, toLonLat.error().advice});
        const double metresPerUnit = crs->IsGeographic() != 0 ? metresPerDegree : crs->GetLinearUnits();
        return LayerReader(*std::move(toLonLat), longestSideM / metresPerUnit, frame, where);
    }

    Result<void> add(const OGRGeometry& geometry, Region& region) const {
        const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
        const OGRwkbGeometryType type = wkbFlatten(straight->getGeometryType());
        if (type == wkbPolygon) return addPolygon(*straight->toPolygon(), region);
        if (!OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) return {};
        for (const OGRGeometry* member : *straight->toGeometryCollection())
            if (auto added = add(*member, region); !added) return added;
        return {};
    }

private:
    LayerReader(CrsToLonLat toLonLat, double longestSide, const Frame& frame, std::string where)
        : toLonLat_(std::move(toLonLat)),
          longestSide_(longestSide),
          frame_(frame),
          where_(std::move(where)) {}

    Result<void> addPolygon(OGRPolygon& polygon, Region& region) const {
        // Looked at before its sides are cut up: a point far off would make millions of pieces.
        for (const OGRLinearRing* ring : polygon)
            if (const auto near = localRing(*ring); !near) return tl::make_unexpected(near.error());
        polygon.segmentize(longestSide_);
        std::vector<RawRing> rings;
        for (const OGRLinearRing* ring : polygon) {
            auto local = localRing(*ring);
            if (!local) return tl::make_unexpected(local.error());
            rings.push_back(*std::move(local));
        }
        for (Footprint& piece : repairFootprint(rings).pieces) region.polygons.push_back(std::move(piece));
        return {};
    }

    [[nodiscard]] Result<RawRing> localRing(const OGRLinearRing& ring) const {
        std::vector<glm::dvec2> points;
        for (const OGRPoint& point : ring) points.emplace_back(point.getX(), point.getY());
        const std::vector<LonLat> places = toLonLat_.lonLat(points);
        RawRing local;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (std::isnan(places[i].lonDeg) || !toLonLat_.isPlausible(places[i]))
                return failure(fmt::format("A point at {}, {} is not where {} can be", points[i].x,
                                           points[i].y, toLonLat_.name()),
                               where_, "Check the CRS of the file");
            if (auto near = checkedPlace(places[i], frame_, where_); !near)
                return tl::make_unexpected(near.error());
            local.push_back(frame_.localFromLonLat(places[i]));
        }
        return local;
    }

    CrsToLonLat toLonLat_;
    double longestSide_ = 0;
    Frame frame_;
    std::string where_;
};

Result<void> addLayer(OGRLayer& layer, const Frame& frame, const std::string& where, Region& region) {
    std::optional<LayerReader> reader;
    for (const OGRFeatureUniquePtr& feature : layer) {
        const OGRGeometry* geometry = feature->GetGeometryRef();
        if (geometry == nullptr) continue;
        if (!reader) {
            auto made = LayerReader::of(layer.GetSpatialRef(), frame, where);
            if (!made) return tl::make_unexpected(made.error());
            reader = *std::move(made);
        }
        if (auto added = reader->add(*geometry, region); !added) return added;
    }
    return {};
}

Result<Region> regionOfFile(const std::filesystem::path& file, const Frame& frame) {
    const GdalCalls calls;
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
    if (!dataset)
        return failure("The region cannot be read: " + calls.why(), file.string(),
                       "Give a polygon file such as GeoJSON or GeoPackage");
    Region region{file.stem().string(), {}};
    for (OGRLayer* layer : dataset->GetLayers())
        if (auto added = addLayer(*layer, frame, file.string(), region); !added)
            return tl::make_unexpected(added.error());
    if (region.polygons.empty())
        return failure("The file holds no polygon with an area", file.string(),
                       "Draw the region as a polygon");
    return region;
}

}  // namespace

Result<Region> readRegion(const std::string& boxOrFile, const Frame& frame) {
    if (const auto box = parseBox(boxOrFile)) return regionOfBox(*box, frame, boxOrFile);
    std::error_code ignored;
    if (std::filesystem::exists(boxOrFile, ignored)) return regionOfFile(boxOrFile, frame);
    return failure("There is no such file, and it is not four numbers", "region '" + boxOrFile + "'",
                   "Give west,south,east,north in degrees, for example -73.99,40.75,-73.98,40.76");
}

}  // namespace noonmark
