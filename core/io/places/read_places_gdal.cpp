#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

#include "core/base/gdal_calls.h"
#include "core/describe/text.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/osm_layers.h"
#include "core/io/osm/read_osm_buildings.h"
#include "core/io/places/place_layer.h"
#include "core/io/places/read_places.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;

bool mayHoldPolygons(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    return type == wkbUnknown || OGR_GT_IsSurface(type) || OGR_GT_IsSubClassOf(type, wkbMultiSurface) ||
           type == wkbGeometryCollection;
}

bool mayHoldLines(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    return type == wkbUnknown || OGR_GT_IsCurve(type) || OGR_GT_IsSubClassOf(type, wkbMultiCurve) ||
           type == wkbGeometryCollection;
}

// Whoever wants nothing but streets does not want polygons of a file of lines.
bool mayHoldPlaces(OGRLayer& layer, const PlaceSettings& settings) {
    const bool onlyStreets = settings.streets && settings.kinds == std::set{PlaceKind::street};
    return (settings.streets && mayHoldLines(layer)) ||
           (mayHoldPolygons(layer) && (!onlyStreets || PlaceLayer::statesKinds(layer)));
}

bool isWantedLayer(OGRLayer& layer, bool fromOsm, const PlaceSettings& settings) {
    const std::string_view name = layer.GetName();
    if (fromOsm) return name == "multipolygons" || (settings.streets && name == "lines");
    return settings.layer.empty() ? mayHoldPlaces(layer, settings) : name == settings.layer;
}

std::vector<std::string> namesOf(const std::vector<OGRLayer*>& layers) {
    std::vector<std::string> names;
    for (OGRLayer* layer : layers) names.emplace_back(layer->GetName());
    return names;
}

// Of several layers those that state kinds; the others are the city's, or nobody knows what.
std::vector<OGRLayer*> keepStated(const std::vector<OGRLayer*>& layers) {
    std::vector<OGRLayer*> stated;
    std::ranges::copy_if(layers, std::back_inserter(stated),
                         [](OGRLayer* layer) { return PlaceLayer::statesKinds(*layer); });
    return layers.size() > 1 && !stated.empty() ? stated : layers;
}

tl::unexpected<Error> noShapes(const std::string& file, const PlaceSettings& settings) {
    if (settings.streets)
        return failure("It holds neither polygons nor lines", file,
                       "Export the places as polygons, or streets as lines");
    return failure("It holds no polygons", file,
                   "Export the places as polygons; lines can be read as streets");
}

// A project's own layer of places alone, else all that may hold some.
std::vector<OGRLayer*> findWantedLayers(GDALDataset& dataset, const PlaceSettings& settings) {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (settings.layer.empty() && PlaceLayer::isOfProject(*layer)) return {layer};
        if (isWantedLayer(*layer, isFromOsm(dataset), settings)) layers.push_back(layer);
    }
    return isFromOsm(dataset) ? layers : keepStated(layers);
}

// Of several layers that state nothing, only the user knows which holds places.
bool isUndecided(const std::vector<OGRLayer*>& layers, GDALDataset& dataset) {
    return layers.size() > 1 && !isFromOsm(dataset) && !PlaceLayer::statesKinds(*layers.front());
}

UnknownLayer describeLayer(OGRLayer& layer) {
    UnknownLayer made{layer.GetName(), std::size_t(std::max<GIntBig>(0, layer.GetFeatureCount())), {}};
    const OGRFeatureDefn& fields = *layer.GetLayerDefn();
    for (int i = 0; i < fields.GetFieldCount(); ++i)
        if (fields.GetFieldDefn(i)->GetType() == OFTString)
            made.textFields.emplace_back(fields.GetFieldDefn(i)->GetNameRef());
    return made;
}

Result<std::vector<OGRLayer*>> layersToRead(GDALDataset& dataset, const PlaceSettings& settings,
                                            const std::string& file) {
    const std::vector<OGRLayer*> layers = findWantedLayers(dataset, settings);
    if (isUndecided(layers, dataset))
        return failure("It holds several layers, and none says what kinds of places it has", file,
                       fmt::format("Choose the one with the places: {}", fmt::join(namesOf(layers), ", ")));
    if (!layers.empty()) return layers;
    if (settings.layer.empty()) return noShapes(file, settings);
    const auto all = dataset.GetLayers();
    return failure(fmt::format("There is no layer \"{}\"", settings.layer), file,
                   fmt::format("Its layers are: {}",
                               fmt::join(namesOf(std::vector<OGRLayer*>(all.begin(), all.end())), ", ")));
}

class PlaceFile {
public:
    PlaceFile(GDALDataset& dataset, const Path& file, const PlaceSettings& settings, Progress& progress,
              const std::stop_token& stop)
        : dataset_(dataset),
          file_(file.filename().string()),
          settings_(settings),
          progress_(progress),
          stop_(stop) {}

    Result<void> read(const GdalCalls& calls) {
        auto layers = layersToRead(dataset_, settings_, file_);
        if (!layers) return tl::make_unexpected(layers.error());
        for (OGRLayer* layer : *layers) {
            auto reader = PlaceLayer::of(*layer, settings_, file_, sourceStart(*layer), isFromOsm(dataset_));
            if (!reader) return tl::make_unexpected(reader.error());
            layers_.push_back(layer);
            readers_.push_back(*std::move(reader));
        }
        return readFeatures(
                   layers_, {file_, NM_TEXT("reading places")}, calls,
                   [&](std::size_t layer, const OGRFeature& feature) { return take(layer, feature); },
                   progress_, stop_)
            .map([&](std::size_t features) { features_ = features; });
    }

    Result<PlacesRead> place(const Frame& frame) {
        PlacesRead read{.features = features_, .attribution = isFromOsm(dataset_) ? osmCredit : ""};
        std::vector<Place> areas;
        std::vector<StreetPiece> streets;
        std::size_t usable = 0;
        for (const PlaceLayer& reader : readers_) {
            progress_.report(0.8, NM_TEXT("repairing outlines"));
            std::ranges::move(reader.placeAreas(frame, read, stop_), std::back_inserter(areas));
            std::ranges::move(reader.placeStreets(frame, read), std::back_inserter(streets));
            usable += reader.usableFeatures();
        }
        if (usable == 0 && !isFromOsm(dataset_)) return noShapes(file_, settings_);
        warnOfOtherLayers(read.warnings);
        read.places = joinAreas(std::move(areas));
        if (stop_.stop_requested()) return cancelled();
        std::ranges::move(makeStreets(streets, {settings_.wholeStreets, settings_.sidewalkM},
                                      sourceStart(*layers_.front()), read.warnings),
                          std::back_inserter(read.places));
        std::erase_if(read.places, [&](const Place& place) { return area(place) < settings_.minAreaM2; });
        makeNamesUnique(read.places);
        if (stop_.stop_requested()) return cancelled();
        progress_.report(1, NM_TEXT("reading places"));
        return read;
    }

private:
    // Before the ids of its places: those of several layers of a file are numbered alike.
    [[nodiscard]] std::string sourceStart(OGRLayer& layer) const {
        if (isFromOsm(dataset_)) return "OSM ";
        const bool isAlone = dataset_.GetLayerCount() == 1 || PlaceLayer::isOfProject(layer);
        return isAlone ? file_ + ", " : fmt::format("{}, {}, ", file_, layer.GetName());
    }

    // Of a project its places are wanted, and of OpenStreetMap layers have no meaning of their own.
    void warnOfOtherLayers(Warnings& warnings) const {
        if (isFromOsm(dataset_) || !settings_.layer.empty() || PlaceLayer::isOfProject(*layers_.front()))
            return;
        for (OGRLayer* layer : dataset_.GetLayers()) {
            const auto features = std::max<GIntBig>(0, layer->GetFeatureCount());
            if (features > 0 && std::ranges::find(layers_, layer) == layers_.end())
                warnings.push_back({WarningKind::leftOut, "layer not read as places",
                                    fmt::format("{}: {}, features: {}", file_, layer->GetName(), features)});
        }
    }

    Result<void> take(std::size_t layer, const OGRFeature& feature) {
        readers_[layer].read(feature);
        if (readers_[layer].kept() <= PlaceSettings::maxPlaces) return {};
        return limitReached(fmt::format("It holds more than {} places", PlaceSettings::maxPlaces), file_,
                            "Cut out the part around the city");
    }

    GDALDataset& dataset_;
    std::string file_;
    const PlaceSettings& settings_;
    Progress& progress_;
    const std::stop_token& stop_;
    std::vector<OGRLayer*> layers_;
    std::vector<PlaceLayer> readers_;
    std::size_t features_ = 0;
};

// Keys of the tags by which areas are places (place_tags.h) are also those that make a closed way an area.
OsmSelection selectPlaces(const PlaceSettings& settings) {
    const std::vector<std::string> kinds{"leisure", "landuse", "amenity", "historic",
                                         "natural", "place",   "tourism"};
    OsmSelection selection{.keys = kinds, .areaKeys = kinds, .kindKeys = kinds};
    for (const char* key : {"name", "highway", "building", "location", "layer", "tunnel"})
        selection.keys.emplace_back(key);
    selection.kindKeys.emplace_back("highway");
    if (!settings.streets) return selection;
    selection.lineKeys = {"highway"};
    for (const char* key : {"width", "lanes", "area"}) selection.keys.emplace_back(key);
    return selection;
}

Result<DatasetPointer> openPlaces(const Path& file, const PlaceSettings& settings, Progress& progress,
                                  const std::stop_token& stop) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (const auto osm = findOsmFormat(file))
        return readOsmLayers(file, *osm, selectPlaces(settings), progress, stop);
    return openDataset(file, DatasetContent::vectors);
}

Result<PlacesRead> readFrom(GDALDataset& dataset, const Path& file, const PlaceSettings& settings,
                            const Frame& frame, const GdalCalls& calls, Progress& progress,
                            const std::stop_token& stop) {
    if (settings.listLayers)
        if (auto layers = findWantedLayers(dataset, settings); isUndecided(layers, dataset)) {
            PlacesRead undecided;
            for (OGRLayer* layer : layers) undecided.layers.push_back(describeLayer(*layer));
            return undecided;
        }
    PlaceFile reader(dataset, file, settings, progress, stop);
    if (auto read = reader.read(calls); !read) return tl::make_unexpected(read.error());
    return reader.place(frame);
}

tl::unexpected<Error> placesNotRead(const std::exception& exception, const Path& file) {
    return failure(fmt::format("The places cannot be read ({})", exception.what()), file.string(),
                   "Check that the file is complete, or export it again");
}

}  // namespace

Result<PlacesRead> readPlaces(const Path& file, const PlaceSettings& settings, const Frame& frame,
                              Progress& progress, const std::stop_token& stop) try {
    const GdalCalls calls(stop);
    const auto dataset = openPlaces(file, settings, progress, stop);
    if (!dataset) return tl::make_unexpected(dataset.error());
    return readFrom(**dataset, file, settings, frame, calls, progress, stop);
} catch (const std::exception& exception) {
    return placesNotRead(exception, file);
}

namespace {

bool hasLines(GDALDataset& dataset) {
    for (OGRLayer* layer : dataset.GetLayers())
        if (wkbFlatten(layer->GetGeomType()) != wkbUnknown && mayHoldLines(*layer)) return true;
    return false;
}

}  // namespace

Result<PlacesRead> readStreetLines(const Path& file, const PlaceSettings& settings, const Frame& frame,
                                   Progress& progress, const std::stop_token& stop) try {
    if (!checkPlainFile(file) || findOsmFormat(file)) return PlacesRead{};
    const GdalCalls calls(stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (stop.stop_requested()) return cancelled();
    if (!dataset || !hasLines(**dataset)) return PlacesRead{};
    return readFrom(**dataset, file, settings, frame, calls, progress, stop);
} catch (const std::exception& exception) {
    return placesNotRead(exception, file);
}

bool isOsmFile(const Path& file) { return checkPlainFile(file) && findOsmFormat(file); }

}  // namespace noonmark
