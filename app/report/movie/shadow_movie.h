#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/report/movie/movie_writer.h"
#include "core/base/progress.h"
#include "core/city/city.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/study/shadow_drawings.h"

namespace noonmark {

/// What a movie shows: the shadows of a baseline and a scenario in plan, moment after moment.
struct ShadowMovie {
    const City& baseline;
    const City* scenario = nullptr;  ///< null: the baseline alone
    const std::vector<Place>& places;
    std::vector<DrawnTime> times;  ///< one frame each, in this order; of a swipe the first only
    DrawingSettings drawing;       ///< area and cell size
    std::string title;
    std::string credit;  ///< of the data
    /// At the first time, a line crosses the picture and uncovers the scenario.
    bool swipe = false;
    MovieFormat format;
};

struct MovieFacts {
    std::size_t frames = 0;
    double seconds = 0;
    Box2 area;  ///< that the frames show: the wanted one, widened to their proportions
};

/// Computes the shadows and writes the movie; the file appears when it is complete. Each frame states its
/// time, sun, legend, scale bar and north. Errors of drawShadows(), outlineShadows() and MovieWriter; a swipe
/// without a scenario; cancelled(). A frame of a square kilometre of a dense city takes some 0.3 s.
Result<MovieFacts> writeShadowMovie(const ShadowMovie& movie, const std::filesystem::path& file,
                                    Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
