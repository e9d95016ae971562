#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <tbb/task_group.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>

#include "core/base/gdal_calls.h"
#include "core/geo/lon_lat.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/build_footprints.h"
#include "core/io/footprints/building_layers.h"
#include "core/io/footprints/footprint_layer.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/io/formats/format.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/layers/written_crs.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

class OGRLayer;

namespace noonmark {

namespace {

/// Limits the layer to the features that touch the window. False where the window cannot be expressed
/// in the layer's coordinate system.
bool limitToExtent(OGRLayer& layer, const LonLatBox& window, const ReadSettings& settings);

/// Whether the layer finds the features of a window by a spatial index, without reading the others. Backend:
/// read_footprints_gdal.cpp.
bool isIndexed(OGRLayer& layer) { return layer.TestCapability(OLCFastSpatialFilter) != FALSE; }

bool limitToExtent(OGRLayer& layer, const LonLatBox& box, const ReadSettings& settings) {
    constexpr int pointsOnASide = 21;
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const OGRSpatialReference system = findLayerSystem(layer, settings.crs);
    const std::unique_ptr<OGRCoordinateTransformation> there(
        OGRCreateCoordinateTransformation(&degrees, &system));
    if (!there) return false;
    double west = 0, south = 0, east = 0, north = 0;
    if (there->TransformBounds(box.westDeg, box.southDeg, box.eastDeg, box.northDeg, &west, &south, &east,
                               &north, pointsOnASide) == FALSE)
        return false;
    layer.SetSpatialFilterRect(west, south, east, north);
    return true;
}

using Path = std::filesystem::path;

struct OpenFile {
    GDALDatasetUniquePtr dataset;
    std::string driver;                      // "GPKG"
    std::shared_ptr<const KmlPolygons> kml;  // of a KML file only
};

void copyWithData(OGRLayer& from, OGRLayer& into, const KmlPolygons& polygons) {
    OGRFeatureDefn& fields = *from.GetLayerDefn();
    for (int i = 0; i < fields.GetFieldCount(); ++i) into.CreateField(fields.GetFieldDefn(i));
    for (const std::string& name : polygons.fields()) {
        OGRFieldDefn field(name.c_str(), OFTString);
        if (fields.GetFieldIndex(name.c_str()) < 0) into.CreateField(&field);
    }
    for (auto& feature : from) {
        OGRFeature copy(into.GetLayerDefn());
        copy.SetFrom(feature.get());
        const OGRGeometry* const geometry = feature->GetGeometryRef();
        const auto corner = geometry == nullptr ? std::nullopt : KmlPolygons::firstCornerOf(*geometry);
        if (const auto* data = corner ? polygons.findData(*corner) : nullptr; data != nullptr)
            for (const auto& [name, value] : *data) copy.SetField(name.c_str(), value.c_str());
        if (into.CreateFeature(&copy) != OGRERR_NONE)
            throw std::runtime_error("a placemark cannot be kept in memory");
    }
}

// GDAL's reader of KML has names and descriptions only; other fields stand in ExtendedData.
GDALDatasetUniquePtr withKmlData(GDALDatasetUniquePtr kml, const KmlPolygons& polygons) {
    if (polygons.fields().empty()) return kml;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("Memory");
    if (driver == nullptr) throw std::runtime_error("GDAL was built without its driver for memory");
    GDALDatasetUniquePtr copy(driver->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    for (OGRLayer* layer : kml->GetLayers())
        copyWithData(*layer,
                     *copy->CreateLayer(layer->GetName(), layer->GetSpatialRef(), wkbUnknown, nullptr),
                     polygons);
    return copy;
}

Result<OpenFile> openFile(const Path& file) {
    auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset) return tl::make_unexpected(dataset.error());
    OpenFile open{*std::move(dataset), {}, {}};
    open.driver = open.dataset->GetDriverName();
    if (open.driver != "KML") return open;
    open.kml = std::make_shared<const KmlPolygons>(KmlPolygons::of(file));
    open.dataset = withKmlData(std::move(open.dataset), *open.kml);
    return open;
}

std::string formatName(const OpenFile& open) {
    const Format* format = findByDriver(open.driver, FileKind::footprints);
    return format == nullptr ? open.driver : std::string(format->nameInResults());
}

std::vector<std::string> layerNames(const OpenFile& open) {
    std::vector<std::string> names;
    for (OGRLayer* layer : open.dataset->GetLayers()) names.emplace_back(layer->GetName());
    return names;
}

tl::unexpected<Error> noPolygons(const OpenFile& open, const Path& file) {
    const bool isTable = open.driver == "CSV";
    return failure(isTable ? "It holds no polygons: no column has outlines as WKT" : "It holds no polygons",
                   file.string(),
                   isTable ? "Export the outlines into a column named WKT: POLYGON ((4.9 52.3, ...))"
                           : "Export the building footprints as polygons");
}

Result<std::vector<OGRLayer*>> chosenLayers(const OpenFile& open, const ReadSettings& settings,
                                            const Path& file, Warnings& warnings) {
    if (!settings.layer.empty()) {
        if (OGRLayer* layer = open.dataset->GetLayerByName(settings.layer.c_str())) return std::vector{layer};
        return failure(fmt::format("There is no layer \"{}\"", settings.layer), file.string(),
                       fmt::format("Its layers are: {}", fmt::join(layerNames(open), ", ")));
    }
    auto layers = chooseBuildingLayers(*open.dataset, warnings);
    if (layers.empty()) return noPolygons(open, file);
    return layers;
}

// Tables and TopoJSON name no system, others may; numbers that are all longitudes and latitudes are taken for
// them.
bool holdsDegrees(OGRLayer& layer) {
    OGREnvelope extent;
    return layer.GetSpatialRef() == nullptr && layer.GetExtent(&extent) == OGRERR_NONE &&
           std::max(std::abs(extent.MinX), std::abs(extent.MaxX)) <= 180 &&
           std::max(std::abs(extent.MinY), std::abs(extent.MaxY)) <= 90;
}

// INSPIRE nests a height two elements below its name, and GDAL names a field after the innermost one:
// "value", whose unit of length stands beside it. Areas are nested likewise, in square metres.
std::optional<LengthUnit> findNestedHeight(OGRLayer& layer) {
    const int value = layer.FindFieldIndex("value", 1), unit = layer.FindFieldIndex("value_uom", 1);
    if (value < 0 || unit < 0) return std::nullopt;
    layer.ResetReading();
    const OGRFeatureUniquePtr first(layer.GetNextFeature());
    layer.ResetReading();
    const std::string written = first ? first->GetFieldAsString(unit) : "";
    if (written == "m" || written.ends_with("#m")) return LengthUnit::metres;
    return written == "ft" ? std::optional(LengthUnit::feet) : std::nullopt;
}

using OgrFeatures = std::vector<OGRFeatureUniquePtr>;

// Reads all layers. While one thread reads the next chunk of features from the file, another one interprets
// the chunk before.
class FileReader {
public:
    FileReader(const OpenFile& open, const Path& file, const ReadSettings& settings, Progress& progress,
               std::stop_token stop)
        : open_(open), file_(file), settings_(settings), progress_(progress), stop_(std::move(stop)) {}

    Result<std::vector<UnplacedFeature>> read(const GdalCalls& calls) {
        auto layers = chosenLayers(open_, settings_, file_, warnings);
        if (!layers) return tl::make_unexpected(layers.error());
        for (OGRLayer* layer : *layers)
            if (auto done = readLayer(*layer, layers->size() > 1, calls); !done)
                return tl::make_unexpected(done.error());
        if ((window_ != nullptr || scan_ != nullptr) && found_.empty()) return std::move(found_);
        if (polygons_ == 0) return noPolygons(open_, file_);
        if (found_.empty())
            return failure(fmt::format("None of its {} polygons can be used as a building", polygons_),
                           file_.string(), findMostFrequent(warnings));
        return std::move(found_);
    }

    void limitTo(const LonLatBox* window) { window_ = window; }

    /// Hands features over in batches instead of returning them all; read() then returns none.
    void scanInto(FootprintScan& scan, FeatureCentres& centres) {
        scan_ = &scan;
        centres_ = &centres;
    }

    Warnings warnings;
    std::size_t features = 0;
    HeightFacts heights;
    std::string crs;  // of the first layer

private:
    void interpret(const OgrFeatures& chunk, FootprintLayer& reader) {
        const StopScope scope(stop_);
        for (const OGRFeatureUniquePtr& feature : chunk) {
            if (open_.driver == "CSV" && feature->GetGeometryRef() == nullptr)
                feature->SetGeometryDirectly(readWrittenGeometry(*feature).release());
            reader.read(*feature, warnings);
        }
        features += chunk.size();
        reader.moveStored(found_, warnings);
        if (scan_ != nullptr) takeScanned();
    }
    void takeScanned() {
        warnings.clear();
        for (const UnplacedFeature& feature : found_) {
            centres_->add(feature);
            scan_->add(feature);
        }
        found_.clear();
    }

    Result<void> readLayer(OGRLayer& layer, bool oneOfSeveral, const GdalCalls& calls) {
        const LayerSource source{file_.filename().string(), open_.driver == "ESRI Shapefile", oneOfSeveral,
                                 open_.kml, listFieldAliases(*open_.dataset, layer)};
        auto reader = FootprintLayer::of(layer, settingsFor(layer), source, warnings);
        if (!reader) return tl::make_unexpected(reader.error());
        if (crs.empty()) crs = describeCrs(reader->systemName(), crsSource_);
        if (window_ != nullptr && isIndexed(layer)) return readExtent(layer, *reader, calls);
        if (auto done = readFeatures(layer, *reader, calls); !done) return done;
        if (scan_ != nullptr) scan_->indexed = scan_->indexed && isIndexed(layer);
        return finishLayer(*reader);
    }

    void takeNestedHeights(OGRLayer& layer, ReadSettings& settings) {
        if (open_.driver != "GML" || !settings.heightField.empty()) return;
        const auto unit = findNestedHeight(layer);
        if (!unit) return;
        settings.heightField = "value";
        if (!settings.heightUnit) settings.heightUnit = unit;
        warnings.push_back({WarningKind::assumed,
                            "lengths that are nested in its buildings are taken for their heights above the "
                            "ground, as in INSPIRE",
                            fmt::format("{}: value ({})", file_.filename().string(), entryOf(*unit).name)});
    }

    ReadSettings settingsFor(OGRLayer& layer) {
        ReadSettings settings = settings_;
        takeNestedHeights(layer, settings);
        crsSource_ = settings_.crs ? CrsSource::user : CrsSource::file;
        // FlatGeobuf states one, but programs of browsers leave it out.
        constexpr std::array statingNone{"CSV", "TopoJSON", "FlatGeobuf"};
        const bool statesNone = std::ranges::find(statingNone, open_.driver) != statingNone.end();
        if (!statesNone || settings.crs) return settings;
        if (settings.crs = findWrittenCrs(layer); settings.crs || !holdsDegrees(layer)) return settings;
        settings.crs = "EPSG:4326";
        crsSource_ = CrsSource::guessed;
        warnings.push_back(
            {WarningKind::assumed,
             fmt::format("the file names no coordinate reference system; its numbers are taken "
                         "for degrees ({})",
                         readOption("crs", *settings.crs)),
             file_.filename().string()});
        return settings;
    }

    Result<void> finishLayer(FootprintLayer& reader) {
        polygons_ += reader.polygonFeatures();
        reader.addHeightFacts(heights, warnings);
        return reader.checkPlace(warnings);
    }

    Result<void> readFeatures(OGRLayer& layer, FootprintLayer& reader, const GdalCalls& calls) {
        layer.ResetReading();
        readHere_ = 0;
        countHere_ = double(std::max<GIntBig>(1, layer.GetFeatureCount()));
        OgrFeatures chunk;
        tbb::task_group interpreting;  // destroyed first: it waits
        for (;;) {
            auto next = readChunk(layer, calls);
            interpreting.wait();
            if (!next) return tl::make_unexpected(next.error());
            if (next->empty()) return {};
            chunk = *std::move(next);
            interpreting.run([&] { interpret(chunk, reader); });
        }
    }

    // Empty at the layer's end.
    Result<OgrFeatures> readChunk(OGRLayer& layer, const GdalCalls& calls) {
        constexpr std::size_t chunkSize = 2048;
        OgrFeatures chunk;
        for (std::size_t failures = calls.failures(); chunk.size() < chunkSize; failures = calls.failures()) {
            OGRFeatureUniquePtr feature(layer.GetNextFeature());
            if (!feature && calls.failures() > failures && !stop_.stop_requested()) return damaged(calls);
            if (!feature) break;
            chunk.push_back(std::move(feature));
            if (++readHere_ % 256 != 0) continue;
            if (stop_.stop_requested()) break;
            const double share = std::min(1.0, double(readHere_) / countHere_);
            progress_.report(shareOfReading * share, file_.filename().string());
        }
        if (stop_.stop_requested()) return cancelled();
        return chunk;
    }

    [[nodiscard]] tl::unexpected<Error> damaged(const GdalCalls& calls) const {
        return failure("It is incomplete or damaged (" + calls.complaints().back() + ")", file_.string(),
                       "Download or export it again");
    }

    // An index delivers features in its own order; the file's order makes the city independent of the window.
    Result<void> readExtent(OGRLayer& layer, FootprintLayer& reader, const GdalCalls& calls) {
        if (!limitToExtent(layer, *window_, settings_))
            return failure("The extent cannot be expressed in its coordinate system", file_.string(),
                           "Convert it to EPSG:4326");
        layer.ResetReading();
        const std::size_t failures = calls.failures();
        OgrFeatures inside;
        while (OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
            inside.push_back(std::move(feature));
            if (inside.size() % 256 == 0 && stop_.stop_requested()) return cancelled();
        }
        if (calls.failures() > failures) return damaged(calls);
        std::ranges::sort(inside, {}, [](const OGRFeatureUniquePtr& feature) { return feature->GetFID(); });
        interpret(inside, reader);
        return finishLayer(reader);
    }

    const LonLatBox* window_ = nullptr;
    FootprintScan* scan_ = nullptr;
    FeatureCentres* centres_ = nullptr;
    const OpenFile& open_;
    const Path& file_;
    const ReadSettings& settings_;
    Progress& progress_;
    std::stop_token stop_;
    std::vector<UnplacedFeature> found_;
    CrsSource crsSource_ = CrsSource::file;
    std::size_t polygons_ = 0;
    double countHere_ = 1;  // number of features of the current layer
    std::size_t readHere_ = 0;
};

// Some drivers read the whole file when they open it and repeat their messages when it is read: of the first
// `atOpening` messages, those that come again later are skipped.
void keepRemarks(const GdalCalls& calls, std::size_t atOpening, const std::string& file, Warnings& warnings) {
    const std::span said(calls.complaints());
    const auto later = said.subspan(std::min(atOpening, said.size()));
    std::vector<std::string> once;
    for (std::size_t i = 0; i < said.size(); ++i)
        if (i >= atOpening || std::ranges::find(later, said[i]) == later.end()) once.push_back(said[i]);
    addMapRemarks(once, file, warnings);
}

}  // namespace

Result<FilePiece> readFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                 std::stop_token stop, const LonLatBox* window) try {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    const GdalCalls calls(stop);
    auto open = openFile(file);
    if (!open) return tl::make_unexpected(open.error());
    const std::size_t atOpening = calls.complaints().size();
    FileReader reader(*open, file, settings, progress, stop);
    reader.limitTo(window);
    auto features = reader.read(calls);
    if (!features) return tl::make_unexpected(features.error());
    FilePiece piece{.warnings = std::move(reader.warnings),
                    .format = formatName(*open),
                    .features = reader.features,
                    .attribution = {},
                    .heights = std::move(reader.heights),
                    .crs = std::move(reader.crs)};
    keepRemarks(calls, atOpening, file.filename().string(), piece.warnings);
    if (auto built = buildFootprints(piece, *std::move(features), settings, progress, stop); !built)
        return tl::make_unexpected(built.error());
    if (!piece.buildings.empty() || window != nullptr) return piece;
    return failure("None of its polygons can be used as a building", file.string(),
                   findMostFrequent(piece.warnings));
} catch (const std::exception& exception) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that it is complete, or export it again");
}

Result<FootprintScan> scanFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                     std::stop_token stop) try {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    const GdalCalls calls(stop);
    auto open = openFile(file);
    if (!open) return tl::make_unexpected(open.error());
    FileReader reader(*open, file, settings, progress, std::move(stop));
    FootprintScan scan;
    FeatureCentres centres;
    reader.scanInto(scan, centres);
    if (auto read = reader.read(calls); !read) return tl::make_unexpected(read.error());
    if (scan.features == 0)
        return failure("None of its polygons can be used as a building", file.string(),
                       "Export the building footprints as polygons");
    scan.frame = centres.frame(settings.farAwayM);
    return scan;
} catch (const std::exception& exception) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that it is complete, or export it again");
}

}  // namespace noonmark
