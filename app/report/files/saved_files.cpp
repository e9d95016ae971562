#include "app/report/files/saved_files.h"

#include "app/report/files/output_folder.h"
#include "core/io/write_raster.h"

namespace noonmark {

std::vector<std::string> savedFileNames() { return {"result.tif", "result.json"}; }

Result<std::vector<std::filesystem::path>> writeSavedFiles(const SavedResult& result, const Frame& frame,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules) {
    if (auto may = checkOutputs(folder, savedFileNames(), rules); !may)
        return tl::make_unexpected(may.error());
    std::vector<RasterBand> bands;
    for (const SavedLayer& layer : result.layers) bands.push_back({layer.name, layer.unit, &layer.values});
    OutputFolder files(folder, rules);
    files.add("result.tif", [&](const std::filesystem::path& file) {
        return writeGeoTiff(file, frame, result.grid, bands,
                            {{"RESULT", result.name}, {"SCENARIO", result.scenario}});
    });
    files.add("result.json", textContent(result.settings));
    return std::move(files).result();
}

}  // namespace noonmark
