#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <span>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "core/io/footprints/footprint_layer.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/io/footprints/layer_window.h"
#include "core/io/footprints/map_remarks.h"
#include "core/io/osm/osm_configuration.h"
#include "core/io/osm/osm_semantics.h"
#include "core/io/read_part.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;

constexpr const char* osmLayer = "multipolygons";
constexpr const char* osmCredit = "(c) OpenStreetMap contributors, ODbL";

struct OpenFile {
    GDALDatasetUniquePtr dataset;
    std::string driver;  // "OSM"
    [[nodiscard]] bool isOsm() const { return driver == "OSM"; }
};

Result<OpenFile> openFile(const Path& file, const OsmConfiguration& configuration) {
    auto dataset = openDataset(file, DatasetContent::vectors, {"CONFIG_FILE=" + configuration.path()});
    if (!dataset) return tl::make_unexpected(dataset.error());
    OpenFile open{*std::move(dataset), {}};
    open.driver = open.dataset->GetDriverName();
    if (open.isOsm()) open.dataset->ExecuteSQL("SET interest_layers = multipolygons", nullptr, nullptr);
    return open;
}

std::string formatName(const OpenFile& open, const Path& file) {
    if (open.isOsm()) return file.extension() == ".pbf" ? "OpenStreetMap PBF" : "OpenStreetMap XML";
    if (open.driver == "GPKG") return "GeoPackage";
    if (open.driver == "ESRI Shapefile") return "Shapefile";
    return open.driver;
}

bool mayHavePolygons(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    return type == wkbUnknown || OGR_GT_IsSurface(type) || OGR_GT_IsSubClassOf(type, wkbMultiSurface) ||
           type == wkbGeometryCollection;
}

// The layer that writeCityGeoPackage() writes; other layers of such a file are not buildings.
bool isOurOwn(OGRLayer& layer) {
    const OGRFeatureDefn& fields = *layer.GetLayerDefn();
    return std::string_view(layer.GetName()) == "buildings" && fields.GetFieldIndex("building_id") >= 0 &&
           fields.GetFieldIndex("height_source") >= 0;
}

std::vector<OGRLayer*> polygonLayers(const OpenFile& open) {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : open.dataset->GetLayers()) {
        if (isOurOwn(*layer)) return {layer};
        const bool wanted =
            open.isOsm() ? std::string_view(layer->GetName()) == osmLayer : mayHavePolygons(*layer);
        if (wanted) layers.push_back(layer);
    }
    return layers;
}

std::vector<std::string> layerNames(const OpenFile& open) {
    std::vector<std::string> names;
    for (OGRLayer* layer : open.dataset->GetLayers()) names.emplace_back(layer->GetName());
    return names;
}

Result<std::vector<OGRLayer*>> chosenLayers(const OpenFile& open, const ReadSettings& settings,
                                            const Path& file, Warnings& warnings) {
    if (!settings.layer.empty()) {
        if (OGRLayer* layer = open.dataset->GetLayerByName(settings.layer.c_str())) return std::vector{layer};
        return failure(fmt::format("There is no layer \"{}\"", settings.layer), file.string(),
                       fmt::format("Its layers are: {}", fmt::join(layerNames(open), ", ")));
    }
    auto layers = polygonLayers(open);
    if (layers.empty())
        return failure("It holds no polygons", file.string(), "Export the building footprints as polygons");
    if (layers.size() > 1)
        for (OGRLayer* layer : layers)
            warnings.push_back({WarningKind::assumed,
                                "one of several polygon layers; all are read as buildings",
                                layer->GetName()});
    return layers;
}

constexpr double shareOfReading = 0.8;  // share of the progress; the rest is repair and semantics

// GDAL calls this between blocks of the file, which may contain no usable feature.
int CPL_STDCALL goOn(double, const char*, void* stop) {
    return static_cast<const std::stop_token*>(stop)->stop_requested() ? FALSE : TRUE;
}

// The most frequent warning, for an error; empty without warnings.
std::string commonest(const Warnings& warnings) {
    const auto groups = groupWarnings(warnings);
    const auto most =
        std::ranges::max_element(groups, {}, [](const WarningGroup& group) { return group.where.size(); });
    return most == groups.end() ? "" : lineOf(*most);
}

// GDAL reports a PBF whose nodes are not densely stored in the same way as a damaged one.
std::string adviceFor(const std::filesystem::path& file) {
    if (file.extension() != ".pbf") return "Download or export it again";
    return "Download it again; or, if its nodes are not stored densely, convert it: osmium cat OLD.osm.pbf "
           "-o "
           "NEW.osm.pbf";
}

// Reads all layers, one feature at a time.
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
        if (polygons_ == 0)
            return failure("It holds no polygons", file_.string(),
                           "Export the building footprints as polygons");
        if (found_.empty())
            return failure(fmt::format("None of its {} polygons can be used as a building", polygons_),
                           file_.string(), commonest(warnings));
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

private:
    Result<void> scanBatch(FootprintLayer& reader) {
        constexpr std::size_t batch = 65536;
        if (scan_ == nullptr || features % batch != 0) return {};
        warnings.clear();
        return reader.finish(found_, warnings).map([&] { takeScanned(); });
    }
    void takeScanned() {
        for (const UnplacedFeature& feature : found_) {
            centres_->add(feature);
            scan_->add(feature);
        }
        found_.clear();
    }

    Result<void> readLayer(OGRLayer& layer, bool oneOfSeveral, const GdalCalls& calls) {
        const LayerSource source{file_.filename().string(), open_.isOsm(), open_.driver == "ESRI Shapefile",
                                 oneOfSeveral};
        auto reader = FootprintLayer::of(layer, settings_, source, warnings);
        if (!reader) return tl::make_unexpected(reader.error());
        if (window_ != nullptr && isIndexed(layer)) return readWindow(layer, *reader, calls);
        if (auto done = readFeatures(layer, *reader, calls); !done) return done;
        polygons_ += reader->polygonFeatures();
        reader->addHeightFacts(heights, warnings);
        if (scan_ != nullptr) scan_->indexed = scan_->indexed && isIndexed(layer);
        return reader->finish(found_, warnings).map([&] {
            if (scan_ != nullptr) takeScanned();
        });
    }

    Result<void> readFeatures(OGRLayer& layer, FootprintLayer& reader, const GdalCalls& calls) {
        layer.ResetReading();
        readHere_ = 0;
        countHere_ = open_.isOsm() ? 1 : double(std::max<GIntBig>(1, layer.GetFeatureCount()));
        for (std::size_t failures = calls.failures();; failures = calls.failures()) {
            const OGRFeatureUniquePtr feature = next(layer);
            if (!feature && stop_.stop_requested()) return cancelled();
            if (!feature && calls.failures() > failures)
                return failure("It is incomplete or damaged (" + calls.complaints().back() + ")",
                               file_.string(), adviceFor(file_));
            if (!feature) return {};
            reader.read(*feature, warnings);
            if (++features % 256 != 0) continue;
            if (stop_.stop_requested()) return cancelled();
            if (auto scanned = scanBatch(reader); !scanned) return scanned;
            progress_.report(shareOfReading * share_, "reading " + file_.filename().string());
        }
    }

    // An index delivers features in its own order; the file's order makes the city independent of the window.
    Result<void> readWindow(OGRLayer& layer, FootprintLayer& reader, const GdalCalls& calls) {
        if (!limitToWindow(layer, *window_, settings_))
            return failure("The window cannot be expressed in its coordinate system", file_.string(),
                           "Convert it to EPSG:4326");
        layer.ResetReading();
        const std::size_t failures = calls.failures();
        std::vector<OGRFeatureUniquePtr> inside;
        while (OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
            inside.push_back(std::move(feature));
            if (inside.size() % 256 == 0 && stop_.stop_requested()) return cancelled();
        }
        if (calls.failures() > failures)
            return failure("It is incomplete or damaged (" + calls.complaints().back() + ")", file_.string(),
                           adviceFor(file_));
        std::ranges::sort(inside, {}, [](const OGRFeatureUniquePtr& feature) { return feature->GetFID(); });
        for (const OGRFeatureUniquePtr& feature : inside) reader.read(*feature, warnings);
        features += inside.size();
        polygons_ += reader.polygonFeatures();
        reader.addHeightFacts(heights, warnings);
        return reader.finish(found_, warnings);
    }

    // OpenStreetMap's layers are filled side by side, in the order of the file.
    OGRFeatureUniquePtr next(OGRLayer& layer) {
        if (!open_.isOsm()) {
            share_ = std::min(1.0, double(++readHere_) / countHere_);
            return OGRFeatureUniquePtr(layer.GetNextFeature());
        }
        while (true) {
            OGRLayer* from = nullptr;
            OGRFeatureUniquePtr feature(open_.dataset->GetNextFeature(&from, &share_, goOn, &stop_));
            if (!feature || from == &layer) return feature;
        }
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
    std::size_t polygons_ = 0;
    double share_ = 0;      // share of the current layer
    double countHere_ = 1;  // number of features of the current layer
    std::size_t readHere_ = 0;
};

// GDAL does not name the feature that a message is about: one warning per kind, with its count. Some drivers
// read the whole file when they open it and repeat their messages when it is read: of the first `atOpening`
// messages, those that come again later are skipped.
void keepRemarks(const GdalCalls& calls, std::size_t atOpening, const std::string& file, Warnings& warnings) {
    const std::span said(calls.complaints());
    const auto later = said.subspan(std::min(atOpening, said.size()));
    Warnings remarks;
    for (std::size_t i = 0; i < said.size(); ++i) {
        if (i < atOpening && std::ranges::find(later, said[i]) != later.end()) continue;
        if (std::string what = makeMapRemark(said[i]); !what.empty())
            remarks.push_back({WarningKind::repaired, std::move(what), file});
    }
    for (const WarningGroup& group : groupWarnings(remarks))
        warnings.push_back({group.kind, group.what, fmt::format("{} ({})", file, group.where.size())});
}

void addBuildings(FilePiece& piece, std::vector<AssembledBuilding> buildings, const Frame& frame) {
    for (AssembledBuilding& made : buildings) {
        std::optional<float> ground;
        if (made.elevationM) ground = float(*made.elevationM - frame.originElevationM());
        for (Part& part : made.building.parts) {
            part.bottomM += ground.value_or(0);
            part.topM += ground.value_or(0);
        }
        piece.groundM.push_back(ground);
        piece.buildings.push_back(std::make_shared<const Building>(std::move(made.building)));
    }
}

// Makes buildings from features: all steps after reading.
Result<void> build(FilePiece& piece, std::vector<UnplacedFeature> features, const ReadSettings& settings,
                   Progress& progress, const std::stop_token& stop) {
    if (!settings.frame) piece.frame = frameOf(features);
    const Frame frame = settings.frame ? *settings.frame : *piece.frame;
    progress.report(shareOfReading, "repairing outlines");
    const auto placed = placeFeatures(std::move(features), frame, settings.farAwayM, piece.warnings, stop);
    progress.report(0.9, "making buildings");
    addBuildings(piece, assembleBuildings(placed, settings.metresPerLevel, piece.warnings, stop), frame);
    if (stop.stop_requested()) return cancelled();
    progress.report(1, "making buildings");
    return {};
}

}  // namespace

Result<FilePiece> readFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                 std::stop_token stop, const LonLatBox* window) try {
    const GdalCalls calls;
    const OsmConfiguration configuration(settings.heightField, settings.levelsField);
    auto open = openFile(file, configuration);
    if (!open) return tl::make_unexpected(open.error());
    const std::size_t atOpening = calls.complaints().size();
    FileReader reader(*open, file, settings, progress, stop);
    reader.limitTo(window);
    auto features = reader.read(calls);
    if (!features) return tl::make_unexpected(features.error());
    FilePiece piece{.warnings = std::move(reader.warnings),
                    .format = formatName(*open, file),
                    .features = reader.features,
                    .attribution = open->isOsm() ? osmCredit : "",
                    .heights = std::move(reader.heights)};
    keepRemarks(calls, atOpening, file.filename().string(), piece.warnings);
    if (auto built = build(piece, *std::move(features), settings, progress, stop); !built)
        return tl::make_unexpected(built.error());
    if (!piece.buildings.empty() || window != nullptr) return piece;
    return failure("None of its polygons can be used as a building", file.string(),
                   commonest(piece.warnings));
} catch (const std::exception& exception) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that it is complete, or export it again");
}

Result<FootprintScan> scanFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                     std::stop_token stop) try {
    const GdalCalls calls;
    const OsmConfiguration configuration(settings.heightField, settings.levelsField);
    auto open = openFile(file, configuration);
    if (!open) return tl::make_unexpected(open.error());
    FileReader reader(*open, file, settings, progress, std::move(stop));
    FootprintScan scan;
    FeatureCentres centres;
    reader.scanInto(scan, centres);
    if (auto read = reader.read(calls); !read) return tl::make_unexpected(read.error());
    if (scan.features == 0)
        return failure("None of its polygons can be used as a building", file.string(),
                       "Export the building footprints as polygons");
    scan.frame = centres.frame();
    return scan;
} catch (const std::exception& exception) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that it is complete, or export it again");
}

}  // namespace noonmark
