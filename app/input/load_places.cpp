#include "app/input/load_places.h"

#include <algorithm>
#include <iterator>

#include "app/input/load_city.h"
#include "core/receivers/place_names.h"
#include "core/samples/sample_city.h"

namespace noonmark {

Result<PlacesRead> loadPlaceFiles(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, PlacesRead before, Progress& progress,
                                  const std::stop_token& stop) {
    for (const std::string& file : files) {
        auto read = readPlaces(file, settings, frame, progress, stop);
        if (!read) return tl::make_unexpected(read.error());
        std::ranges::move(read->places, std::back_inserter(before.places));
        std::ranges::move(read->warnings, std::back_inserter(before.warnings));
        before.features += read->features;
        before.streetsOfAssumedWidth += read->streetsOfAssumedWidth;
        if (before.attribution.empty()) before.attribution = read->attribution;
    }
    nameApart(before.places);
    return before;
}

namespace {

std::vector<Place> placesOfSample(const PlaceSettings& settings, const Frame& frame) {
    std::vector<Place> places = listCentralParkPlaces(frame);
    std::erase_if(places, [&](const Place& place) {
        const bool isOtherKind = !settings.kinds.empty() && !settings.kinds.contains(place.kind);
        return isOtherKind || (place.kind == PlaceKind::street && !settings.streets);
    });
    return places;
}

}  // namespace

Result<PlacesRead> loadCityPlaces(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, Progress& progress, const std::stop_token& stop) {
    std::vector<std::string> maps;
    PlacesRead ofSample;
    for (const std::string& file : files) {
        if (isParkSample(file)) ofSample.places = placesOfSample(settings, frame);
        if (!isSample(file) && isOsmFile(file)) maps.push_back(file);
    }
    return loadPlaceFiles(maps, settings, frame, std::move(ofSample), progress, stop);
}

}  // namespace noonmark
