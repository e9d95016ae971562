#pragma once

// The folder core/io/context reads what maps draw for orientation (core/city/map_context.h): it holds the
// rules of OpenStreetMap's tags, finds the sea beside coastlines, and reads files.

#include <cstddef>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/footprints/footprint.h"
#include "core/city/map_context.h"
#include "core/geo/frame.h"
#include "core/io/places/place_tags.h"

namespace noonmark {

/// The kind of an area, a line or a point by its OpenStreetMap tags
/// (https://wiki.openstreetmap.org/wiki/Map_features); nothing for what is not drawn: buildings, car parks,
/// anything underground or proposed.
std::optional<ContextKind> classifyContextArea(const PlaceTags& tags);
std::optional<ContextKind> classifyContextLine(const PlaceTags& tags);
std::optional<ContextKind> classifyContextPoint(const PlaceTags& tags);

/// Whether a line is a coastline: the edge of the sea, which lies on its right.
bool isCoastline(const PlaceTags& tags);

/// The width to draw a line with, metres: as tagged, else the default of its class.
double widthOfLine(ContextKind kind, const PlaceTags& tags);

/// A coastline in its direction, local metres: land lies on its left, the sea on its right, as OpenStreetMap
/// has it (https://wiki.openstreetmap.org/wiki/Tag:natural=coastline). A ring ends with its first point.
using CoastLine = std::vector<glm::dvec2>;

/// The sea within a box.
struct Sea {
    std::vector<Footprint> polygons;
    /// Ends of the coast that are continued straight to the nearest side of the box, metres each.
    std::vector<double> continuedM;
    /// Ends of the coast in the middle of the box. The sea around them is not known and left out.
    std::vector<glm::dvec2> openEnds;
    /// Areas with land and sea on the same side of their coast, which are left out, too.
    std::size_t contradictions = 0;
};

/// Chains coastlines by their common ends, closes them along the sides of the box, and takes the areas on
/// their right. An extract lacks the next point of a coast that leaves it: an end nearer to a side than a
/// tenth of the box's shorter side (100 m at least) goes on straight to it. Nothing else is guessed.
/// Coastlines may reach beyond the box. O(n log n).
Sea findSea(const std::vector<CoastLine>& coast, const Box2& box);

struct ContextSettings {
    /// Most features of one file that are drawn; more would be a whole country.
    static constexpr std::size_t maxFeatures = 1'000'000;
    /// Features farther from the frame's origin are left out and counted; areas that reach nearer are cut to
    /// the square of twice this side about it.
    double farAwayM = 60000;
    bool waterOnly = false;          ///< areas of water and nothing else
    std::optional<std::string> crs;  ///< "EPSG:2263", for files that state none
};

struct ContextRead {
    MapContext context;
    Warnings warnings;
    std::size_t features = 0;      ///< number of features read
    std::vector<CoastLine> coast;  ///< of an OpenStreetMap file; the sea beside it is among the areas
};

/// Reads what a map draws for orientation into the frame of a city: of an OpenStreetMap file by its tags
/// (classifyContextArea() and the like); of any other vector format features whose field `kind` names a
/// ContextKind, or whose columns bear OpenStreetMap's keys. The sea is what lies on the right of coastlines
/// within the box that the file covers, or that of the coastlines where it states none (findSea()). Shapes
/// are drawn as they are, without repair. Error: the file cannot be read, is damaged, states no CRS, has no
/// such feature (not for OpenStreetMap) or too many; cancelled(). Some 10 us a feature. Backend:
/// read_context_gdal.cpp.
Result<ContextRead> readContext(const std::filesystem::path& file, const ContextSettings& settings,
                                const Frame& frame, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
