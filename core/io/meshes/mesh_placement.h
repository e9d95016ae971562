#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/geo/crs.h"
#include "core/geo/frame.h"
#include "core/io/meshes/mesh_scene.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// An axis that a mesh probably has upwards, and why: "it is 517 x 600 and only 90 in z".
struct UpAxisGuess {
    UpAxis axis = UpAxis::y;
    std::string why;
};

/// From the shape of a mesh whose format does not state it. In this order: a city is flat,
/// less than half as high as it is wide either way, and 100 m or more wide; a tower is higher than one
/// and a half times its width; buildings have most of their points at their feet; a flat bottom is at 0; the
/// lower one; y, which is usual. O(points).
/// `metresPerUnit`: of the mesh's coordinates.
UpAxisGuess guessUpAxis(const MeshScene& scene, double metresPerUnit = 1);

/// For a mesh in map coordinates: the axis along which its numbers are small, as heights are, and no
/// coordinates of a map. Nothing where y and z are alike. O(points).
std::optional<UpAxisGuess> guessUpAxisOnMap(const MeshScene& scene, double metresPerUnit = 1);

/// A mesh file, for placing it.
struct MeshFile {
    std::string path;    ///< for errors
    std::string name;    ///< for warnings
    std::string format;  ///< "glTF"
    std::optional<StatedAxes> stated;
    double zeroM = 0;  ///< elevation of the zero of its heights, where it lies about an origin of its own
};

/// Where the points of a mesh lie in local metres: about an origin of their own (ReadSettings::meshAnchor,
/// else the frame's origin), or in the map coordinates of ReadSettings::crs. Not thread-safe.
class MeshPlacement {
public:
    /// Map coordinates are taken where a system and no anchor is set, unless a frame is set and the mesh lies
    /// within 10 km of its own origin. Without a frame one is chosen: its origin is the anchor, or the middle
    /// of the mesh. Warnings say which axis is up, which unit the coordinates are in, and how far the file's
    /// numbers are rounded, where this was decided here. Error: there is no place, or the coordinates cannot
    /// belong to the system. O(points).
    static Result<MeshPlacement> of(const MeshScene& scene, const MeshFile& file,
                                    const ReadSettings& settings, Warnings& warnings);

    /// The piece's points, metres; NaN where there is no place for them. About 1 us each in map coordinates.
    [[nodiscard]] std::vector<glm::dvec3> local(const MeshPiece& piece) const;

    [[nodiscard]] const Frame& frame() const { return frame_; }
    [[nodiscard]] bool isOnMap() const { return crs_ != nullptr; }
    [[nodiscard]] std::string crsName() const { return crs_ ? crs_->name() : std::string(); }
    /// Where most of the mesh should lie: its own origin, or the frame's.
    [[nodiscard]] glm::dvec2 origin() const { return isOnMap() ? glm::dvec2(0) : origin_; }

private:
    [[nodiscard]] glm::dvec3 turned(const MeshPiece& piece, glm::vec3 point) const;
    Result<void> placeOnMap(const MeshScene& scene, const MeshFile& file, const ReadSettings& settings,
                            Warnings& warnings);
    [[nodiscard]] std::optional<LonLat> middleOnMap(const MeshScene& scene) const;
    void placeAboutOrigin(const ReadSettings& settings);

    Frame frame_;
    std::shared_ptr<const CrsToLonLat> crs_;  // null: about its own origin
    bool yUp_ = false;
    double across_ = 1;  // metres, or units of the system, per unit of the mesh: east and north
    double up_ = 1;      // metres per unit of the mesh: upwards
    double zeroM_ = 0;
    glm::dvec2 origin_{0};
    double sin_ = 0, cos_ = 1;  // azimuth of the mesh's north
};

}  // namespace noonmark
