#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/pieces/read_part.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::tests {

using Json = nlohmann::json;

inline const glm::dvec3 amsterdam{121000, 487000, 2};  ///< EPSG:7415, metres

/// Builds CityJSON with coordinates in whole millimetres relative to `amsterdam`.
class CityJsonMaker {
public:
    Json vertices = Json::array();
    Json objects = Json::object();

    /// Adds the vertices of a box; returns the first index. Corner i is at high x, y, z if bit 0, 1, 2 of i
    /// is set.
    int addBox(glm::dvec3 low, glm::dvec3 high) {
        const int first = int(vertices.size());
        for (int i = 0; i < 8; ++i)
            addVertex({(i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z});
        return first;
    }
    int addVertex(glm::dvec3 at) {
        vertices.push_back({std::llround(at.x * 1000), std::llround(at.y * 1000), std::llround(at.z * 1000)});
        return int(vertices.size()) - 1;
    }
    /// The six faces of such a box, facing outward.
    static Json boxShell(int first, bool inward = false) {
        Json shell = Json::array();
        for (const auto& corners : {std::vector{0, 2, 3, 1},
                                    {4, 5, 7, 6},
                                    {0, 1, 5, 4},
                                    {2, 6, 7, 3},
                                    {0, 4, 6, 2},
                                    {1, 3, 7, 5}}) {
            Json ring = Json::array();
            for (const int corner : corners) ring.push_back(first + corner);
            if (inward) ring = Json(Json::array_t(ring.rbegin(), ring.rend()));
            shell.push_back(Json::array({ring}));
        }
        return shell;
    }
    Json boxSolid(glm::dvec3 low, glm::dvec3 high, const std::string& lod = "2.2") {
        return solid(Json::array({boxShell(addBox(low, high))}), lod);
    }
    static Json solid(const Json& boundaries, const std::string& lod = "2.2") {
        return {{"type", "Solid"}, {"lod", lod}, {"boundaries", boundaries}};
    }
    void addBuilding(const std::string& id, const Json& geometry, const std::string& type = "Building") {
        objects[id] = {{"type", type}, {"geometry", Json::array({geometry})}};
    }

    [[nodiscard]] Json document(
        const std::string& version = "2.0",
        const std::string& crs = "https://www.opengis.net/def/crs/EPSG/0/7415") const {
        Json root{
            {"type", "CityJSON"}, {"version", version}, {"CityObjects", objects}, {"vertices", vertices}};
        root["transform"] = {{"scale", {0.001, 0.001, 0.001}},
                             {"translate", {amsterdam.x, amsterdam.y, amsterdam.z}}};
        if (!crs.empty()) root["metadata"] = {{"referenceSystem", crs}};
        return root;
    }
};

/// The reader's result for a file with this text.
inline Result<FilePiece> readText(const std::string& text, const ReadSettings& settings = {}) {
    const TemporaryFolder folder;
    NoProgress progress;
    return readCityJson(folder.file("city.json", text), settings, progress, {});
}

inline Result<FilePiece> read(const Json& document, const ReadSettings& settings = {}) {
    return readText(document.dump(), settings);
}

}  // namespace noonmark::tests
