#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>

#include "core/io/footprints/place_advice.h"
#include "core/io/layers/feature_stream.h"

namespace noonmark {

namespace {

// GDAL calls this between blocks of the file, which may contain no usable feature.
int CPL_STDCALL goOnReading(double, const char*, void* stop) {
    return static_cast<const std::stop_token*>(stop)->stop_requested() ? FALSE : TRUE;
}

class Reading {
public:
    Reading(GDALDataset& dataset, const std::vector<OGRLayer*>& layers, const FeatureStream& stream,
            const GdalCalls& calls, const TakeFeature& take, Progress& progress, const std::stop_token& stop)
        : dataset_(dataset),
          layers_(layers),
          stream_(stream),
          calls_(calls),
          take_(take),
          progress_(progress),
          stop_(stop) {}

    Result<std::size_t> run() {
        const auto done = isFromOsm(dataset_) ? readTogether() : readApart();
        if (!done) return tl::make_unexpected(done.error());
        return features_;
    }

private:
    struct Next {
        OGRFeatureUniquePtr feature;
        std::size_t layer = 0;
    };

    Result<void> readApart() {
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            layers_[i]->ResetReading();
            const auto next = [&](double&) {
                return Next{OGRFeatureUniquePtr(layers_[i]->GetNextFeature()), i};
            };
            if (auto done = readAll(next); !done) return done;
        }
        return {};
    }

    Result<void> readTogether() {
        return readAll([&](double& share) -> Next {
            while (true) {
                OGRLayer* from = nullptr;
                OGRFeatureUniquePtr feature(dataset_.GetNextFeature(&from, &share, goOnReading,
                                                                    const_cast<std::stop_token*>(&stop_)));
                if (!feature) return {};
                const auto layer = std::ranges::find(layers_, from);
                if (layer != layers_.end()) return {std::move(feature), std::size_t(layer - layers_.begin())};
            }
        });
    }

    Result<void> readAll(const auto& next) {
        double share = 0;
        for (std::size_t failures = calls_.failures();; failures = calls_.failures()) {
            const auto [feature, layer] = next(share);
            if (!feature && stop_.stop_requested()) return cancelled();
            if (!feature && calls_.failures() > failures)
                return failure("It is incomplete or damaged (" + calls_.complaints().back() + ")",
                               stream_.file, "Download or export it again");
            if (!feature) return {};
            if (auto taken = take_(layer, *feature); !taken) return taken;
            if (++features_ % 256 != 0) continue;
            if (stop_.stop_requested()) return cancelled();
            progress_.report(stream_.share * share, "reading " + stream_.what);
        }
    }

    GDALDataset& dataset_;
    const std::vector<OGRLayer*>& layers_;
    const FeatureStream& stream_;
    const GdalCalls& calls_;
    const TakeFeature& take_;
    Progress& progress_;
    const std::stop_token& stop_;
    std::size_t features_ = 0;
};

}  // namespace

Result<std::size_t> readFeatures(GDALDataset& dataset, const std::vector<OGRLayer*>& layers,
                                 const FeatureStream& stream, const GdalCalls& calls, const TakeFeature& take,
                                 Progress& progress, const std::stop_token& stop) {
    return Reading(dataset, layers, stream, calls, take, progress, stop).run();
}

bool isFromOsm(GDALDataset& dataset) { return std::string_view(dataset.GetDriverName()) == "OSM"; }

Result<CrsToLonLat> findLayerCrs(OGRLayer& layer, const std::optional<std::string>& crs,
                                 const std::string& file) {
    if (crs) return CrsToLonLat::of(*crs);
    const OGRSpatialReference* system = layer.GetSpatialRef();
    const bool known = system != nullptr && system->GetName() != nullptr &&
                       !std::string_view(system->GetName()).starts_with("Undefined");
    // GeoPackage defines systems that mean "unknown".
    if (!known) return failure("It does not state its coordinate reference system", file, crsAdvice);
    char* text = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    system->exportToWkt(&text, options);
    const std::string wkt = text != nullptr ? text : "";
    CPLFree(text);
    auto transform = CrsToLonLat::of(wkt);
    if (transform) return transform;
    return failure(fmt::format("Its coordinate reference system, {}, is not known", system->GetName()), file,
                   crsAdvice);
}

std::string trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == text.npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

}  // namespace noonmark
