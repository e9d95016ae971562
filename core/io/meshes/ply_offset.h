#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>

namespace noonmark {

/// What the points of a PLY are counted from, as programs write it into a comment of the header, for which
/// the format has no field: "comment offset 390000 5819000 30". Nothing where no comment states three such
/// numbers, or they are less than 1,000.
std::optional<glm::dvec3> readPlyOffset(const std::filesystem::path& file);

}  // namespace noonmark
