#include "core/io/footprints/read_parcels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "core/io/footprints/ogr_polygons.h"

namespace noonmark {

namespace {

constexpr std::array defaultNameFields{"name", "lot", "parcel", "apn", "bbl", "id"};

std::vector<std::string> fieldsOf(OGRLayer& layer) {
    std::vector<std::string> names;
    OGRFeatureDefn& features = *layer.GetLayerDefn();
    for (int i = 0; i < features.GetFieldCount(); ++i)
        names.emplace_back(features.GetFieldDefn(i)->GetNameRef());
    return names;
}

// -1 if the layer has none of the default name fields.
Result<int> nameFieldOf(OGRLayer& layer, const std::string& wanted, const std::string& where) {
    if (wanted.empty()) {
        for (const char* standard : defaultNameFields)
            if (const int field = layer.FindFieldIndex(standard, 0); field >= 0) return field;
        return -1;
    }
    if (const int field = layer.FindFieldIndex(wanted.c_str(), 0); field >= 0) return field;
    return failure(fmt::format("The layer has no field '{}'", wanted),
                   fmt::format("{}, layer {}", where, layer.GetName()),
                   fmt::format("Its fields are: {}", fmt::join(fieldsOf(layer), ", ")));
}

bool liesIn(const Region& region, const std::vector<Footprint>& polygons) {
    const Box2 box = bounds(polygons.front());
    const glm::dvec2 middle(box.low + (box.high - box.low) * 0.5F);
    return std::ranges::any_of(region.polygons,
                               [&](const Footprint& polygon) { return contains(polygon, middle); });
}

class ParcelReader {
public:
    ParcelReader(const ParcelSettings& settings, const Frame& frame, std::string where,
                 const std::stop_token& stop)
        : settings_(settings), frame_(frame), where_(std::move(where)), stop_(stop) {}

    Result<void> read(OGRLayer& layer) {
        const auto field = nameFieldOf(layer, settings_.nameField, where_);
        if (!field) return tl::make_unexpected(field.error());
        std::optional<PolygonLayer> polygons;
        for (const OGRFeatureUniquePtr& feature : layer) {
            if (stop_.stop_requested()) return cancelled();
            const OGRGeometry* geometry = feature->GetGeometryRef();
            if (geometry == nullptr) continue;
            if (!polygons) {
                auto made = PolygonLayer::of(layer.GetSpatialRef(), frame_, where_);
                if (!made) return tl::make_unexpected(made.error());
                polygons = *std::move(made);
            }
            if (auto added = add(*polygons, *geometry, *field < 0 ? "" : feature->GetFieldAsString(*field));
                !added)
                return added;
        }
        return {};
    }

    Result<std::vector<Parcel>> finish() && {
        for (const std::string& name : settings_.names)
            if (std::ranges::find(parcels_, name, &Parcel::name) == parcels_.end())
                return failure("No parcel has this name", fmt::format("{}, '{}'", where_, name),
                               examples_.empty()
                                   ? std::string("State the field that holds the names")
                                   : fmt::format("Its names include: {}", fmt::join(examples_, ", ")));
        if (parcels_.empty())
            return failure("No parcel of the file lies in the region", where_,
                           "Check the region, or the CRS of the file");
        return std::move(parcels_);
    }

private:
    Result<void> add(const PolygonLayer& reader, const OGRGeometry& geometry, const std::string& name) {
        if (!isWanted(name)) return {};
        if (settings_.within && !reader.mayReach(geometry, bounds(*settings_.within))) return {};
        auto pieces = reader.polygons(geometry);
        if (!pieces) return tl::make_unexpected(pieces.error());
        if (pieces->empty() || (settings_.within && !liesIn(*settings_.within, *pieces))) return {};
        if (parcels_.size() == ParcelSettings::maxParcels)
            return failure(fmt::format("There are more than {} parcels", ParcelSettings::maxParcels), where_,
                           "Choose parcels by name, or give a smaller region");
        parcels_.push_back({name, *std::move(pieces)});
        return {};
    }

    bool isWanted(const std::string& name) {
        if (settings_.names.empty()) return true;
        if (examples_.size() < 5) examples_.push_back(name);
        return std::ranges::find(settings_.names, name) != settings_.names.end();
    }

    const ParcelSettings& settings_;
    Frame frame_;
    std::string where_;
    const std::stop_token& stop_;
    std::vector<Parcel> parcels_;
    std::vector<std::string> examples_;  // some names from the file, for messages
};

Result<std::vector<OGRLayer*>> layersOf(GDALDataset& dataset, const std::string& wanted,
                                        const std::string& where) {
    std::vector<OGRLayer*> layers;
    std::vector<std::string> names;
    for (OGRLayer* layer : dataset.GetLayers()) {
        names.emplace_back(layer->GetName());
        if (wanted.empty() || names.back() == wanted) layers.push_back(layer);
    }
    if (!layers.empty()) return layers;
    return failure(fmt::format("The file has no layer '{}'", wanted), where,
                   fmt::format("Its layers are: {}", fmt::join(names, ", ")));
}

}  // namespace

Result<std::vector<Parcel>> readParcels(const std::filesystem::path& file, const ParcelSettings& settings,
                                        const Frame& frame, const std::stop_token& stop) {
    const GdalCalls calls(stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset) return tl::make_unexpected(dataset.error());
    const auto layers = layersOf(**dataset, settings.layer, file.string());
    if (!layers) return tl::make_unexpected(layers.error());
    ParcelReader reader(settings, frame, file.string(), stop);
    for (OGRLayer* layer : *layers)
        if (auto read = reader.read(*layer); !read) return tl::make_unexpected(read.error());
    if (stop.stop_requested()) return cancelled();
    return std::move(reader).finish();
}

}  // namespace noonmark
