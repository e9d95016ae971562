#include "core/io/footprints/map_remarks.h"

namespace noonmark {

std::string makeMapRemark(std::string_view words) {
    const auto says = [&](std::string_view piece) { return words.find(piece) != words.npos; };
    if (says("Non closed ring"))
        return "outlines were not closed, as happens at the edge of an extract; the last point of each was "
               "connected to its first";
    if (says("processing may be really slow")) return {};
    if (says("organizePolygons()") || says("translated to Simple Geometry"))
        return "outer rings and holes of an outline could not be distinguished; each ring was taken as a "
               "polygon";
    return "message of the map library: " + std::string(words);
}

}  // namespace noonmark
