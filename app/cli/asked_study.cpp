#include "app/cli/asked_study.h"

#include "app/input/all_engines.h"
#include "app/report/output_folder.h"
#include "core/io/read_region.h"

namespace noonmark::cli {

namespace {

// "city" is the box around all buildings.
Result<Region> regionFrom(const std::string& text, const City& city) {
    if (text != "city") return readRegion(text, city.frame);
    Region region = regionFromLocalBox(bounds(city));
    region.name = "the whole city";
    return region;
}

}  // namespace

tl::expected<AskedStudy, Failure> askedStudy(const StudyOptions& options, Progress& progress,
                                             const std::stop_token& stop) {
    StudySettings settings = options.settings;
    const auto period = orCode(periodFrom(options.period), exitUsage);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    if (auto engine =
            orCode(makeAccumulator(settings.engine, settings.engineSettings, enginesWith(settings.engine)),
                   exitUsage);
        !engine)
        return tl::make_unexpected(engine.error());
    auto loaded = orCode(loadCity(options.read.files, options.read.settings, progress, stop), exitUsage);
    if (!loaded) return tl::make_unexpected(loaded.error());
    auto region = orCode(regionFrom(options.region, loaded->read.city), exitUsage);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    if (auto folder = orCode(prepareFolder(options.out), exitFailed); !folder)
        return tl::make_unexpected(folder.error());
    return AskedStudy{*std::move(loaded), std::move(settings)};
}

}  // namespace noonmark::cli
