#include "core/study/tile_tasks/merge/merge_tiles.h"

#include <cpl_string.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/write_text.h"

namespace noonmark {

namespace {

// The writer of Cloud Optimized GeoTIFFs reads nothing: no file reaches it.
GDALDriver* cloudDriver() {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("COG");
    if (driver != nullptr) return driver;
    GDALRegister_COG();
    return GetGDALDriverManager()->GetDriverByName("COG");
}

CPLStringList cloudOptions() {
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "FLOATING_POINT");
    options.SetNameValue("BLOCKSIZE", "512");
    options.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
    options.SetNameValue("BIGTIFF", "IF_SAFER");
    options.SetNameValue("NUM_THREADS", "ALL_CPUS");
    return options;
}

}  // namespace

Result<void> writeCloudMap(const std::filesystem::path& from, const std::filesystem::path& to,
                           const std::stop_token& stop) {
    const GdalCalls calls;
    const auto source = openDataset(from, DatasetContent::maps);
    if (!source) return tl::make_unexpected(source.error());
    PendingFile pending(to);
    GDALDriver* driver = cloudDriver();
    std::stop_token token = stop;
    GDALDatasetUniquePtr made(driver == nullptr
                                  ? nullptr
                                  : driver->CreateCopy(pending.path().c_str(), source->get(), FALSE,
                                                       cloudOptions().List(), continueUnlessStopped, &token));
    const bool whole = made != nullptr;
    made.reset();  // flushes: a full disk is reported here
    if (stop.stop_requested()) return cancelled();
    if (!whole || calls.failed())
        return limitReached("The map could not be written: " + calls.why(), to.string(),
                            "Check that the folder is writable and has space for the map twice");
    return pending.commit();
}

}  // namespace noonmark
