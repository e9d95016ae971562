#pragma once

#include <string>
#include <vector>

#include "core/io/read_city.h"

namespace noonmark {

/// What to do next with a city, as a command line that can be pasted into a POSIX shell.
struct NextStep {
    std::string why;      ///< "the ground is flat, since there is no terrain"
    std::string command;  ///< "noonmark-cli info town.gml TERRAIN.tif"
};

/// The most useful steps after a city was read, at most three: the field of heights that is not known, a
/// terrain, a first study of a box of 500 m, the window. `files`, `settings`: what it was read with. The
/// region is that of a city that is not empty.
std::vector<NextStep> listNextSteps(const CityRead& read, const std::vector<std::string>& files,
                                    const ReadSettings& settings);

}  // namespace noonmark
