#include <fmt/format.h>

#include "core/io/citygml/citygml_load.h"
#include "core/io/citygml/citygml_reference.h"
#include "core/io/cityjson/cityjson_buildings.h"
#include "core/io/cityjson/cityjson_place.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

constexpr const char* validatorAdvice = "Check it with a CityGML validator";

Result<FilePiece> readGml(const std::filesystem::path& file, const ReadSettings& settings, Progress& progress,
                          const std::stop_token& stop) {
    Result<CityGmlData> data = loadCityGml(file, settings, progress, stop);
    if (!data) return tl::make_unexpected(data.error());
    CityJsonData& city = data->city;
    if (city.blocks.empty())
        return failure("The file holds no buildings and no terrain", file.string(),
                       "Choose a file that contains some");
    if (auto settled = settleReference(*data, settings, file); !settled)
        return tl::make_unexpected(settled.error());
    const std::string name = file.filename().string();
    const Result<Frame> frame = placeCity(city, settings, name, stop);
    if (!frame) return tl::make_unexpected(frame.error());
    FilePiece piece{.warnings = std::move(city.warnings), .features = city.features};
    piece.format = city.version.empty() ? "CityGML" : "CityGML " + city.version;
    piece.crs = city.crsWords;
    if (!settings.frame) piece.frame = *frame;
    addTin(city, name, piece);
    if (!addBuildings(city, settings, name, piece, progress, stop)) return cancelled();
    if (piece.buildings.empty() && !piece.terrain)
        return failure("The file holds no usable building and no usable terrain", file.string(),
                       validatorAdvice);
    return piece;
}

}  // namespace

Result<FilePiece> readCityGml(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress, std::stop_token stop) try {
    return readGml(file, settings, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The city cannot be read ({})", exception.what()), file.string(),
                   validatorAdvice);
}

}  // namespace noonmark
