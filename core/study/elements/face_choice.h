#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/receivers/point_receivers.h"

namespace noonmark {

/// Azimuths from true north, clockwise from the first to the last, 0 to 360 degrees; across north the first
/// is the larger: 315 to 45.
struct AzimuthRange {
    double fromDeg = 0, toDeg = 360;
    [[nodiscard]] bool holds(double azimuthDeg) const;  ///< both ends are included
    bool operator==(const AzimuthRange&) const = default;
};

/// "135-225"
std::string formatText(const AzimuthRange& range);
/// Reads what formatText() writes. Error: anything else, or a value outside 0 to 360.
Result<AzimuthRange> parseAzimuthRange(std::string_view text);

/// Which faces of buildings are measured, or which windows, by what they face. All conditions must hold; by
/// default there are none.
struct FaceChoice {
    static constexpr double maxWithinM = 5000;

    std::vector<std::string> faces;  ///< facades: ids of faces, "way 12 wall 3"; empty: all
    std::optional<AzimuthRange> facing;
    std::string place;     ///< faces that look at this place (looksAt()); empty: all
    double withinM = 100;  ///< of that place, 1 to maxWithinM
    [[nodiscard]] bool takesAll() const { return faces.empty() && !facing && place.empty(); }
    bool operator==(const FaceChoice&) const = default;
};

/// "facing 135-225 deg, facing Bryant Park within 100 m"; empty where all faces are taken.
std::string describe(const FaceChoice& choice);

/// Whether a level line straight out from the surface meets a polygon within a distance, metres; false for a
/// level surface. O(points of the polygons).
bool looksAt(const std::vector<Footprint>& polygons, double withinM, glm::dvec2 position, glm::vec3 normal);

/// Whether the point is taken. `place`: the polygons of choice.place.
bool takes(const FaceChoice& choice, const std::vector<Footprint>& place, const Frame& frame,
           const PointElement& element, glm::vec3 position, glm::vec3 normal);

/// The id of the building's face that a place on its walls belongs to, as in the ids of its points: the plane
/// that faces as `normal` does and is nearest, at most 1 m away. None: no such face.
std::optional<std::string> findFaceAt(const Building& building, glm::dvec3 place, glm::dvec3 normal);

}  // namespace noonmark
