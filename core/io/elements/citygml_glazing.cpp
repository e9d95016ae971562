#include "core/io/elements/model_glazing.h"

#include "core/io/citygml/citygml_load.h"
#include "core/io/citygml/citygml_reference.h"
#include "core/io/elements/place_openings.h"

namespace noonmark {

Result<GlazingRead> readCityGmlGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                       const City& city, Progress& progress, const std::stop_token& stop) {
    ReadSettings reading;
    reading.crs = settings.crs;
    auto data = loadCityGml(file, reading, progress, stop, GmlContent::openings);
    if (!data) return tl::make_unexpected(data.error());
    if (auto settled = settleReference(*data, reading, file); !settled)
        return tl::make_unexpected(settled.error());
    GlazingRead read{.features = data->city.features};
    if (auto placed =
            placeOpenings(data->openings, data->city.crs, file.filename().string(), settings, city, read);
        !placed)
        return tl::make_unexpected(placed.error());
    return read;
}

}  // namespace noonmark
