#pragma once

#include <string>

#include "core/study/elements/element_map.h"

namespace noonmark {

/// The points as a binary glTF 2.0 file: the rectangle of each, 3 cm in front of its wall, in the colours of
/// gross shadow (measures/palette.h, up to the sunlit minutes of a day or the largest value), without light.
/// In metres from the project's origin: x east, y up, z south. Attributes of the corners: `_SUNLIT_MIN`,
/// `_GROSS_MIN`, `_CONTINUOUS_MIN`, as in elements.csv; `extras` of the mesh lists the ids in the order of
/// the rectangles, four corners each. Some 150 bytes a point.
std::string toGlb(const ElementMap& map);

}  // namespace noonmark
