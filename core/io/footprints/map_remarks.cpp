#include "core/io/footprints/map_remarks.h"

#include <fmt/format.h>

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

void addMapRemarks(const std::vector<std::string>& words, const std::string& file, Warnings& warnings) {
    Warnings remarks;
    for (const std::string& one : words)
        if (std::string what = makeMapRemark(one); !what.empty())
            remarks.push_back({WarningKind::repaired, std::move(what), file});
    for (const WarningGroup& group : groupWarnings(remarks))
        warnings.push_back({group.kind, group.what, fmt::format("{} ({})", file, group.where.size())});
}

}  // namespace noonmark
