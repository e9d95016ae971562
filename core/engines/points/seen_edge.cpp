#include "core/engines/points/seen_edge.h"

#include <algorithm>
#include <array>
#include <limits>

namespace noonmark {

namespace {

/// A face cut by the vertical plane of an azimuth: the ends of the cut, with their distance along the azimuth
/// and their height above the point.
struct FaceCut {
    std::array<glm::dvec2, 2> ends;
    int count = 0;
};

FaceCut cutFace(const OverhangFace& face, glm::dvec3 point, double sine, double cosine) {
    FaceCut cut;
    for (std::size_t i = 0; i < 3 && cut.count < 2; ++i) {
        const glm::dvec3 a = glm::dvec3(face.corners[i]) - point;
        const glm::dvec3 b = glm::dvec3(face.corners[(i + 1) % 3]) - point;
        // Distances to the right of the azimuth's line; half-open, so that a corner is crossed once.
        const double aRight = a.x * cosine - a.y * sine, bRight = b.x * cosine - b.y * sine;
        if ((aRight < 0) == (bRight < 0)) continue;
        const glm::dvec3 place = a + aRight / (aRight - bRight) * (b - a);
        cut.ends[std::size_t(cut.count++)] = {place.x * sine + place.y * cosine, place.z};
    }
    return cut;
}

}  // namespace

std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, double azimuth) {
    return hiddenBy(face, point, {std::sin(azimuth), std::cos(azimuth)});
}

std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, glm::dvec2 direction) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const FaceCut cut = cutFace(face, point, direction.x, direction.y);
    if (cut.count < 2) return std::nullopt;
    const auto [near, far] = std::minmax(cut.ends[0], cut.ends[1], [](auto a, auto b) { return a.x < b.x; });
    if (far.x <= 0) return std::nullopt;  // behind the point
    const double farTan = far.y / far.x;
    HiddenAltitudes hidden{farTan, infinite};
    if (near.x > 0) {
        const double nearTan = near.y / near.x;
        hidden = {std::min(nearTan, farTan), std::max(nearTan, farTan)};
    } else if (near.y + (far.y - near.y) * (-near.x) / (far.x - near.x) <= 0) {
        hidden = {0, farTan};  // the face passes below the point, otherwise it covers the zenith
    }
    if (hidden.highTan <= 0) return std::nullopt;
    hidden.lowTan = std::max(0.0, hidden.lowTan);
    return hidden;
}

void joinOverlaps(std::vector<HiddenAltitudes>& hidden) {
    std::ranges::sort(hidden, {}, &HiddenAltitudes::lowTan);
    std::size_t last = 0;
    for (std::size_t i = 1; i < hidden.size(); ++i) {
        if (hidden[i].lowTan <= hidden[last].highTan)
            hidden[last].highTan = std::max(hidden[last].highTan, hidden[i].highTan);
        else
            hidden[++last] = hidden[i];
    }
    if (!hidden.empty()) hidden.resize(last + 1);
}

}  // namespace noonmark
