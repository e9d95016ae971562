#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/report/movie/movie_writer.h"
#include "core/base/progress.h"
#include "core/city/city.h"
#include "core/io/files/check_output.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/study/shadow_drawings.h"

namespace noonmark {

/// What a movie shows: the shadows of a baseline and a scenario in plan, moment after moment.
struct ShadowMovie {
    std::shared_ptr<const City> baseline;  ///< not null
    std::shared_ptr<const City> scenario;  ///< null: the baseline alone
    std::vector<Place> places;
    DrawnTimeChoice when;     ///< one frame for each time with the sun up; of a swipe the first only
    DrawingSettings drawing;  ///< area and cell size
    std::string title;
    std::string credit;  ///< of the data
    /// At the first time, a line crosses the picture and uncovers the scenario.
    bool swipe = false;
    MovieFormat format;
    OutputRules outputs;  ///< which files may be replaced
};

struct MovieFacts {
    std::size_t frames = 0;
    double seconds = 0;
    Box2 area;          ///< that the frames show: the wanted one, widened to their proportions
    Warnings warnings;  ///< of listDrawnTimes(), and of trees, which are not drawn
};

/// Computes the shadows and writes the movie; the file appears when it is complete. Each frame states its
/// time, sun, legend, scale bar and north. Errors of checkOutput(), listDrawnTimes(), drawShadows(),
/// outlineShadows() and MovieWriter; a swipe without a scenario; cancelled(). A frame of a square kilometre
/// of a dense city takes some 0.3 s.
Result<MovieFacts> writeShadowMovie(const ShadowMovie& movie, const std::filesystem::path& file,
                                    Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
