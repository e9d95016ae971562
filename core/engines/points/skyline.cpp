#include "core/engines/points/skyline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/surface_rays.h"

namespace noonmark {

namespace {

/// Builds a list of pieces from left to right.
class PieceList {
public:
    void add(const SeenEdge& edge, double from, double to) {
        constexpr double minimum = 1e-12;  // radians: rounding of an azimuth
        if (to - from < minimum) return;
        if (!pieces_.empty()) {
            SeenEdge& last = pieces_.back();
            const bool same =
                last.east == edge.east && last.north == edge.north && last.building == edge.building;
            if (same && from - last.to < minimum) {
                last.to = to;
                return;
            }
        }
        pieces_.push_back(edge);
        pieces_.back().from = from;
        pieces_.back().to = to;
    }

    // Two curves of this kind cross at most once within half a turn.
    void addHigher(const SeenEdge& one, const SeenEdge& other, double from, double to) {
        const double east = one.east - other.east, north = one.north - other.north;
        const double middle = (from + to) / 2;
        double crossing = std::atan2(-north, east);  // where east sin + north cos is 0
        crossing += std::round((middle - crossing) / std::numbers::pi) * std::numbers::pi;
        if (crossing <= from || crossing >= to) {
            add(one.tanAt(middle) >= other.tanAt(middle) ? one : other, from, to);
            return;
        }
        const double before = (from + crossing) / 2;
        const bool oneFirst = one.tanAt(before) >= other.tanAt(before);
        add(oneFirst ? one : other, from, crossing);
        add(oneFirst ? other : one, crossing, to);
    }

    std::vector<SeenEdge> take() { return std::move(pieces_); }

private:
    std::vector<SeenEdge> pieces_;
};

std::vector<SeenEdge> mergeHighest(const std::vector<SeenEdge>& one, const std::vector<SeenEdge>& other) {
    PieceList highest;
    std::size_t i = 0, j = 0;
    double at = 0;
    while (i < one.size() || j < other.size()) {
        const SeenEdge* first = i < one.size() ? &one[i] : nullptr;
        const SeenEdge* second = j < other.size() ? &other[j] : nullptr;
        const double firstFrom = first != nullptr ? std::max(at, first->from) : fullTurn;
        const double secondFrom = second != nullptr ? std::max(at, second->from) : fullTurn;
        const double from = std::min(firstFrom, secondFrom);
        const bool hasFirst = first != nullptr && firstFrom <= from;
        const bool hasSecond = second != nullptr && secondFrom <= from;
        double to = fullTurn;
        if (first != nullptr) to = std::min(to, hasFirst ? first->to : first->from);
        if (second != nullptr) to = std::min(to, hasSecond ? second->to : second->from);
        if (hasFirst && hasSecond)
            highest.addHigher(*first, *second, from, to);
        else if (hasFirst || hasSecond)
            highest.add(hasFirst ? *first : *second, from, to);
        at = to;
        if (first != nullptr && first->to <= at) ++i;
        if (second != nullptr && second->to <= at) ++j;
        if (!hasFirst && !hasSecond) break;
    }
    return highest.take();
}

std::vector<SeenEdge> highestOf(std::span<const SeenEdge> edges) {
    if (edges.size() <= 1) return {edges.begin(), edges.end()};
    const std::size_t half = edges.size() / 2;
    return mergeHighest(highestOf(edges.first(half)), highestOf(edges.subspan(half)));
}

void cutAtNorth(std::vector<SeenEdge>& edges) {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (edges[i].to <= fullTurn) continue;
        SeenEdge rest = edges[i];
        rest.from = 0;
        rest.to -= fullTurn;
        edges[i].to = fullTurn;
        edges.push_back(rest);
    }
}

/// The highest of the edges at every azimuth: pieces of edges in ascending order of azimuth within 0 to 2 pi,
/// without overlaps; between them there is no edge. Where two edges cross, the piece ends exactly there.
/// Edges across north are cut there. O(n log n).
std::vector<SeenEdge> findHighest(std::vector<SeenEdge> edges) {
    cutAtNorth(edges);
    return highestOf(edges);
}

constexpr int skyParts = 720;
constexpr double partWidth = fullTurn / skyParts;
using LowestInParts = std::array<double, skyParts>;

// The parts that an edge or face between two azimuths touches; numbers from skyParts on are beyond north.
int firstPart(double azimuth) { return int(std::floor(azimuth / partWidth)); }

// A lower bound of the skyline in each part of the azimuths, from edges that cross the whole part: between
// two azimuths a curve that is positive at both is nowhere below the lower of them.
void raiseLowest(const SeenEdge& edge, LowestInParts& lowest) {
    const int last = firstPart(edge.to);
    for (int part = firstPart(edge.from) + 1; part < last; ++part) {
        const double low = std::min(edge.tanAt(part * partWidth), edge.tanAt((part + 1) * partWidth));
        double& known = lowest[std::size_t(part % skyParts)];
        known = std::max(known, low);
    }
}

bool risesAbove(const SeenEdge& edge, const LowestInParts& lowest) {
    // The highest value of the curve anywhere, and at its ends where the crest is not between them.
    const double crest = azimuthOf({edge.east, edge.north, 0});
    const bool hasCrest = (crest >= edge.from && crest <= edge.to) || crest + fullTurn <= edge.to;
    const double high =
        hasCrest ? std::hypot(edge.east, edge.north) : std::max(edge.tanAt(edge.from), edge.tanAt(edge.to));
    if (high <= 0) return false;
    const int last = firstPart(edge.to);
    for (int part = firstPart(edge.from); part <= last; ++part)
        if (high >= lowest[std::size_t(part % skyParts)]) return true;
    return false;
}

constexpr int fullDegrees = 360;
std::size_t degreeOf(double azimuth) {
    return std::min(std::size_t(fullDegrees - 1), std::size_t(azimuth * fullDegrees / fullTurn));
}

// The whole degrees, first and last, in which a face is seen; -360 to 719.
std::pair<int, int> degreesOf(const OverhangFace& face, glm::dvec3 eye) {
    const double start = azimuthOf(glm::dvec3(face.corners[0]) - eye);
    double low = 0, high = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        const double turn = std::remainder(azimuthOf(glm::dvec3(face.corners[i]) - eye) - start, fullTurn);
        low = std::min(low, turn), high = std::max(high, turn);
    }
    // From below or above a face, its corners lie all around.
    if (high - low >= std::numbers::pi) return {0, fullDegrees - 1};
    return {int(std::floor((start + low) * fullDegrees / fullTurn)),
            int(std::floor((start + high) * fullDegrees / fullTurn))};
}

void addEdge(const TopEdge& edge, glm::dvec3 eye, LowestInParts& lowest, std::vector<SeenEdge>& seen) {
    const auto view = seeEdge(edge, eye);
    if (!view || !risesAbove(*view, lowest)) return;
    raiseLowest(*view, lowest);
    seen.push_back(*view);
}

// Whether anything in a box can rise above the skyline, by the circle around it in plan.
bool risesAbove(const ObstacleBox& box, glm::dvec3 eye, const LowestInParts& lowest) {
    const double height = double(box.high.z) - eye.z;
    if (height <= 0) return false;
    const glm::dvec2 middle = glm::dvec2(box.middle()) - glm::dvec2(eye);
    const double distance = std::hypot(middle.x, middle.y);
    const double radius =
        0.5 * std::hypot(double(box.high.x - box.low.x), double(box.high.y - box.low.y)) * 1.001 + 1e-3;
    if (distance <= radius) return true;
    const double near = std::sqrt(double(ObstacleTree::distance2(box, glm::vec3(eye)))) - 1e-3;
    if (near <= 0) return true;
    const double high = height / near * 1.0001, half = std::asin(radius / distance);
    const double azimuth = azimuthOf({middle.x, middle.y, 0});
    const int first = firstPart(azimuth - half), last = firstPart(azimuth + half);
    for (int part = first; part <= last; ++part)
        if (high >= lowest[std::size_t((part + skyParts) % skyParts)]) return true;
    return false;
}

std::vector<SeenEdge> seeEdges(const SkyObstacles& obstacles, glm::dvec3 eye, LowestInParts& lowest) {
    std::vector<SeenEdge> seen;
    for (const TopEdge& edge : obstacles.edges) addEdge(edge, eye, lowest, seen);
    std::erase_if(seen, [&](const SeenEdge& edge) { return !risesAbove(edge, lowest); });
    return seen;
}

// Whether a face can hide sky above the skyline: its upper boundary is made of its edges, unless it is
// overhead. The ends of an edge that is seen end-on belong to the others. Most overhangs of a city are far
// away, behind something that stands on the ground.
bool risesAbove(const OverhangFace& face, glm::dvec3 eye, const LowestInParts& lowest) {
    if (degreesOf(face, eye) == std::pair{0, fullDegrees - 1}) return true;
    bool anySeen = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = glm::dvec3(face.corners[i]) - eye,
                         b = glm::dvec3(face.corners[(i + 1) % 3]) - eye;
        const auto edge = seeEdge(a, b, face.building);
        if (edge && risesAbove(*edge, lowest)) return true;
        anySeen = anySeen || edge;
    }
    return !anySeen;
}

}  // namespace

Skyline::Skyline(const SkyPoint& point)
    : eye_(glm::dvec3(placeSurfaceRayOrigin(point.position, point.normal)) +
           glm::dvec3(RayScene::wallOffsetM, RayScene::wallOffsetM, 0)),
      normal_(point.normal) {}

Skyline Skyline::at(const SkyPoint& point, const SkyTrees& trees) {
    Skyline skyline(point);
    const glm::dvec3 eye = skyline.eye_;
    LowestInParts lowest{};
    const auto canMatter = [&](const ObstacleBox& box) { return risesAbove(box, eye, lowest); };
    std::vector<SeenEdge> seen;
    trees.edges.visitNearestFirst(glm::vec3(eye), canMatter, [&](std::uint32_t index) {
        addEdge(trees.obstacles.edges[index], eye, lowest, seen);
    });
    std::erase_if(seen, [&](const SeenEdge& edge) { return !risesAbove(edge, lowest); });
    skyline.pieces_ = findHighest(std::move(seen));
    trees.faces.visitNearestFirst(glm::vec3(eye), canMatter, [&](std::uint32_t index) {
        const OverhangFace& face = trees.obstacles.faces[index];
        if (risesAbove(face, eye, lowest)) skyline.faces_.push_back(face);
    });
    skyline.sortFaces();
    return skyline;
}

Skyline Skyline::at(const SkyPoint& point, const SkyObstacles& obstacles) {
    Skyline skyline(point);
    LowestInParts lowest{};
    skyline.pieces_ = findHighest(seeEdges(obstacles, skyline.eye_, lowest));
    for (const OverhangFace& face : obstacles.faces)
        if (risesAbove(face, skyline.eye_, lowest)) skyline.faces_.push_back(face);
    skyline.sortFaces();
    return skyline;
}

void Skyline::sortFaces() {
    facesNear_.resize(fullDegrees);
    for (std::uint32_t index = 0; index < faces_.size(); ++index) {
        const auto [first, last] = degreesOf(faces_[index], eye_);
        for (int degree = first; degree <= last; ++degree)
            facesNear_[std::size_t((degree + fullDegrees) % fullDegrees)].push_back(index);
    }
}

const std::vector<std::uint32_t>& Skyline::facesNear(double azimuth) const {
    return facesNear_[degreeOf(azimuth)];
}

const SeenEdge* Skyline::pieceAt(double azimuth) const {
    auto after = std::ranges::upper_bound(pieces_, azimuth, {}, &SeenEdge::from);
    if (after == pieces_.begin()) return nullptr;
    const SeenEdge& piece = *--after;
    return azimuth <= piece.to ? &piece : nullptr;
}

double Skyline::tanAt(double azimuth) const {
    const SeenEdge* piece = pieceAt(azimuth);
    return piece != nullptr ? std::max(0.0, piece->tanAt(azimuth)) : 0;
}

std::vector<HiddenAltitudes> Skyline::hiddenAt(double azimuth) const {
    std::vector<HiddenAltitudes> hidden;
    if (const double tan = tanAt(azimuth); tan > 0) hidden.push_back({0, tan});
    const glm::dvec2 direction(std::sin(azimuth), std::cos(azimuth));
    for (const std::uint32_t index : facesNear(azimuth))
        if (const auto more = hiddenBy(faces_[index], eye_, direction)) hidden.push_back(*more);
    joinOverlaps(hidden);
    return hidden;
}

bool Skyline::hides(glm::vec3 direction) const {
    if (glm::dot(direction, normal_) <= 0) return true;
    const double azimuth = azimuthOf(glm::dvec3(direction));
    const double tan = double(direction.z) / std::hypot(double(direction.x), double(direction.y));
    if (tan <= tanAt(azimuth)) return true;
    return std::ranges::any_of(facesNear(azimuth), [&](std::uint32_t index) {
        const auto hidden = hiddenBy(faces_[index], eye_, azimuth);
        return hidden && tan >= hidden->lowTan && tan <= hidden->highTan;
    });
}

std::optional<std::uint32_t> Skyline::findHider(glm::vec3 direction) const {
    if (glm::dot(direction, normal_) <= 0) return SkyObstacles::ownWall;
    const double azimuth = azimuthOf(glm::dvec3(direction));
    const double tan = double(direction.z) / std::hypot(double(direction.x), double(direction.y));
    const SeenEdge* piece = pieceAt(azimuth);
    if (piece != nullptr && tan <= std::max(0.0, piece->tanAt(azimuth))) return piece->building;
    for (const std::uint32_t index : facesNear(azimuth)) {
        const auto hidden = hiddenBy(faces_[index], eye_, azimuth);
        if (hidden && tan >= hidden->lowTan && tan <= hidden->highTan) return faces_[index].building;
    }
    return std::nullopt;
}

std::vector<double> Skyline::breaks() const {
    std::vector<double> azimuths{0, fullTurn};
    for (const SeenEdge& piece : pieces_) azimuths.insert(azimuths.end(), {piece.from, piece.to});
    for (const OverhangFace& face : faces_)
        for (const glm::vec3 corner : face.corners) azimuths.push_back(azimuthOf(glm::dvec3(corner) - eye_));
    if (std::hypot(normal_.x, normal_.y) > 0) {  // the ends of what the surface faces
        const double facing = azimuthOf(glm::dvec3(normal_));
        for (const double side : {facing + fullTurn / 4, facing + fullTurn * 3 / 4})
            azimuths.push_back(std::fmod(side, fullTurn));
    }
    std::ranges::sort(azimuths);
    azimuths.erase(std::unique(azimuths.begin(), azimuths.end()), azimuths.end());
    return azimuths;
}

}  // namespace noonmark
