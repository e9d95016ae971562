#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace noonmark {

/// The axes of a street grid: x across the avenues (towards the east), y along them (towards the north),
/// metres from the crossing at `origin` in the local frame. Manhattan's avenues run at an azimuth of 29
/// degrees.
struct StreetAxes {
    glm::dvec2 origin{0, 0};

    [[nodiscard]] glm::dvec2 localFromStreet(glm::dvec2 street) const;
    [[nodiscard]] glm::dvec2 streetFromLocal(glm::dvec2 local) const;
};

/// A rectangle parallel to the streets.
struct StreetBox {
    double west = 0, south = 0, east = 0, north = 0;

    [[nodiscard]] double width() const { return east - west; }
    [[nodiscard]] double depth() const { return north - south; }
    [[nodiscard]] glm::dvec2 middle() const { return {(west + east) / 2, (south + north) / 2}; }
    [[nodiscard]] bool overlaps(const StreetBox& other) const {
        return west < other.east && other.west < east && south < other.north && other.south < north;
    }
};

/// A convex polygon in street axes, counter-clockwise.
using StreetPolygon = std::vector<glm::dvec2>;

StreetPolygon cornersOf(const StreetBox& box);
double computeArea(const StreetPolygon& polygon);

/// A straight avenue that does not follow the grid, such as Broadway.
struct SkewedAvenue {
    glm::dvec2 through{0, 0};
    double eastPerNorth = 0;  ///< metres east for each metre north
    double widthM = 30;

    /// The larger of the two pieces into which the avenue divides a convex polygon; the polygon itself if
    /// they do not meet.
    [[nodiscard]] StreetPolygon clipped(const StreetPolygon& polygon) const;
};

}  // namespace noonmark
