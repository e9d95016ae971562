#include "app/cli/options/lon_lat_option.h"

#include <cmath>
#include <sstream>

namespace noonmark::cli {

namespace {

LonLat placeFrom(const std::string& option, const std::string& text) {
    LonLat place{};
    char comma = 0;
    std::istringstream stream(text);
    const bool read =
        bool(stream >> place.lonDeg >> comma >> place.latDeg) && comma == ',' && (stream >> std::ws).eof();
    if (!read || !(std::abs(place.lonDeg) <= 180) || !(std::abs(place.latDeg) <= 90))
        throw CLI::ValidationError(option, "give LON,LAT in degrees, for example -73.98,40.75");
    return place;
}

}  // namespace

CLI::Option* addLonLatOption(CLI::App& command, const std::string& name, std::optional<LonLat>& place,
                             const std::string& about) {
    return command
        .add_option_function<std::string>(
            name, [name, &place](const std::string& text) { place = placeFrom(name, text); }, about)
        ->type_name("LON,LAT");
}

}  // namespace noonmark::cli
