#include "core/io/footprints/map_remarks.h"

namespace noonmark {

std::string makeMapRemark(std::string_view words) {
    const auto says = [&](std::string_view piece) { return words.find(piece) != words.npos; };
    if (says("Non closed ring"))
        return "outlines did not close, as those cut off at the edge of an extract; the last point of each "
               "was "
               "joined to its first";
    if (says("processing may be really slow")) return {};
    if (says("organizePolygons()") || says("translated to Simple Geometry"))
        return "outer rings and holes of an outline could not be told apart; each ring was taken as a "
               "polygon";
    return "the map library says: " + std::string(words);
}

}  // namespace noonmark
