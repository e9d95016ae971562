#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"

namespace noonmark::tests {

using Tags = std::vector<std::pair<std::string, std::string>>;

/// An axis-aligned rectangle, metres.
inline Ring sizedRectangle(float west, float south, float width, float height) {
    return {{west, south}, {west + width, south}, {west + width, south + height}, {west, south + height}};
}

/// Writes OpenStreetMap XML from shapes in metres around a place in Manhattan. Ways are numbered from 1,
/// relations too.
class OsmText {
public:
    /// Returns the id that readers give the feature.
    std::string way(const Ring& ring, const Tags& tags) {
        std::string members;
        for (const glm::vec2 point : ring)
            members += fmt::format("<nd ref=\"{}\"/>", node(glm::dvec2(point)));
        members += fmt::format("<nd ref=\"{}\"/>", nodes_ - int(ring.size()) + 1);
        wayTexts_ += fmt::format("<way id=\"{}\" version=\"1\">{}{}</way>\n", ++ways_, members, text(tags));
        return fmt::format("way {}", ways_);
    }

    /// A multipolygon of one outer and some inner ways.
    std::string relation(const Ring& outer, const std::vector<Ring>& inner, const Tags& tags) {
        way(outer, {});
        std::string members = fmt::format("<member type=\"way\" ref=\"{}\" role=\"outer\"/>", ways_);
        for (const Ring& ring : inner) {
            way(ring, {});
            members += fmt::format("<member type=\"way\" ref=\"{}\" role=\"inner\"/>", ways_);
        }
        members += "<tag k=\"type\" v=\"multipolygon\"/>";
        relationTexts_ += fmt::format("<relation id=\"{}\" version=\"1\">{}{}</relation>\n", ++relations_,
                                      members, text(tags));
        return fmt::format("relation {}", relations_);
    }

    [[nodiscard]] std::string xml() const {
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<osm version=\"0.6\" generator=\"test\">\n" +
               nodeTexts_ + wayTexts_ + relationTexts_ + "</osm>\n";
    }

private:
    int node(glm::dvec2 point) {
        const LonLat place = Frame({-73.98, 40.75}).lonLatFromLocal(point);
        nodeTexts_ += fmt::format("<node id=\"{}\" version=\"1\" lat=\"{:.9f}\" lon=\"{:.9f}\"/>\n", ++nodes_,
                                  place.latDeg, place.lonDeg);
        return nodes_;
    }
    static std::string text(const Tags& tags) {
        std::string all;
        for (const auto& [key, value] : tags) all += fmt::format("<tag k=\"{}\" v=\"{}\"/>", key, value);
        return all;
    }

    int nodes_ = 0, ways_ = 0, relations_ = 0;
    std::string nodeTexts_, wayTexts_, relationTexts_;
};

}  // namespace noonmark::tests
