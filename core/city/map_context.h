#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// A picture of the ground, such as an aerial photograph: drawn for orientation, nothing is measured on it.
struct GroundRaster {
    Grid grid;
    std::vector<std::uint8_t>
        rgba;  ///< four bytes a cell, grid order; alpha not multiplied in, 0: no picture
};

/// What a feature of the map is. The order is that in which areas and lines are drawn.
enum class ContextKind : std::uint8_t {
    wood,
    grass,
    park,
    cemetery,
    sports,
    plaza,
    water,     ///< areas
    waterway,  ///< streams, as lines
    path,
    rail,
    street,
    tree,
};
inline constexpr std::array contextKinds{
    ContextKind::wood,   ContextKind::grass, ContextKind::park,   ContextKind::cemetery,
    ContextKind::sports, ContextKind::plaza, ContextKind::water,  ContextKind::waterway,
    ContextKind::path,   ContextKind::rail,  ContextKind::street, ContextKind::tree,
};

/// "wood", "grass", ...: the names in files.
std::string_view nameOf(ContextKind kind);
/// The kind of that name; nothing for any other text.
std::optional<ContextKind> parseContextKind(std::string_view name);

struct ContextArea {
    ContextKind kind = ContextKind::park;
    std::string name;                 ///< may be empty
    std::vector<Footprint> polygons;  ///< local metres; as in the file: they may cross themselves
    bool operator==(const ContextArea&) const = default;
};

struct ContextLine {
    ContextKind kind = ContextKind::street;
    std::string name;               ///< may be empty
    float widthM = 0;               ///< on the ground
    std::vector<glm::vec2> points;  ///< local metres, two or more
    bool operator==(const ContextLine&) const = default;
};

/// A picture of the ground over the rest of the context.
struct ContextPicture {
    std::shared_ptr<const GroundRaster> raster;  ///< never null
    double opacity = 1;                          ///< 0 to 1
    std::string attribution;                     ///< of the picture; empty if unknown
    bool operator==(const ContextPicture&) const = default;
};

/// What maps and views draw on the ground for orientation: streets, paths, rails, parks, water and trees, and
/// a picture such as an aerial photograph. It casts no shadow. Areas of water are no ground (WaterCells in
/// core/receivers/receivers.h).
struct MapContext {
    std::vector<ContextArea> areas;
    std::vector<ContextLine> lines;
    std::vector<glm::vec2> trees;  ///< local metres
    std::string attribution;       ///< of the data; empty if unknown
    std::optional<ContextPicture> picture;

    [[nodiscard]] bool empty() const { return areas.empty() && lines.empty() && trees.empty() && !picture; }
    bool operator==(const MapContext&) const = default;
};

/// Whose data a map of the city shows: `ofCity`, and the owner of the picture on its ground. `context`: of
/// the city; may be null.
std::string joinAttribution(const std::string& ofCity, const MapContext* context);

}  // namespace noonmark
