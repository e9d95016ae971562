#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "core/io/cityjson/cityjson_buildings.h"
#include "core/io/cityjson/cityjson_load.h"
#include "core/io/cityjson/cityjson_place.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

// Where the data state no measure, that of the geometry counts.
void addTree(const CityJsonTree& tree, const std::vector<glm::dvec3>& vertices, const Frame& frame,
             FilePiece& piece) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const std::size_t vertex : tree.vertices) {
        low = glm::min(low, vertices[vertex]);
        high = glm::max(high, vertices[vertex]);
    }
    const glm::dvec3 size = high - low;
    if (!std::isfinite(size.x + size.y)) return;
    ReadTree read{frame.lonLatFromLocal(glm::dvec2(low + high) / 2.0), tree.facts};
    if (!read.facts.heightM && isPlausibleTreeHeight(size.z)) read.facts.heightM = size.z;
    const double wide = std::max(size.x, size.y);
    if (!read.facts.crownDiameterM && isPlausibleCrown(wide)) read.facts.crownDiameterM = wide;
    piece.trees.push_back(std::move(read));
}

Result<FilePiece> read(const std::filesystem::path& file, const ReadSettings& settings, Progress& progress,
                       const std::stop_token& stop) {
    Result<CityJsonData> data = loadCityJson(file, settings, progress, stop);
    if (!data) return tl::make_unexpected(data.error());
    const std::string name = file.filename().string();
    const Result<Frame> frame = placeCity(*data, settings, name, stop);
    if (!frame) return tl::make_unexpected(frame.error());
    FilePiece piece{
        .warnings = std::move(data->warnings), .features = data->features, .attribution = data->attribution};
    piece.format = fmt::format("{} {}", data->sequence ? "CityJSONSeq" : "CityJSON", data->version);
    piece.crs = data->crsWords;
    if (!settings.frame) piece.frame = *frame;
    addTin(*data, name, piece);
    for (const CityJsonBlock& block : data->blocks)
        for (const CityJsonTree& tree : block.trees) addTree(tree, block.vertices, *frame, piece);
    if (!addBuildings(*data, settings, name, piece, progress, stop)) return cancelled();
    if (piece.buildings.empty() && !piece.terrain)
        return failure("The file holds no usable building and no usable terrain", file.string(),
                       "Check it with a CityJSON validator");
    return piece;
}

}  // namespace

Result<FilePiece> readCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                               Progress& progress, std::stop_token stop) try {
    return read(file, settings, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The city cannot be read ({})", exception.what()), file.string(),
                   "Check it with a CityJSON validator");
}

}  // namespace noonmark
