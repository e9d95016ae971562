#pragma once

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <string>

#include "core/io/pieces/read_part.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::tests {

inline const glm::dvec3 bonn{366000, 5622000, 60};  ///< EPSG:25832, metres

/// A polygon of GML 3 with these corners, closed.
inline std::string gmlPolygon(const std::vector<glm::dvec3>& corners, const std::string& id = {}) {
    std::string numbers;
    for (std::size_t i = 0; i <= corners.size(); ++i) {
        const glm::dvec3 at = corners[i % corners.size()];
        numbers += fmt::format("{:.9g} {:.9g} {:.9g} ", at.x, at.y, at.z);
    }
    const std::string named = id.empty() ? "" : fmt::format(" gml:id=\"{}\"", id);
    return fmt::format(
        "<gml:Polygon{}><gml:exterior><gml:LinearRing><gml:posList>{}</gml:posList></gml:LinearRing>"
        "</gml:exterior></gml:Polygon>",
        named, numbers);
}

/// The six faces of a box, facing outward; `id`: of the first, "ID0", and so on.
inline std::vector<std::string> gmlBoxFaces(glm::dvec3 low, glm::dvec3 high, const std::string& id = {}) {
    const auto corner = [&](int i) {
        return glm::dvec3((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z);
    };
    std::vector<std::string> faces;
    for (const auto& corners :
         {std::vector{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        std::vector<glm::dvec3> points;
        for (const int i : corners) points.push_back(corner(i));
        faces.push_back(gmlPolygon(points, id.empty() ? id : fmt::format("{}{}", id, faces.size())));
    }
    return faces;
}

inline std::string gmlMembers(const std::vector<std::string>& surfaces) {
    std::string text;
    for (const std::string& surface : surfaces)
        text += surface.starts_with('#') ? fmt::format("<gml:surfaceMember xlink:href=\"{}\"/>", surface)
                                         : "<gml:surfaceMember>" + surface + "</gml:surfaceMember>";
    return text;
}

inline std::string gmlSolid(const std::vector<std::string>& surfaces) {
    return "<gml:Solid><gml:exterior><gml:CompositeSurface>" + gmlMembers(surfaces) +
           "</gml:CompositeSurface></gml:exterior></gml:Solid>";
}

inline std::string gmlMultiSurface(const std::vector<std::string>& surfaces) {
    return "<gml:MultiSurface>" + gmlMembers(surfaces) + "</gml:MultiSurface>";
}

/// "bldg:lod2Solid" around a box above `bonn`, metres.
inline std::string gmlBoxSolid(glm::dvec3 low, glm::dvec3 high, int lod = 2) {
    return fmt::format("<bldg:lod{0}Solid>{1}</bldg:lod{0}Solid>", lod,
                       gmlSolid(gmlBoxFaces(bonn + low, bonn + high)));
}

inline std::string gmlBuilding(const std::string& id, const std::string& content) {
    return fmt::format(
        "<core:cityObjectMember><bldg:Building gml:id=\"{}\">{}</bldg:Building></core:cityObjectMember>", id,
        content);
}

inline std::string cityGml(const std::string& members, const std::string& version = "2.0",
                           const std::string& reference = "urn:ogc:def:crs:EPSG::25832",
                           const std::string& envelope = {}) {
    const std::string gml =
        version == "3.0" ? "http://www.opengis.net/gml/3.2" : "http://www.opengis.net/gml";
    const std::string bounds =
        reference.empty()
            ? ""
            : fmt::format("<gml:boundedBy><gml:Envelope srsName=\"{}\">{}</gml:Envelope></gml:boundedBy>",
                          reference, envelope);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<core:CityModel xmlns:core=\"http://www.opengis.net/citygml/{0}\" "
        "xmlns:bldg=\"http://www.opengis.net/citygml/building/{0}\" xmlns:gml=\"{1}\" "
        "xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n{2}\n{3}\n</core:CityModel>\n",
        version, gml, bounds, members);
}

/// The reader's result for a file with this text.
inline Result<FilePiece> readGmlText(const std::string& text, const ReadSettings& settings = {}) {
    const TemporaryFolder folder;
    NoProgress progress;
    return readCityGml(folder.file("city.gml", text), settings, progress, {});
}

}  // namespace noonmark::tests
