#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/city/footprints/clip_ring.h"
#include "core/geo/distance.h"
#include "core/io/context/context_tags.h"
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
        const auto kind = kindOf(feature, tags, geometry->getDimension());
        if (!kind || (waterOnly_ && *kind != ContextKind::water)) return;
        UnplacedShape shape{*kind, nameIn(tags), widthOf(feature, *kind, tags), readPolygons(*geometry), {}};
        if (shape.polygons.empty()) addLines(*geometry, shape.lines);
        if (!shape.polygons.empty() || !shape.lines.empty()) shapes_.push_back(std::move(shape));
    }

    [[nodiscard]] std::size_t size() const { return shapes_.size(); }

    /// All points go through one call: GDAL spends 0.1 ms on choosing a transformation for each.
    void place(const Frame& frame, double farAwayM, ContextRead& into) {
        Points points;
        forEachPoint([&](glm::dvec2 point) { points.push_back(point); });
        places_ = toLonLat_.lonLat(points);
        next_ = 0;
        for (const UnplacedShape& shape : shapes_) add(shape, frame, farAwayM, into);
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

    static constexpr double widestM = 1e6;  // as far as a frame is meant for

    CrsToLonLat toLonLat_;
    bool waterOnly_;
    std::vector<std::pair<int, std::string>> fields_;
    int kindField_ = -1, widthField_ = -1;
    std::vector<UnplacedShape> shapes_;
    std::vector<LonLat> places_;
    std::size_t next_ = 0, farAway_ = 0;
};

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
    const auto features = readFeatures(layers, {file, "map of " + file}, calls, take, progress, stop);
    if (!features) return tl::make_unexpected(features.error());
    ContextRead read{{}, {}, *features};
    for (ContextLayer& reader : readers) reader.place(frame, settings.farAwayM, read);
    if (stop.stop_requested()) return cancelled();
    if (isFromOsm(dataset)) read.context.attribution = osmCredit;
    if (!read.context.empty() || isFromOsm(dataset) || settings.waterOnly) return read;
    return failure("It holds no streets, parks, water or trees", file,
                   "Give the features OpenStreetMap's keys (highway, leisure, ...), or a field 'kind' with "
                   "street, path, rail, park, grass, wood, water, plaza or tree");
}

// The keys by which context_tags.h classifies areas, lines and points.
OsmSelection selectContext() {
    const std::vector<std::string> kinds{"leisure", "landuse", "amenity", "natural", "place"};
    OsmSelection selection{.keys = kinds,
                           .areaKeys = kinds,
                           .kindKeys = kinds,
                           .lineKeys = {"highway", "railway", "waterway"},
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
    OsmSelection selection{.keys = kinds, .areaKeys = kinds, .kindKeys = kinds};
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
