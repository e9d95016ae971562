#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace noonmark {

/// A surface that a city model marks as window or door, in the coordinates of its file: easting or longitude
/// first.
struct FileOpening {
    std::string id;
    std::vector<glm::dvec3> corners;  ///< of its outer ring
};

}  // namespace noonmark
