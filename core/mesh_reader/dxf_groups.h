#pragma once

// A DXF file is text: pairs of lines, a group code and its value (Autodesk, "DXF Reference"). dxf_groups.h
// reads them as entities, dxf_shapes.h makes polygons from one entity, read_dxf.h joins blocks and layers.

#include <glm/vec3.hpp>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace noonmark {

/// One entity, or one mark such as SECTION: group 0 and the groups up to the next 0.
struct DxfEntity {
    std::string type;  ///< "3DFACE"
    std::vector<std::pair<int, std::string>> groups;

    [[nodiscard]] std::string text(int code) const;                     ///< the first one; empty: absent
    [[nodiscard]] double number(int code, double otherwise = 0) const;  ///< `otherwise` also where not finite
    [[nodiscard]] int whole(int code, int otherwise = 0) const;
    /// Groups `first`, first + 10 and first + 20: x, y, z. Absent coordinates are 0.
    [[nodiscard]] glm::dvec3 point(int first) const;
    [[nodiscard]] bool has(int code) const;
};

/// A finite number; nothing for any other text.
std::optional<double> parseDxfNumber(const std::string& text);

/// Reads a DXF entity by entity. Broken pairs end the file.
class DxfReader {
public:
    explicit DxfReader(std::istream& stream);
    std::optional<DxfEntity> next();

private:
    bool readPair();

    std::istream& stream_;
    int code_ = -1;  // of the pair that was read last
    std::string value_;
    bool good_ = false;
};

}  // namespace noonmark
