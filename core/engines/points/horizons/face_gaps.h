#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/engines/points/horizons/bin_directions.h"
#include "core/engines/points/horizons/obstacle_blocks.h"

namespace noonmark {

/// Altitudes that an overhang hides at the middle of one bin, as tangents.
struct BinGap {
    int bin;
    float lowTan, highTan;  ///< 0 <= low; high may be infinite: up to the zenith
};

/// Appends what the faces of overhangs hide above a point's horizon (`eye`, local metres), in no order. Faces
/// that share an edge leave nothing between them: where the edge is cut, both get the same number.
void findFaceGaps(const FaceTree& faces, const BinDirections& bins, glm::vec3 eye, const BinTangents& horizon,
                  std::vector<BinGap>& gaps);

}  // namespace noonmark
