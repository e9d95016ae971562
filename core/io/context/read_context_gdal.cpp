#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>

#include "core/base/safe_text.h"
#include "core/city/footprints/footprint.h"
#include "core/describe/text.h"
#include "core/geo/lon_lat.h"
#include "core/io/context/read_context.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/ogr_polygons.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/osm_layers.h"
#include "core/io/osm/read_osm_buildings.h"

namespace noonmark {

namespace {

using Points = std::vector<glm::dvec2>;  // in the layer's coordinates

struct UnplacedShape {
    ContextKind kind = ContextKind::park;
    std::string name;
    double widthM = 0;
    std::vector<CrsPolygon> polygons;  // of an area
    std::vector<Points> lines;         // of lines and, one point each, of trees
};

/// Collects the features of one layer that a map draws.
class ContextLayer {
public:
    ContextLayer(OGRLayer& layer, CrsToLonLat toLonLat, bool waterOnly)
        : toLonLat_(std::move(toLonLat)), waterOnly_(waterOnly) {
        const OGRFeatureDefn& definition = *layer.GetLayerDefn();
        for (int i = 0; i < definition.GetFieldCount(); ++i)
            fields_.emplace_back(i, definition.GetFieldDefn(i)->GetNameRef());
        kindField_ = layer.FindFieldIndex("kind", 0);
        widthField_ = layer.FindFieldIndex("width_m", 0);
    }

    void read(const OGRFeature& feature) {
        const OGRGeometry* geometry = feature.GetGeometryRef();
        if (geometry == nullptr || geometry->IsEmpty() != FALSE) return;
        const PlaceTags tags = tagsOf(feature);
        if (geometry->getDimension() == 1 && isCoastline(tags)) addLines(*geometry, coast_);
        const auto kind = kindOf(feature, tags, geometry->getDimension());
        if (!kind || (waterOnly_ && *kind != ContextKind::water)) return;
        UnplacedShape shape{*kind, nameIn(tags), widthOf(feature, *kind, tags), readPolygons(*geometry), {}};
        if (shape.polygons.empty()) addLines(*geometry, shape.lines);
        if (!shape.polygons.empty() || !shape.lines.empty()) shapes_.push_back(std::move(shape));
    }

    [[nodiscard]] std::size_t size() const { return shapes_.size() + coast_.size(); }

    /// All points go through one call: GDAL spends 0.1 ms on choosing a transformation for each.
    void place(const Frame& frame, double farAwayM, ContextRead& into) {
        Points points;
        forEachPoint([&](glm::dvec2 point) { points.push_back(point); });
        places_ = toLonLat_.lonLat(points);
        next_ = 0;
        for (const UnplacedShape& shape : shapes_) add(shape, frame, farAwayM, into);
        for (const Points& line : coast_) addCoast(line.size(), frame, into);
        if (farAway_ > 0)
            into.warnings.push_back({WarningKind::leftOut, "features of the map are too far from the city",
                                     fmt::format("{} features", farAway_)});
    }

private:
    void forEachPoint(const auto& take) const {
        for (const UnplacedShape& shape : shapes_) {
            for (const CrsPolygon& polygon : shape.polygons)
                for (const Points& ring : polygon) std::ranges::for_each(ring, take);
            for (const Points& line : shape.lines) std::ranges::for_each(line, take);
        }
        for (const Points& line : coast_) std::ranges::for_each(line, take);
    }

    [[nodiscard]] PlaceTags tagsOf(const OGRFeature& feature) const {
        PlaceTags tags;
        for (const auto& [field, key] : fields_)
            if (feature.IsFieldSetAndNotNull(field) != FALSE)
                if (std::string text = trimmed(feature.GetFieldAsString(field)); !text.empty())
                    tags.emplace(key, std::move(text));
        return tags;
    }

    static std::string nameIn(const PlaceTags& tags) {
        const auto name = tags.find("name");
        return name == tags.end() ? std::string() : name->second;
    }

    [[nodiscard]] std::optional<ContextKind> kindOf(const OGRFeature& feature, const PlaceTags& tags,
                                                    int dimension) const {
        if (kindField_ >= 0 && feature.IsFieldSetAndNotNull(kindField_) != FALSE)
            if (const auto kind = parseContextKind(trimmed(feature.GetFieldAsString(kindField_))))
                return kind;
        if (dimension == 2) return classifyContextArea(tags);
        return dimension == 1 ? classifyContextLine(tags) : classifyContextPoint(tags);
    }

    [[nodiscard]] double widthOf(const OGRFeature& feature, ContextKind kind, const PlaceTags& tags) const {
        constexpr double widest = 200;
        if (widthField_ >= 0 && feature.IsFieldSetAndNotNull(widthField_) != FALSE)
            if (const double width = feature.GetFieldAsDouble(widthField_); width > 0 && width <= widest)
                return width;
        return widthOfLine(kind, tags);
    }

    static void addLines(const OGRGeometry& geometry, std::vector<Points>& lines) {
        const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
        if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
            for (const OGRGeometry* member : *geometry.toGeometryCollection()) addLines(*member, lines);
        } else if (type == wkbLineString) {
            Points& line = lines.emplace_back();
            for (const OGRPoint& point : *geometry.toLineString())
                line.emplace_back(point.getX(), point.getY());
        } else if (type == wkbPoint) {
            lines.push_back({{geometry.toPoint()->getX(), geometry.toPoint()->getY()}});
        }
    }

    static Ring open(std::vector<glm::vec2> ring) {
        if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        return ring;
    }

    /// The next points of the shapes, in the frame; nothing if one is nowhere or too far away.
    std::optional<std::vector<glm::vec2>> placeNext(std::size_t count, const Frame& frame, double farAwayM) {
        std::vector<glm::vec2> local;
        bool near = true;
        for (std::size_t i = 0; i < count; ++i, ++next_) {
            const LonLat at = places_[next_];
            near = near && std::isfinite(at.lonDeg) && std::isfinite(at.latDeg) &&
                   computeGreatCircleM(at, frame.origin()) <= farAwayM;
            if (near) local.emplace_back(frame.localFromLonLat(at));
        }
        return near ? std::optional(std::move(local)) : std::nullopt;
    }

    /// The next polygon, cut to what lies near: of a lake as long as a country, the city needs its own shore.
    /// Nothing if none of it is near, or if it is nowhere or reaches farther than the frame.
    std::optional<Footprint> placePolygon(const CrsPolygon& polygon, const Frame& frame, double farAwayM) {
        const auto reach = float(farAwayM);
        const Box2 nearby{glm::vec2(-reach), glm::vec2(reach)};
        bool placed = true;
        std::vector<Ring> rings;
        for (const Points& ring : polygon) {
            auto local = placeNext(ring.size(), frame, std::max(farAwayM, widestM));
            placed = placed && local;
            if (local) rings.push_back(clipRing(open(*std::move(local)), nearby));
        }
        if (!placed || rings.empty() || rings.front().empty()) return std::nullopt;
        std::erase_if(rings, [](const Ring& ring) { return ring.size() < 3; });
        Footprint footprint{std::move(rings.front()), {}};
        std::move(rings.begin() + 1, rings.end(), std::back_inserter(footprint.holes));
        return footprint;
    }

    void add(const UnplacedShape& shape, const Frame& frame, double farAwayM, ContextRead& into) {
        ContextArea area{shape.kind, shape.name, {}};
        bool near = true;
        for (const CrsPolygon& polygon : shape.polygons) {
            auto placed = placePolygon(polygon, frame, farAwayM);
            near = near && placed;
            if (placed) area.polygons.push_back(*std::move(placed));
        }
        if (!area.polygons.empty()) into.context.areas.push_back(std::move(area));
        for (const Points& line : shape.lines) {
            auto local = placeNext(line.size(), frame, farAwayM);
            near = near && local;
            if (!local) continue;
            if (shape.kind == ContextKind::tree)
                into.context.trees.insert(into.context.trees.end(), local->begin(), local->end());
            else if (local->size() > 1)
                into.context.lines.push_back(
                    {shape.kind, shape.name, float(shape.widthM), *std::move(local)});
        }
        if (!near) ++farAway_;
    }

    // In double, so that ways that share a node share its place. A coast beyond the frame ends where it
    // leaves it.
    void addCoast(std::size_t count, const Frame& frame, ContextRead& into) {
        CoastLine line;
        for (std::size_t i = 0; i < count; ++i, ++next_)
            if (const LonLat at = places_[next_]; std::isfinite(at.lonDeg) && std::isfinite(at.latDeg) &&
                                                  computeGreatCircleM(at, frame.origin()) <= widestM)
                line.push_back(frame.localFromLonLat(at));
        if (line.size() > 1) into.coast.push_back(std::move(line));
    }

    static constexpr double widestM = 1e6;  // as far as a frame is meant for

    CrsToLonLat toLonLat_;
    bool waterOnly_;
    std::vector<std::pair<int, std::string>> fields_;
    int kindField_ = -1, widthField_ = -1;
    std::vector<UnplacedShape> shapes_;
    std::vector<Points> coast_;
    std::vector<LonLat> places_;
    std::size_t next_ = 0, farAway_ = 0;
};

// The largest upright box inside the corners of one in longitude and latitude, cut to what lies near.
Box2 boxIn(const Frame& frame, const LonLatBox& box, double farAwayM) {
    const glm::dvec2 southWest = frame.localFromLonLat({box.westDeg, box.southDeg}),
                     southEast = frame.localFromLonLat({box.eastDeg, box.southDeg}),
                     northWest = frame.localFromLonLat({box.westDeg, box.northDeg}),
                     northEast = frame.localFromLonLat({box.eastDeg, box.northDeg});
    const glm::dvec2 low(std::max(southWest.x, northWest.x), std::max(southWest.y, southEast.y)),
        high(std::min(southEast.x, northEast.x), std::min(northWest.y, northEast.y));
    return {glm::vec2(glm::max(low, glm::dvec2(-farAwayM))), glm::vec2(glm::min(high, glm::dvec2(farAwayM)))};
}

Box2 boxAround(const std::vector<CoastLine>& coast, double farAwayM) {
    Box2 box;
    for (const CoastLine& line : coast)
        for (const glm::dvec2 point : line)
            box.add(glm::vec2(glm::clamp(point, glm::dvec2(-farAwayM), glm::dvec2(farAwayM))));
    return box;
}

std::string describePlace(const Frame& frame, glm::dvec2 local) {
    const LonLat place = frame.lonLatFromLocal(local);
    return fmt::format("at {:.5f}, {:.5f} (longitude, latitude)", place.lonDeg, place.latDeg);
}

/// Adds the sea of the coastlines that were read, within the box that the file covers.
void addSea(ContextRead& read, const std::optional<LonLatBox>& covered, const Frame& frame, double farAwayM) {
    if (read.coast.empty()) return;
    const Box2 box = covered ? boxIn(frame, *covered, farAwayM) : boxAround(read.coast, farAwayM);
    if (box.empty()) return;
    Sea sea = findSea(read.coast, box);
    for (const double metres : sea.continuedM)
        read.warnings.push_back({WarningKind::assumed,
                                 "the coastline goes on straight to the edge of the map",
                                 fmt::format("over {:.0f} m", metres)});
    for (const glm::dvec2 end : sea.openEnds)
        read.warnings.push_back({WarningKind::leftOut,
                                 "the coastline does not close, so the sea there is not known",
                                 describePlace(frame, end)});
    for (std::size_t i = 0; i < sea.contradictions; ++i)
        read.warnings.push_back({WarningKind::leftOut,
                                 "coastlines disagree where land and sea lie, so it is taken for land",
                                 "an area between coastlines"});
    if (!sea.polygons.empty())
        read.context.areas.push_back({ContextKind::water, {}, std::move(sea.polygons)});
}

bool isWanted(OGRLayer& layer, bool fromOsm) {
    const std::string_view name = layer.GetName();
    return !fromOsm || name == "points" || name == "lines" || name == "multipolygons";
}

Result<ContextRead> readLayers(GDALDataset& dataset, const std::string& file, const ContextSettings& settings,
                               const Frame& frame, const GdalCalls& calls, Progress& progress,
                               const std::stop_token& stop) {
    std::vector<OGRLayer*> layers;
    std::vector<ContextLayer> readers;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (!isWanted(*layer, isFromOsm(dataset))) continue;
        auto system = findLayerCrs(*layer, settings.crs, file);
        if (!system) return tl::make_unexpected(system.error());
        layers.push_back(layer);
        readers.emplace_back(*layer, *std::move(system), settings.waterOnly);
    }
    std::size_t kept = 0;
    const auto take = [&](std::size_t layer, const OGRFeature& feature) -> Result<void> {
        kept -= readers[layer].size();
        readers[layer].read(feature);
        kept += readers[layer].size();
        if (kept <= ContextSettings::maxFeatures) return {};
        return limitReached(
            fmt::format("It holds more than {} features to draw", ContextSettings::maxFeatures), file,
            "Cut out the part around the city");
    };
    const auto features =
        readFeatures(layers, {file, NM_TEXT("reading the map")}, calls, take, progress, stop);
    if (!features) return tl::make_unexpected(features.error());
    ContextRead read{{}, {}, *features};
    for (ContextLayer& reader : readers) reader.place(frame, settings.farAwayM, read);
    addSea(read, isFromOsm(dataset) ? findOsmBox(dataset) : std::nullopt, frame, settings.farAwayM);
    if (stop.stop_requested()) return cancelled();
    if (isFromOsm(dataset)) read.context.attribution = osmCredit;
    if (!read.context.empty() || isFromOsm(dataset) || settings.waterOnly) return read;
    return failure("It holds no streets, parks, water or trees", file,
                   "Give the features OpenStreetMap's keys (highway, leisure, ...), or a field 'kind' with "
                   "street, path, rail, park, grass, wood, water, plaza or tree");
}

// The keys by which read_context.h classifies areas, lines and points.
OsmSelection selectContext() {
    const std::vector<std::string> kinds{"leisure", "landuse", "amenity", "natural", "place"};
    OsmSelection selection{.keys = kinds,
                           .areaKeys = kinds,
                           .kindKeys = kinds,
                           .lineKeys = {"highway", "railway", "waterway", "natural"},
                           .pointKeys = {"natural"}};
    for (const char* key : {"water", "building"}) selection.areaKeys.emplace_back(key);
    for (const char* key : {"highway", "waterway"}) selection.kindKeys.emplace_back(key);
    for (const char* key : {"name", "highway", "railway", "waterway", "building", "width", "lanes", "area",
                            "tunnel", "layer", "location"})
        selection.keys.emplace_back(key);
    return selection;
}

// The keys of which areas of water have one.
OsmSelection selectWater() {
    const std::vector<std::string> kinds{"natural", "waterway", "landuse", "leisure"};
    OsmSelection selection{.keys = kinds, .areaKeys = kinds, .kindKeys = kinds, .lineKeys = {"natural"}};
    for (const char* key : {"name", "building", "tunnel", "layer", "location"})
        selection.keys.emplace_back(key);
    return selection;
}

Result<DatasetPointer> openMap(const std::filesystem::path& file, bool waterOnly, Progress& progress,
                               const std::stop_token& stop) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (const auto osm = findOsmFormat(file))
        return readOsmLayers(file, *osm, waterOnly ? selectWater() : selectContext(), progress, stop);
    return openDataset(file, DatasetContent::vectors);
}

}  // namespace

Result<ContextRead> readContext(const std::filesystem::path& file, const ContextSettings& settings,
                                const Frame& frame, Progress& progress, const std::stop_token& stop) try {
    const GdalCalls calls(stop);
    const auto dataset = openMap(file, settings.waterOnly, progress, stop);
    if (!dataset) return tl::make_unexpected(dataset.error());
    return readLayers(**dataset, file.filename().string(), settings, frame, calls, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that the file is complete, or export it again");
}

}  // namespace noonmark
