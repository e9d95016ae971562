#include "core/study/elements/element_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/version.h"
#include "core/measures/palette.h"

namespace noonmark {

namespace {

using GltfJson = nlohmann::ordered_json;

// Numbers of the glTF standard.
constexpr int glFloat = 5126, glByte = 5121, glWhole = 5125;
constexpr int glVertices = 34962, glIndices = 34963, glTriangles = 4;

/// The binary part of a file with the views and accessors that describe it.
class GltfBuffer {
public:
    template <class T>
    int add(const std::vector<T>& values, int target, GltfJson accessor) {
        const std::size_t offset = bytes_.size(), length = values.size() * sizeof(T);
        bytes_.append(reinterpret_cast<const char*>(values.data()), length);
        bytes_.append((4 - length % 4) % 4, '\0');
        views_.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", target}});
        accessor["bufferView"] = views_.size() - 1;
        accessors_.push_back(std::move(accessor));
        return int(accessors_.size()) - 1;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const GltfJson& views() const { return views_; }
    [[nodiscard]] const GltfJson& accessors() const { return accessors_; }

private:
    std::string bytes_;
    GltfJson views_ = GltfJson::array(), accessors_ = GltfJson::array();
};

struct Corners {
    std::vector<glm::vec3> positions;
    std::vector<std::array<std::uint8_t, 4>> colours;
    std::vector<float> sunlit, gross, continuous;
    std::vector<std::uint32_t> triangles;
};

double topOf(const ElementMap& map) {
    double top = map.possibleMin;
    for (const MeasuredElement& element : map.elements) top = std::max(top, element.grossMin);
    return legendScale(top).top;
}

// The glTF standard takes linear colours.
std::uint8_t linear(std::uint8_t srgb) {
    const double share = srgb / 255.0;
    const double light = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    return std::uint8_t(std::lround(255 * light));
}

Corners cornersOf(const ElementMap& map) {
    Corners corners;
    const double top = topOf(map);
    for (const MeasuredElement& element : map.elements) {
        const auto first = std::uint32_t(corners.positions.size());
        const Rgb colour = shadowRgb(element.grossMin / top);
        for (const glm::vec3& corner : cornersOf(element)) {
            corners.positions.emplace_back(corner.x, corner.z, -corner.y);
            corners.colours.push_back({linear(colour.red), linear(colour.green), linear(colour.blue), 255});
            corners.sunlit.push_back(float(element.sunlitMin));
            corners.gross.push_back(float(element.grossMin));
            corners.continuous.push_back(float(element.continuousMin));
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
            corners.triangles.push_back(first + corner);
    }
    return corners;
}

GltfJson accessorOf(std::size_t count, int component, const char* type) {
    return {{"componentType", component}, {"count", count}, {"type", type}};
}

int addPositions(GltfBuffer& buffer, const std::vector<glm::vec3>& positions) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    GltfJson accessor = accessorOf(positions.size(), glFloat, "VEC3");
    accessor["min"] = GltfJson::array({low.x, low.y, low.z});
    accessor["max"] = GltfJson::array({high.x, high.y, high.z});
    return buffer.add(positions, glVertices, std::move(accessor));
}

GltfJson primitiveOf(GltfBuffer& buffer, const Corners& corners) {
    const std::size_t count = corners.positions.size();
    GltfJson colours = accessorOf(count, glByte, "VEC4");
    colours["normalized"] = true;
    GltfJson attributes{{"POSITION", addPositions(buffer, corners.positions)},
                        {"COLOR_0", buffer.add(corners.colours, glVertices, std::move(colours))}};
    const auto addMinutes = [&](const char* name, const std::vector<float>& values) {
        attributes[name] = buffer.add(values, glVertices, accessorOf(count, glFloat, "SCALAR"));
    };
    addMinutes("_SUNLIT_MIN", corners.sunlit);
    addMinutes("_GROSS_MIN", corners.gross);
    addMinutes("_CONTINUOUS_MIN", corners.continuous);
    const int indices =
        buffer.add(corners.triangles, glIndices, accessorOf(corners.triangles.size(), glWhole, "SCALAR"));
    return {{"attributes", attributes}, {"indices", indices}, {"material", 0}, {"mode", glTriangles}};
}

GltfJson describeScene(const ElementMap& map, GltfBuffer& buffer) {
    GltfJson ids = GltfJson::array();
    for (const MeasuredElement& element : map.elements) ids.push_back(element.id);
    GltfJson json;
    json["asset"] = {{"version", "2.0"}, {"generator", "Noonmark " + std::string(version())}};
    json["extensionsUsed"] = GltfJson::array({"KHR_materials_unlit"});
    json["scene"] = 0;
    json["scenes"] = GltfJson::array();
    json["scenes"].push_back({{"nodes", GltfJson::array({0})}});
    json["nodes"] = GltfJson::array();
    json["nodes"].push_back({{"mesh", 0}, {"name", "elements"}});
    json["materials"] = GltfJson::array();
    json["materials"].push_back({{"pbrMetallicRoughness", {{"metallicFactor", 0}}},
                                 {"extensions", {{"KHR_materials_unlit", GltfJson::object()}}},
                                 {"doubleSided", true}});
    GltfJson primitives = GltfJson::array();
    primitives.push_back(primitiveOf(buffer, cornersOf(map)));
    json["meshes"] = GltfJson::array();
    json["meshes"].push_back({{"primitives", std::move(primitives)}, {"extras", {{"ids", std::move(ids)}}}});
    json["buffers"] = GltfJson::array();
    json["buffers"].push_back({{"byteLength", buffer.bytes().size()}});
    json["bufferViews"] = buffer.views();
    json["accessors"] = buffer.accessors();
    return json;
}

void addWhole(std::string& file, std::uint32_t value) {
    char bytes[4];
    std::memcpy(bytes, &value, 4);
    file.append(bytes, 4);
}

}  // namespace

std::string toGlb(const ElementMap& map) {
    GltfBuffer buffer;
    std::string text = describeScene(map, buffer).dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string file = "glTF";
    addWhole(file, 2);
    addWhole(file, std::uint32_t(12 + 8 + text.size() + 8 + buffer.bytes().size()));
    addWhole(file, std::uint32_t(text.size()));
    file += "JSON" + text;
    addWhole(file, std::uint32_t(buffer.bytes().size()));
    file.append("BIN\0", 4);
    return file + buffer.bytes();
}

}  // namespace noonmark
