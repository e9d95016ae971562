#include "core/study/tiles/by_place_measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/describe/field_checks.h"
#include "core/study/tiles/by_place_lines.h"

namespace noonmark {

namespace {

std::size_t countCells(const SunByPlace& sun) {
    std::size_t cells = 0;
    for (const SunOfPlace& of : sun.sun) cells += of.cells;
    return cells;
}

}  // namespace

std::string ByPlaceRequest::key() const {
    return fmt::format("sun by place;{};{};{}", PlacesRequest::key(), fmt::join(cities, ";"),
                       questionText(sunByPlaceFields().of(settings), true));
}

ByPlaceMeasure::ByPlaceMeasure(std::vector<const City*> cities, const PlacesOfTiles& places,
                               const ByPlaceRequest& request, const TileQuestion& question,
                               const EngineList& engines)
    : cities_(std::move(cities)),
      places_(places),
      request_(request),
      question_(question),
      engines_(engines) {}

Result<TileAnswer> ByPlaceMeasure::measure(const Grid& tile, Progress& progress,
                                           const std::stop_token& stop) {
    const std::vector<Place>& places = places_.in(tile);
    if (places.empty()) return TileAnswer{};
    SunByPlaceSettings settings = request_.settings;
    settings.study = question_.settings;
    std::vector<NamedCity> cities;
    for (std::size_t i = 0; i < cities_.size(); ++i) cities.push_back({request_.cities.at(i), *cities_[i]});
    const Observer observer = makeObserver(*cities_.front(), question_.settings);
    return measurePlacesOfTile(cities, places, settings, observer, progress, stop, engines_)
        .map([&](const SunOfCities& sun) {
            TileAnswer answer;
            answer.result.lines = places.size() + 1;
            answer.result.sums.receivers = countCells(sun.baseline);
            answer.result.engineKey = question_.settings.engine;
            answer.result.engine = sun.baseline.field.engine;
            answer.lines = formatLines(sun);
            return answer;
        });
}

}  // namespace noonmark
