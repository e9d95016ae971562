#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// Origin of a part's height; stored with the part, counted by `info`, shown in reports.
enum class HeightSource {
    measured,  ///< a height field in the data, in a stated unit
    levels,    ///< number of storeys x metres a storey
    assumed,   ///< nothing in the data; the stated default
    mesh,      ///< the geometry is three-dimensional
    designed,  ///< stated by the user: a massing, a variant, a changed height
    madeUp,    ///< of a sample city: drawn at random, of no real place
};
/// All values, in the order in which they are counted: heightSources[i] == HeightSource(i).
inline constexpr std::array heightSources{HeightSource::measured, HeightSource::levels,
                                          HeightSource::assumed,  HeightSource::mesh,
                                          HeightSource::designed, HeightSource::madeUp};
/// "measured", "levels", "assumed", "mesh", "designed", "made up": the names used in files and tables.
std::string_view nameOf(HeightSource source);
/// The source of that name; nothing for any other text.
std::optional<HeightSource> parseHeightSource(std::string_view name);

/// One solid: a footprint between two elevations (a prism), or a general closed mesh with the footprint as
/// its outline.
struct Part {
    std::string sourceId;  ///< the feature it was read from: "way 34633854"
    Footprint footprint;
    float bottomM = 0;  ///< local z of its underside
    float topM = 0;     ///< local z of its highest point; > bottomM
    HeightSource heightSource = HeightSource::assumed;
    /// True for an overhang: a part with open air below it. It is not heightfield-like, and the ground under
    /// it is a receiver.
    bool isOverhanging = false;
    /// Null for a prism. Otherwise the geometry of the part; footprint, bottomM and topM bound it.
    std::shared_ptr<const TriangleMesh> mesh;

    bool operator==(const Part&) const = default;
};

/// What a user sees as one building. Its parts may touch or overlap.
struct Building {
    std::string sourceId;  ///< of the outline, or of the only part
    std::string name;      ///< may be empty
    std::string status;    ///< free text of the source: "built", "to be built"; may be empty
    std::vector<Part> parts;

    bool operator==(const Building&) const = default;
};

Box2 bounds(const Building& building);
float topM(const Building& building);

}  // namespace noonmark
