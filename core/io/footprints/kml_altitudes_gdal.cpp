#include <cpl_minixml.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/base/gdal_calls.h"
#include "core/io/footprints/kml_altitudes.h"

namespace noonmark {

namespace {

constexpr std::uintmax_t maxBytes = std::uintmax_t(256) << 20;  // some 2.5 GB of memory

struct TreeRelease {
    void operator()(CPLXMLNode* tree) const { CPLDestroyXMLNode(tree); }
};

// "-122.08,37.42,17 -122.09,...": its first corner.
std::optional<KmlAltitudes::Corner> firstCorner(std::string_view text) {
    double numbers[3] = {0, 0, 0};
    for (double& number : numbers) {
        const auto start = text.find_first_not_of(" \t\r\n,");
        if (start == text.npos) return std::nullopt;
        text.remove_prefix(start);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc()) return std::nullopt;
        text.remove_prefix(std::size_t(end - text.data()));
    }
    return KmlAltitudes::Corner{numbers[0], numbers[1], numbers[2]};
}

KmlStanding standingOf(const CPLXMLNode& polygon) {
    const std::string_view mode = CPLGetXMLValue(&polygon, "altitudeMode", "clampToGround");
    const std::string_view extrude = CPLGetXMLValue(&polygon, "extrude", "0");
    if (mode == "absolute") return KmlStanding::absolute;
    if (mode != "relativeToGround") return KmlStanding::onGround;
    return extrude == "1" || extrude == "true" ? KmlStanding::extruded : KmlStanding::floating;
}

void collectPolygons(const CPLXMLNode* node, std::map<KmlAltitudes::Corner, KmlStanding>& standing) {
    for (; node != nullptr; node = node->psNext) {
        if (node->eType != CXT_Element) continue;
        if (std::strcmp(node->pszValue, "Polygon") != 0) {
            collectPolygons(node->psChild, standing);
            continue;
        }
        const char* const outer = CPLGetXMLValue(node, "outerBoundaryIs.LinearRing.coordinates", "");
        if (const auto corner = firstCorner(outer)) standing.try_emplace(*corner, standingOf(*node));
    }
}

}  // namespace

KmlAltitudes KmlAltitudes::of(const std::filesystem::path& file) {
    const GdalCalls quiet;
    KmlAltitudes altitudes;
    std::error_code error;
    if (std::filesystem::file_size(file, error) > maxBytes || error) return altitudes;
    const std::unique_ptr<CPLXMLNode, TreeRelease> tree(CPLParseXMLFile(file.c_str()));
    if (!tree) return altitudes;
    CPLStripXMLNamespace(tree.get(), nullptr, TRUE);
    collectPolygons(tree.get(), altitudes.standing_);
    return altitudes;
}

std::optional<KmlStanding> KmlAltitudes::find(const Corner& firstCorner) const {
    const auto found = standing_.find(firstCorner);
    return found == standing_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace noonmark
