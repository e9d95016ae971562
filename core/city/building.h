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

/// Where a part's height comes from; kept with the part, counted by `info`, shown in reports.
enum class HeightSource {
    measured,  ///< a height field in the data, in a stated unit
    levels,    ///< number of storeys x metres a storey
    assumed,   ///< nothing in the data; the stated default
    mesh,      ///< the geometry is three-dimensional by itself
    designed,  ///< stated by the user: a massing, a variant, a changed height
    madeUp,    ///< of a sample city: drawn by chance, of no real place
};
/// All of them, in the order in which they are counted: heightSources[i] == HeightSource(i).
inline constexpr std::array heightSources{HeightSource::measured, HeightSource::levels,
                                          HeightSource::assumed,  HeightSource::mesh,
                                          HeightSource::designed, HeightSource::madeUp};
/// "measured", "levels", "assumed", "mesh", "designed", "made up": in files and tables.
std::string_view nameOf(HeightSource source);
/// The source of that name; none for any other text.
std::optional<HeightSource> parseHeightSource(std::string_view name);

/// One solid: a footprint between two elevations, or a general closed mesh whose outline the footprint is.
struct Part {
    std::string sourceId;  ///< the feature it was read from: "way 34633854"
    Footprint footprint;
    float bottomM = 0;  ///< local z of its underside
    float topM = 0;     ///< local z of its highest point; > bottomM
    HeightSource heightSource = HeightSource::assumed;
    /// Open air below it: not heightfield-like, and the ground under it is a receiver.
    bool isOverhanging = false;
    /// Null for a prism. Else the part's geometry; footprint, bottomM and topM bound it.
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
