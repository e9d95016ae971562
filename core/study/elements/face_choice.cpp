#include "core/study/elements/face_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/receivers/points/solid_parts.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

namespace {

// Rounding turns a wall that faces due south by some 1e-5 degrees.
constexpr double roundingDeg = 0.001;

std::optional<double> numberIn(std::string_view text) {
    double number = 0;
    const auto end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return number;
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool crosses(const Ring& ring, glm::dvec2 from, glm::dvec2 by) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]), side = glm::dvec2(ring[(i + 1) % ring.size()]) - a;
        const double turn = cross(by, side);
        if (turn == 0) continue;
        const double along = cross(a - from, side) / turn, across = cross(a - from, by) / turn;
        if (along >= 0 && along <= 1 && across >= 0 && across <= 1) return true;
    }
    return false;
}

bool isOfFace(const PointElement& element, const std::string& face) {
    return element.id.starts_with(face + " floor ");
}

// How far a place is from a face, metres, in the face's plane and off it.
double distanceTo(const WallFace& face, glm::dvec3 place) {
    const glm::dvec2 from = glm::dvec2(place) - face.start;
    const double along = glm::dot(from, face.along), off = std::abs(glm::dot(from, face.normal()));
    const double beside = std::max({0.0, -along, along - face.lengthM});
    const double above = std::max({0.0, face.lowM - place.z, place.z - face.highM});
    return std::hypot(off, beside, above);
}

}  // namespace

bool AzimuthRange::holds(double azimuthDeg) const {
    if (std::isnan(azimuthDeg)) return false;
    const double width = std::fmod(toDeg - fromDeg + 720, 360);
    if (width == 0 && toDeg != fromDeg) return true;
    const double from = std::fmod(azimuthDeg - fromDeg + 720 + roundingDeg, 360);
    return from <= width + 2 * roundingDeg;
}

std::string formatText(const AzimuthRange& range) { return fmt::format("{}-{}", range.fromDeg, range.toDeg); }

Result<AzimuthRange> parseAzimuthRange(std::string_view text) {
    const auto dash = text.find('-', 1);
    const auto from = dash < text.size() ? numberIn(text.substr(0, dash)) : std::nullopt;
    const auto to = dash < text.size() ? numberIn(text.substr(dash + 1)) : std::nullopt;
    const auto fits = [](const std::optional<double>& deg) { return deg && *deg >= 0 && *deg <= 360; };
    if (!fits(from) || !fits(to))
        return failure(fmt::format("'{}' is not a range of azimuths", text), "facing",
                       "Give two azimuths from true north, 0 to 360 degrees: 135-225 for the south");
    return AzimuthRange{*from, *to};
}

std::string describe(const FaceChoice& choice) {
    std::vector<std::string> words;
    for (const std::string& face : choice.faces) words.push_back(face);
    if (choice.facing) words.push_back(fmt::format("facing {} deg", formatText(*choice.facing)));
    if (!choice.place.empty())
        words.push_back(fmt::format("facing {} within {:g} m", choice.place, choice.withinM));
    return fmt::format("{}", fmt::join(words, ", "));
}

bool looksAt(const std::vector<Footprint>& polygons, double withinM, glm::dvec2 position, glm::vec3 normal) {
    const glm::dvec2 level(normal);
    if (glm::length(level) < 1e-3) return false;
    const glm::dvec2 by = withinM * glm::normalize(level);
    return std::ranges::any_of(polygons, [&](const Footprint& polygon) {
        if (contains(polygon, position) || crosses(polygon.outer, position, by)) return true;
        return std::ranges::any_of(polygon.holes,
                                   [&](const Ring& hole) { return crosses(hole, position, by); });
    });
}

bool takes(const FaceChoice& choice, const std::vector<Footprint>& place, const Frame& frame,
           const PointElement& element, glm::vec3 position, glm::vec3 normal) {
    const auto isOneOf = [&](const std::string& face) { return isOfFace(element, face); };
    if (!choice.faces.empty() && !std::ranges::any_of(choice.faces, isOneOf)) return false;
    const glm::dvec2 at(position);
    if (choice.facing && !choice.facing->holds(facingAzimuthDeg(frame, frame.lonLatFromLocal(at), normal)))
        return false;
    return choice.place.empty() || looksAt(place, choice.withinM, at, normal);
}

std::optional<std::string> findFaceAt(const Building& building, glm::dvec3 place, glm::dvec3 normal) {
    constexpr double maxM = 1, minCosine = 0.98;  // some 11 degrees
    const glm::dvec2 level(normal);
    if (glm::length(level) < 0.5) return std::nullopt;
    std::optional<std::string> found;
    double nearest = maxM;
    std::size_t wall = 0;
    for (const Part& part : building.parts)
        for (const WallFace& face : findWallFaces(part)) {
            const bool faces = glm::dot(glm::normalize(level), face.normal()) >= minCosine;
            if (const double distance = distanceTo(face, place); faces && distance < nearest) {
                nearest = distance;
                found = fmt::format("{} wall {}", building.sourceId, wall);
            }
            ++wall;
        }
    return found;
}

}  // namespace noonmark
