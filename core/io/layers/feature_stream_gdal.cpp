#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>

#include "core/geo/crs.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

class Reading {
public:
    Reading(const std::vector<OGRLayer*>& layers, const FeatureStream& stream, const GdalCalls& calls,
            const TakeFeature& take, Progress& progress, const std::stop_token& stop)
        : layers_(layers), stream_(stream), calls_(calls), take_(take), progress_(progress), stop_(stop) {}

    Result<std::size_t> run() {
        for (std::size_t layer = 0; layer < layers_.size(); ++layer)
            if (auto done = read(layer); !done) return tl::make_unexpected(done.error());
        return features_;
    }

private:
    Result<void> read(std::size_t layer) {
        layers_[layer]->ResetReading();
        for (std::size_t failures = calls_.failures();; failures = calls_.failures()) {
            const OGRFeatureUniquePtr feature(layers_[layer]->GetNextFeature());
            if (!feature && stop_.stop_requested()) return cancelled();
            if (!feature && calls_.failures() > failures)
                return failure("It is incomplete or damaged (" + calls_.complaints().back() + ")",
                               stream_.file, "Download or export it again");
            if (!feature) return {};
            if (auto taken = take_(layer, *feature); !taken) return taken;
            if (++features_ % 256 != 0) continue;
            if (stop_.stop_requested()) return cancelled();
            progress_.report(stream_.share * double(layer) / double(layers_.size()), stream_.what);
        }
    }

    const std::vector<OGRLayer*>& layers_;
    const FeatureStream& stream_;
    const GdalCalls& calls_;
    const TakeFeature& take_;
    Progress& progress_;
    const std::stop_token& stop_;
    std::size_t features_ = 0;
};

}  // namespace

Result<std::size_t> readFeatures(const std::vector<OGRLayer*>& layers, const FeatureStream& stream,
                                 const GdalCalls& calls, const TakeFeature& take, Progress& progress,
                                 const std::stop_token& stop) {
    return Reading(layers, stream, calls, take, progress, stop).run();
}

Result<CrsToLonLat> findLayerCrs(OGRLayer& layer, const std::optional<std::string>& crs,
                                 const std::string& file) {
    if (crs) return CrsToLonLat::of(*crs);
    const OGRSpatialReference* system = layer.GetSpatialRef();
    const bool known = system != nullptr && system->GetName() != nullptr &&
                       !std::string_view(system->GetName()).starts_with("Undefined");
    // GeoPackage defines systems that mean "unknown".
    if (!known) return failure("It does not state its coordinate reference system", file, crsAdvice());
    const std::string wkt = wktOf(system);
    if (auto harmless = checkNamesNoFile(wkt); !harmless)
        return failure(harmless.error().what, file, crsAdvice());
    auto transform = CrsToLonLat::of(wkt);
    if (transform) return transform;
    return failure(fmt::format("Its coordinate reference system, {}, is not known", system->GetName()), file,
                   crsAdvice());
}

OGRSpatialReference findLayerSystem(OGRLayer& layer, const std::optional<std::string>& crs) {
    OGRSpatialReference system;
    if (crs)
        system = parseCrs(*crs).value_or(system);
    else if (layer.GetSpatialRef() != nullptr)
        system = *layer.GetSpatialRef();
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

Result<int> findNamedField(OGRLayer& layer, const std::string& name, const std::string& file) {
    if (const int field = layer.FindFieldIndex(name.c_str(), 0); field >= 0) return field;
    std::vector<std::string> names;
    for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
        names.emplace_back(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
    return failure(fmt::format("The layer has no field '{}'", name),
                   fmt::format("{}, layer {}", file, layer.GetName()),
                   fmt::format("Its fields are: {}", fmt::join(names, ", ")));
}

}  // namespace noonmark
