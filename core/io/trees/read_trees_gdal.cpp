#include "core/io/trees/read_trees.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/gdal_calls.h"
#include "core/base/safe_text.h"
#include "core/describe/text.h"
#include "core/geo/crs.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/heights/height_text.h"
#include "core/io/heights/tree_fields.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/layers/written_crs.h"
#include "core/io/osm/osm_layers.h"
#include "core/io/osm/read_osm_buildings.h"
#include "core/io/settings/read_settings.h"

class GDALDataset;

namespace noonmark {

namespace {

constexpr std::size_t maxCanopyCells = 2'000'000;
constexpr double maxRasterCells = 4e9;  // of which some hold canopy: a small file may state any size
constexpr int maxRasterColumns = 1'000'000;
constexpr double minCanopyM = 2, highestCanopyM = 120;  // lower growth shades no one who stands

using Placing = std::array<double, 6>;

glm::dvec2 placeInRaster(const Placing& placing, double column, double row) {
    return {placing[0] + column * placing[1] + row * placing[2],
            placing[3] + column * placing[4] + row * placing[5]};
}

/// The cells of a raster that hold canopy.
struct CanopyCells {
    std::vector<glm::dvec2> places;  // centres, in the raster's system
    std::vector<float> heightsM;
    std::vector<std::optional<double>> basesM;
};

// One row of a band.
bool readRow(GDALRasterBand& band, int y, std::vector<float>& row) {
    return band.RasterIO(GF_Read, 0, y, band.GetXSize(), 1, row.data(), band.GetXSize(), 1, GDT_Float32, 0,
                         0) == CE_None;
}

// A number of the raster is `unitM` metres. `base`: where crowns begin; null: not known.
Result<CanopyCells> readCells(GDALRasterBand& band, GDALRasterBand* base, const Placing& placing, float unitM,
                              const std::string& file, Progress& progress, const std::stop_token& stop) {
    CanopyCells cells;
    std::vector<float> row(std::size_t(band.GetXSize())), bases(row.size());
    for (int y = 0; y < band.GetYSize(); ++y) {
        if (stop.stop_requested()) return cancelled();
        if (!readRow(band, y, row) || (base != nullptr && !readRow(*base, y, bases)))
            return failure("It is incomplete or damaged", file, "Download or export it again");
        for (std::size_t x = 0; x < row.size(); ++x) {
            const float heightM = row[x] * unitM;
            if (!(heightM >= minCanopyM && heightM <= highestCanopyM)) continue;
            cells.places.push_back(placeInRaster(placing, double(x) + 0.5, y + 0.5));
            cells.heightsM.push_back(heightM);
            const float baseM = bases[x] * unitM;
            const bool isKnown = base != nullptr && baseM >= 0 && baseM < heightM;
            cells.basesM.push_back(isKnown ? std::optional(double(baseM)) : std::nullopt);
        }
        if (cells.places.size() > maxCanopyCells)
            return limitReached(fmt::format("It holds more than {} cells of canopy", maxCanopyCells), file,
                                "Cut out the part around the city, or make its cells larger");
        progress.report(double(y) / band.GetYSize(), NM_TEXT("reading canopy"));
    }
    return cells;
}

// Square metres of a cell in the middle of the raster.
double computeCellArea(const CrsToLonLat& toLonLat, const Placing& placing, double column, double row) {
    const std::array corners{placeInRaster(placing, column, row), placeInRaster(placing, column + 1, row),
                             placeInRaster(placing, column, row + 1)};
    const std::vector<LonLat> places = toLonLat.lonLat(corners);
    if (!std::isfinite(places[0].lonDeg)) return std::numeric_limits<double>::quiet_NaN();
    const Frame frame(places[0]);
    const glm::dvec2 along = frame.localFromLonLat(places[1]), up = frame.localFromLonLat(places[2]);
    return std::abs(along.x * up.y - along.y * up.x);
}

// The unit of a raster, whose cells are its only field.
LengthUnit findCanopyUnit(const TreeFieldChoices& choices) {
    for (const TreeFieldChoice& choice : choices)
        if (choice.role == TreeRole::height && choice.unit) return *choice.unit;
    return LengthUnit::metres;
}

/// The cells of a raster of canopy heights above the ground as trees of their own: cylinders of the
/// cell's area (TreeFacts::canopyCellM2). Cells below 2 m are no canopy. A second band is the height at which
/// crowns begin; where it is none, below 0 or not below the top, it is not known. Hold a GdalCalls. Error: no
/// place or no system, cells of more than 20 m, no canopy, or more than 2 million cells of it; cancelled().
/// Backend: read_trees_gdal.cpp.
Result<TreesRead> readCanopy(GDALDataset& dataset, const std::string& file,
                             const std::optional<std::string>& crs, LengthUnit unit, Progress& progress,
                             const std::stop_token& stop) {
    Placing placing{};
    if (dataset.GetRasterCount() < 1 || dataset.GetGeoTransform(placing.data()) != CE_None)
        return failure("It states no place", file, "Give a georeferenced raster of canopy heights");
    const std::string system = crs.value_or(wktOf(dataset.GetSpatialRef()));
    if (system.empty()) return failure("It states no coordinate reference system", file, crsAdvice());
    const auto toLonLat = CrsToLonLat::of(system);
    if (!toLonLat) return tl::make_unexpected(toLonLat.error());
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    const double cellM2 = computeCellArea(*toLonLat, placing, band.GetXSize() / 2.0, band.GetYSize() / 2.0);
    if (!(cellM2 > 0.01 && cellM2 < 400))
        return failure("Its cells are smaller than 0.1 m or larger than 20 m", file,
                       "Give canopy heights in cells of about a metre");
    if (band.GetXSize() > maxRasterColumns || double(band.GetXSize()) * band.GetYSize() > maxRasterCells)
        return limitReached("It has more cells than a region of 60 x 60 km in metres", file,
                            "Cut out the part around the city");
    GDALRasterBand* const base = dataset.GetRasterCount() > 1 ? dataset.GetRasterBand(2) : nullptr;
    const auto cells = readCells(band, base, placing, float(metresPer(unit)), file, progress, stop);
    if (!cells) return tl::make_unexpected(cells.error());
    const std::vector<LonLat> places = toLonLat->lonLat(cells->places);
    TreesRead read;
    for (std::size_t i = 0; i < places.size(); ++i)
        read.trees.push_back({places[i],
                              {.sourceId = std::string(canopyRasterId),
                               .heightM = double(cells->heightsM[i]),
                               .crownBaseM = cells->basesM[i],
                               .canopyCellM2 = cellM2}});
    if (read.trees.empty())
        return failure("It holds no canopy of 2 to 120 m", file,
                       "Give heights of the canopy above the ground, in metres");
    read.warnings.push_back({WarningKind::assumed,
                             "canopy is taken as trees that lose their leaves, open below",
                             fmt::format("{}: {}", file, countOf(read.trees.size(), "cell"))});
    return read;
}

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
    const auto written = feature.GetGeometryRef() == nullptr ? readWrittenGeometry(feature) : nullptr;
    const OGRGeometry* geometry = written ? written.get() : feature.GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty()) return std::nullopt;
    const auto type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbMultiPoint) geometry = geometry->toMultiPoint()->getGeometryRef(0);
    if (type != wkbPoint && type != wkbMultiPoint) return std::nullopt;
    const OGRPoint& point = *geometry->toPoint();
    return glm::dvec2(point.getX(), point.getY());
}

/// Where the places of a layer are.
enum class PlaceSource { geometry, lonLat, latLon, plane };

std::optional<double> parseNumber(const std::string& text) {
    char* end = nullptr;
    const double number = CPLStrtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
    return number;
}

/// Reads one layer of points, or a table with places in its columns.
class TreeLayer {
public:
    TreeLayer(OGRLayer& layer, std::string file, const TreeFieldChoices& choices, TreesRead& read)
        : file_(std::move(file)), read_(read), fields_(findTreeFields(listFieldNames(layer), choices)) {
        if (wkbFlatten(layer.GetGeomType()) == wkbNone) source_ = findColumns();
        for (const KnownTreeField& field : fields_)
            if (field.meaning.unsure)
                read.warnings.push_back({WarningKind::assumed,
                                         "numbers of a tree's stem are taken as centimetres",
                                         file_ + ": " + field.field});
    }

    [[nodiscard]] bool mayHoldTrees(OGRLayer& layer) const {
        const auto type = wkbFlatten(layer.GetGeomType());
        if (type == wkbNone) return source_ != PlaceSource::geometry;
        return type == wkbPoint || type == wkbMultiPoint || type == wkbUnknown;
    }

    void read(const OGRFeature& feature) {
        const std::vector<std::string> values = listTreeValues(feature);
        const std::string where = fmt::format("{}, feature {}", file_, feature.GetFID());
        if (saysNoTree(fields_, values))
            return read_.warnings.push_back(
                {WarningKind::leftOut, "a stump, an empty pit or a tree that is dead, felled or planned",
                 where});
        const auto point =
            source_ == PlaceSource::geometry ? findTreePoint(feature) : findPlaceInColumns(values);
        if (!point) return read_.warnings.push_back({WarningKind::leftOut, "a tree without a place", where});
        points_.push_back(*point);
        TreeFacts facts = collectTreeFacts(fields_, values, where, read_.warnings);
        facts.species = cleanText(facts.species);
        if (facts.species.empty()) ++unknownSpecies_;
        facts_.push_back(std::move(facts));
    }

    /// Whether all places could be longitudes and latitudes.
    [[nodiscard]] bool holdsDegrees() const {
        return std::ranges::all_of(
            points_, [](glm::dvec2 point) { return std::abs(point.x) <= 180 && std::abs(point.y) <= 90; });
    }
    [[nodiscard]] bool statesDegrees() const {
        return source_ == PlaceSource::lonLat || source_ == PlaceSource::latLon;
    }

    /// Moves what was read to the trees of the file. `toLonLat`: null where the places are degrees.
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
        if (unknownSpecies_ > 0)
            read_.warnings.push_back({WarningKind::assumed, "the species of trees is not known",
                                      fmt::format("{}: {}", file_, countOf(unknownSpecies_, "tree"))});
    }

    [[nodiscard]] std::size_t count() const { return points_.size(); }

private:
    [[nodiscard]] PlaceSource findColumns() const {
        const auto has = [&](TreeRole role) { return findRole(fields_, role) != nullptr; };
        if (has(TreeRole::longitude) && has(TreeRole::latitude)) return PlaceSource::lonLat;
        if (has(TreeRole::latLon)) return PlaceSource::latLon;
        const bool isPlane = has(TreeRole::easting) && has(TreeRole::northing);
        return isPlane ? PlaceSource::plane : PlaceSource::geometry;
    }

    [[nodiscard]] std::optional<glm::dvec2> findPlaceInColumns(const std::vector<std::string>& values) const {
        const auto text = [&](TreeRole role) { return values[findRole(fields_, role)->index]; };
        if (source_ == PlaceSource::latLon) return splitLatLon(text(TreeRole::latLon));
        const bool isPlane = source_ == PlaceSource::plane;
        return joinPlace(text(isPlane ? TreeRole::easting : TreeRole::longitude),
                         text(isPlane ? TreeRole::northing : TreeRole::latitude));
    }
    static std::optional<glm::dvec2> splitLatLon(const std::string& text) {
        const auto comma = text.find(',');
        if (comma == text.npos) return std::nullopt;
        return joinPlace(trimmed(text.substr(comma + 1)), trimmed(text.substr(0, comma)));
    }
    // Zero and zero is what programs write for nothing.
    static std::optional<glm::dvec2> joinPlace(const std::string& east, const std::string& north) {
        const auto x = parseNumber(east), y = parseNumber(north);
        if (!x || !y || (*x == 0 && *y == 0)) return std::nullopt;
        return glm::dvec2(*x, *y);
    }

    std::string file_;
    TreesRead& read_;
    std::vector<KnownTreeField> fields_;
    PlaceSource source_ = PlaceSource::geometry;
    std::size_t unknownSpecies_ = 0;
    std::vector<glm::dvec2> points_;
    std::vector<TreeFacts> facts_;
};

tl::unexpected<Error> holdsNoTrees(const Path& file) {
    return failure("It holds no trees", file.string(),
                   "Give points, or a table with columns named longitude and latitude");
}

// The system of a layer that was read; none where its places are degrees. Tables name no system: numbers that
// could all be degrees are taken for them.
Result<std::optional<CrsToLonLat>> findSystem(OGRLayer& layer, const TreeLayer& trees, const Path& file,
                                              const std::optional<std::string>& crs, Warnings& warnings) {
    if (trees.statesDegrees()) return std::optional<CrsToLonLat>();
    const bool statesNone = layer.GetSpatialRef() == nullptr && !crs;
    if (const auto written = statesNone ? findWrittenCrs(layer) : std::nullopt)
        return CrsToLonLat::of(*written).map(
            [](CrsToLonLat found) { return std::optional(std::move(found)); });
    if (statesNone && trees.holdsDegrees()) {
        warnings.push_back(
            {WarningKind::assumed,
             "the file names no coordinate reference system; its numbers are taken for degrees",
             file.filename().string()});
        return std::optional<CrsToLonLat>();
    }
    return findLayerCrs(layer, crs, file.string()).map([](CrsToLonLat found) {
        return std::optional(std::move(found));
    });
}

Result<void> readTreeLayer(OGRLayer& layer, const Path& file, const TreeReading& how, const GdalCalls& calls,
                           TreesRead& read, Progress& progress, const std::stop_token& stop) {
    const std::string name = file.filename().string();
    TreeLayer trees(layer, name, how.fields, read);
    if (!trees.mayHoldTrees(layer)) return {};
    const auto take = [&](std::size_t, const OGRFeature& feature) -> Result<void> {
        trees.read(feature);
        if (trees.count() <= maxTrees) return {};
        return limitReached(fmt::format("It holds more than {} trees", maxTrees), file.string(),
                            "Cut out the part around the city");
    };
    auto done =
        readFeatures({&layer}, {file.string(), NM_TEXT("reading trees")}, calls, take, progress, stop);
    if (!done) return tl::make_unexpected(done.error());
    if (trees.count() == 0) return {};
    const auto toLonLat = findSystem(layer, trees, file, how.crs, read.warnings);
    if (!toLonLat) return tl::make_unexpected(toLonLat.error());
    trees.place(*toLonLat ? &**toLonLat : nullptr);
    return {};
}

Result<TreesRead> readTreesOfMap(const Path& file, OsmFormat format, Progress& progress,
                                 const std::stop_token& stop) {
    const auto map = readOsmMap(file, format,
                                {.keys = osmTreeKeys(),
                                 .areaKeys = {osmTreeKey},
                                 .lineKeys = {osmTreeKey},
                                 .pointKeys = {osmTreeKey}},
                                progress, stop);
    if (!map) return tl::make_unexpected(map.error());
    TreesRead read{.attribution = osmCredit};
    read.trees = listOsmTrees(*map, read.warnings);
    forEachOsmArea(
        *map, [&](const OsmArea& area) { addOsmWood(area, read.trees, read.warnings); }, stop);
    if (stop.stop_requested()) return cancelled();
    if (read.trees.empty()) return holdsNoTrees(file);
    return read;
}

}  // namespace

Result<TreesRead> readTrees(const Path& file, const TreeReading& how, Progress& progress,
                            const std::stop_token& stop) try {
    const GdalCalls calls(stop);
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (const auto format = findOsmFormat(file)) return readTreesOfMap(file, *format, progress, stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset && isUnknownFormat(dataset.error())) {
        const auto raster = openDataset(file, DatasetContent::elevations);
        if (raster)
            return readCanopy(**raster, file.filename().string(), how.crs, findCanopyUnit(how.fields),
                              progress, stop);
    }
    if (!dataset) return tl::make_unexpected(dataset.error());
    TreesRead read;
    for (OGRLayer* layer : (*dataset)->GetLayers())
        if (auto done = readTreeLayer(*layer, file, how, calls, read, progress, stop); !done)
            return tl::make_unexpected(done.error());
    if (read.trees.empty()) return holdsNoTrees(file);
    return read;
} catch (const std::exception& exception) {
    return failure(fmt::format("The trees cannot be read ({})", exception.what()), file.string(),
                   "Check that the file is complete, or export it again");
}

}  // namespace noonmark
