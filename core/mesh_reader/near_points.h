#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>

namespace noonmark {

/// A mesh file with its points moved next to zero.
struct NearPoints {
    std::string content;   ///< the whole file; empty: it needs no move, or its points cannot be found
    glm::dvec3 origin{0};  ///< what was subtracted from every point
};

/// The mesh library stores points as float32, which at map coordinates is half a metre. Text formats and PLY
/// with double numbers hold more: the middle of their first points is subtracted before the library reads
/// them. OBJ, STL as text, PLY; nothing for other formats, and where that middle is within 10,000 units of
/// zero. Takes twice the memory of the file.
NearPoints movePointsNear(const std::filesystem::path& file);

}  // namespace noonmark
