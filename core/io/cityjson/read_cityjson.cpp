#include <fmt/format.h>

#include "core/io/cityjson/cityjson_buildings.h"
#include "core/io/cityjson/cityjson_load.h"
#include "core/io/cityjson/cityjson_place.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

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
