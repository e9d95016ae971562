#include "core/study/tiles/timeline_measure.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

glm::dvec2 middleOf(const Box2& box) { return (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0; }

std::string kindsOf(const PlaceSettings& reading) {
    std::string text;
    for (const PlaceKind kind : reading.kinds) text += fmt::format("{},", nameOf(kind));
    return text;
}

}  // namespace

std::string PlacesRequest::key() const {
    return fmt::format("{};{};{};{};{};{};{};{};{};{};{}", placesHash, kindsOf(reading), reading.streets,
                       reading.sidewalkM, reading.unnamed, reading.minAreaM2, reading.farAwayM,
                       reading.nameField, nameOf(reading.kind), reading.layer, reading.crs.value_or("")) +
           (reading.wholeStreets ? "" : ";cut streets");
}

Result<std::vector<Place>> readPlaces(const PlacesRequest& request, const Frame& frame, Progress& progress,
                                      const std::stop_token& stop) {
    if (!request.own.empty()) return request.own;
    return readPlaces(request.places, request.reading, frame, progress, stop).map([](PlacesRead read) {
        return std::move(read.places);
    });
}

PlacesOfTiles::PlacesOfTiles(std::vector<Place> places, const TilePlan& plan)
    : plan_(plan), byTile_(plan.count()) {
    for (Place& place : places)
        if (const auto tile = plan.tileAt(middleOf(bounds(place))))
            byTile_[*tile].push_back(std::move(place));
}

const std::vector<Place>& PlacesOfTiles::in(const Grid& tile) const {
    return of(plan_.tileAt({(tile.westM + tile.eastM()) / 2, (tile.southM + tile.northM()) / 2}).value());
}

Box2 PlacesOfTiles::boxOf(std::size_t tile) const {
    Box2 box;
    for (const Place& place : of(tile)) box.add(bounds(place));
    return box;
}

namespace {

// About it, or about no place of its own.
Warnings warningsAbout(const Place& place, const PlaceStudy& study, const Warnings& all) {
    const auto isAbout = [](const Warning& warning, const PlaceTimeline& one) {
        return warning.where == one.place.name;
    };
    Warnings about;
    std::ranges::copy_if(all, std::back_inserter(about), [&](const Warning& warning) {
        return warning.where == place.name ||
               std::ranges::none_of(study.places, [&](const auto& one) { return isAbout(warning, one); });
    });
    return about;
}

/// A line for each place of a study, with the warnings about it.
std::string linesOf(PlaceStudy study, const TimelineLabels& labels) {
    const Warnings all = std::move(study.warnings);
    std::string lines;
    for (const PlaceTimeline& place : study.places) {
        study.warnings = warningsAbout(place.place, study, all);
        lines += timelineJson(study, place, labels).dump() + '\n';
    }
    return lines;
}

std::size_t countCells(const PlaceStudy& study) {
    double areaM2 = 0;
    for (const PlaceTimeline& place : study.places)
        if (!place.days.empty()) areaM2 += place.days.front().areaM2;
    return std::size_t(std::llround(areaM2 / (study.cellM * study.cellM)));
}

}  // namespace

std::string TimelineRequest::key() const {
    return fmt::format("timelines;{};{};{};{}", PlacesRequest::key(), allSteps, labels.from, labels.to);
}

TimelineMeasure::TimelineMeasure(const City& baseline, const City* scenario, const PlacesOfTiles& places,
                                 const TimelineRequest& request, const TileQuestion& question)
    : baseline_(baseline), scenario_(scenario), places_(places), request_(request), question_(question) {}

Result<TileAnswer> TimelineMeasure::measure(const Grid& tile, Progress& progress,
                                            const std::stop_token& stop) {
    const std::vector<Place>& places = places_.in(tile);
    if (places.empty()) return TileAnswer{};
    const StudySettings& settings = question_.settings;
    const PlaceStudySettings asked{.period = settings.period,
                                   .cellM = settings.receivers.cellM,
                                   .allSteps = request_.allSteps || settings.period.days == 1,
                                   .trees = settings.trees};
    return runPlaceStudy(baseline_, scenario_, places, asked, question_.engine, progress, stop)
        .map([&](PlaceStudy study) {
            TileAnswer answer;
            answer.result.lines = study.places.size();
            answer.result.sums.receivers = countCells(study);
            answer.result.engineKey = settings.engine;
            answer.result.engine = study.engine;
            for (const ShadedPlace& with : study.places.front().withTrees)
                answer.result.withTrees.push_back({with.column, answer.result.sums});
            answer.lines = linesOf(std::move(study), request_.labels);
            return answer;
        });
}

}  // namespace noonmark
