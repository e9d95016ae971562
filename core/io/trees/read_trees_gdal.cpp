#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "core/base/clean_text.h"
#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/heights/height_text.h"
#include "core/io/heights/tree_fields.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/osm_trees.h"
#include "core/io/osm/read_osm_buildings.h"
#include "core/io/trees/read_canopy.h"
#include "core/io/trees/read_trees.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;

constexpr std::size_t maxTrees = 5'000'000;

std::vector<std::string> listFieldNames(OGRLayer& layer) {
    std::vector<std::string> names;
    const OGRFeatureDefn& fields = *layer.GetLayerDefn();
    for (int i = 0; i < fields.GetFieldCount(); ++i) names.emplace_back(fields.GetFieldDefn(i)->GetNameRef());
    return names;
}

std::vector<std::string> listTreeValues(const OGRFeature& feature) {
    std::vector<std::string> values;
    for (int i = 0; i < feature.GetFieldCount(); ++i)
        values.push_back(feature.IsFieldSetAndNotNull(i) != FALSE ? trimmed(feature.GetFieldAsString(i))
                                                                  : std::string());
    return values;
}

// Of a multipoint its first.
std::optional<glm::dvec2> findTreePoint(const OGRFeature& feature) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty()) return std::nullopt;
    const auto type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbMultiPoint) geometry = geometry->toMultiPoint()->getGeometryRef(0);
    if (type != wkbPoint && type != wkbMultiPoint) return std::nullopt;
    const OGRPoint& point = *geometry->toPoint();
    return glm::dvec2(point.getX(), point.getY());
}

/// Reads one layer of points, or a table with places in two of its columns.
class TreeLayer {
public:
    TreeLayer(OGRLayer& layer, std::string file, TreesRead& read)
        : file_(std::move(file)), read_(read), fields_(findTreeFields(listFieldNames(layer))) {
        inColumns_ = wkbFlatten(layer.GetGeomType()) == wkbNone && findRole(fields_, TreeRole::longitude) &&
                     findRole(fields_, TreeRole::latitude);
        for (const KnownTreeField& field : fields_)
            if (field.meaning->unsure)
                read.warnings.push_back({WarningKind::assumed,
                                         "numbers of a tree's stem are taken as centimetres",
                                         file_ + ": " + field.field});
    }

    [[nodiscard]] bool isInColumns() const { return inColumns_; }
    [[nodiscard]] static bool mayHoldTrees(OGRLayer& layer) {
        const auto type = wkbFlatten(layer.GetGeomType());
        return type == wkbPoint || type == wkbMultiPoint || type == wkbUnknown;
    }

    void read(const OGRFeature& feature) {
        const std::vector<std::string> values = listTreeValues(feature);
        const std::string where = fmt::format("{}, feature {}", file_, feature.GetFID());
        const auto point = inColumns_ ? findPlaceInColumns(values) : findTreePoint(feature);
        if (!point) {
            read_.warnings.push_back({WarningKind::leftOut, "a tree without a place", where});
            return;
        }
        points_.push_back(*point);
        TreeFacts facts = collectTreeFacts(fields_, values, where, read_.warnings);
        facts.species = cleanText(facts.species);
        facts_.push_back(std::move(facts));
    }

    /// Moves what was read to the trees of the file.
    void place(const CrsToLonLat* toLonLat) {
        std::vector<LonLat> places;
        if (toLonLat != nullptr)
            places = toLonLat->lonLat(points_);
        else
            for (const glm::dvec2& point : points_) places.push_back({point.x, point.y});
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool somewhere = std::isfinite(places[i].lonDeg) && std::abs(places[i].lonDeg) <= 180 &&
                                   std::abs(places[i].latDeg) <= 90;
            if (somewhere)
                read_.trees.push_back({places[i], std::move(facts_[i])});
            else
                read_.warnings.push_back(
                    {WarningKind::leftOut, "a tree at a place that is not on earth", facts_[i].sourceId});
        }
    }

    [[nodiscard]] std::size_t count() const { return points_.size(); }

private:
    [[nodiscard]] std::optional<glm::dvec2> findPlaceInColumns(const std::vector<std::string>& values) const {
        const auto read = [&](TreeRole role) -> std::optional<double> {
            const std::string& text = values[findRole(fields_, role)->index];
            char* end = nullptr;
            const double number = CPLStrtod(text.c_str(), &end);
            if (text.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
            return number;
        };
        const auto lon = read(TreeRole::longitude), lat = read(TreeRole::latitude);
        if (!lon || !lat || (*lon == 0 && *lat == 0)) return std::nullopt;
        return glm::dvec2(*lon, *lat);
    }

    std::string file_;
    TreesRead& read_;
    std::vector<KnownTreeField> fields_;
    bool inColumns_ = false;
    std::vector<glm::dvec2> points_;
    std::vector<TreeFacts> facts_;
};

tl::unexpected<Error> holdsNoTrees(const Path& file) {
    return failure("It holds no trees", file.string(),
                   "Give points, or a table with columns named longitude and latitude");
}

Result<void> readTreeLayer(OGRLayer& layer, const Path& file, const std::optional<std::string>& crs,
                           const GdalCalls& calls, TreesRead& read, Progress& progress,
                           const std::stop_token& stop) {
    const std::string name = file.filename().string();
    TreeLayer trees(layer, name, read);
    if (!trees.isInColumns() && !TreeLayer::mayHoldTrees(layer)) return {};
    std::optional<CrsToLonLat> toLonLat;
    if (!trees.isInColumns()) {
        auto found = findLayerCrs(layer, crs, file.string());
        if (!found) return tl::make_unexpected(found.error());
        toLonLat.emplace(*std::move(found));
    }
    const auto take = [&](std::size_t, const OGRFeature& feature) -> Result<void> {
        trees.read(feature);
        if (trees.count() <= maxTrees) return {};
        return limitReached(fmt::format("It holds more than {} trees", maxTrees), file.string(),
                            "Cut out the part around the city");
    };
    auto done = readFeatures({&layer}, {file.string(), "trees of " + name}, calls, take, progress, stop);
    if (!done) return tl::make_unexpected(done.error());
    trees.place(toLonLat ? &*toLonLat : nullptr);
    return {};
}

Result<TreesRead> readTreesOfMap(const Path& file, OsmFormat format, Progress& progress,
                                 const std::stop_token& stop) {
    const auto map =
        readOsmMap(file, format, {.keys = osmTreeKeys(), .lineKeys = {osmTreeKey}, .pointKeys = {osmTreeKey}},
                   progress, stop);
    if (!map) return tl::make_unexpected(map.error());
    TreesRead read{.attribution = osmCredit};
    read.trees = listOsmTrees(*map, read.warnings);
    if (read.trees.empty()) return holdsNoTrees(file);
    return read;
}

}  // namespace

Result<TreesRead> readTrees(const Path& file, const std::optional<std::string>& crs, Progress& progress,
                            const std::stop_token& stop) try {
    const GdalCalls calls(stop);
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (const auto format = findOsmFormat(file)) return readTreesOfMap(file, *format, progress, stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset && isUnknownFormat(dataset.error())) {
        const auto raster = openDataset(file, DatasetContent::elevations);
        if (raster) return readCanopy(**raster, file.filename().string(), crs, progress, stop);
    }
    if (!dataset) return tl::make_unexpected(dataset.error());
    TreesRead read;
    for (OGRLayer* layer : (*dataset)->GetLayers())
        if (auto done = readTreeLayer(*layer, file, crs, calls, read, progress, stop); !done)
            return tl::make_unexpected(done.error());
    if (read.trees.empty()) return holdsNoTrees(file);
    return read;
} catch (const std::exception& exception) {
    return failure(fmt::format("The trees cannot be read ({})", exception.what()), file.string(),
                   "Check that the file is complete, or export it again");
}

}  // namespace noonmark
