#pragma once

#include <memory>

#include "app/report/movie/shadow_movie.h"
#include "core/io/files/check_output.h"
#include "core/sun/civil_time.h"

namespace noonmark {

/// What a movie from the window shows.
struct MovieChoice {
    enum class Kind {
        day,    ///< one day, as long as the sun is up
        year,   ///< every day of a year, at one time
        swipe,  ///< at one moment, a line uncovers the scenario
    };
    enum class Area {
        automatic,  ///< see DrawingSettings::area
        region,     ///< of the study
        view,       ///< the ground that the view shows
    };
    Kind kind = Kind::day;
    Area area = Area::automatic;
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    std::chrono::minutes at{12 * 60};  ///< of a year and a swipe
    int everyMin = 10;                 ///< of a day, 1 to 720
    MovieFormat format;
    std::string title;
};

/// The cities of a movie and what belongs to them: a copy, for a job.
struct MovieSource {
    std::shared_ptr<const City> baseline;  ///< not null
    std::shared_ptr<const City> scenario;  ///< null: the baseline alone
    std::vector<Place> places;
    std::optional<Box2> area;  ///< none: automatic
    std::string zone;
    std::string attribution;
    OutputRules outputs;
};

/// Writes the movie that `noonmark-cli project animate` writes with the same choices. Errors of
/// checkOutput(), listDrawnTimes() and writeShadowMovie().
Result<MovieFacts> exportMovie(const MovieSource& source, const MovieChoice& choice,
                               const std::filesystem::path& file, Progress& progress,
                               const std::stop_token& stop);

}  // namespace noonmark
