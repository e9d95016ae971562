#include "core/engines/ray/traced_view.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

namespace noonmark {

namespace {

std::uint32_t kindBitsOf(TracedPixel pixel) { return pixel.bits >> TracedPixel::kindShift & 3U; }

bool isTree(TracedPixel pixel) { return (pixel.bits & TracedPixel::tree) != 0; }

}  // namespace

SeenKind kindOf(TracedPixel pixel) {
    return isTree(pixel) ? SeenKind::building : SeenKind(kindBitsOf(pixel));
}

std::optional<TreePart> treePartOf(TracedPixel pixel) {
    return isTree(pixel) ? std::optional(TreePart(kindBitsOf(pixel))) : std::nullopt;
}

bool isBehindBareCrown(TracedPixel pixel) { return std::signbit(pixel.depthM); }

namespace {

constexpr int sidePx = PixelBlock::sidePx;
constexpr float sharedM = 0.01F;  // surfaces in a side of the section belong to it
// Rays are traced a little farther than they end: the bottom of a building lies in the ground, and is seen
// before it where a section opens the building.
constexpr float beyond = 1.00001F;
constexpr int minTurn = 36;  // of the normal at an edge, in 127ths: 16 degrees

using Bits = std::array<std::uint32_t, HitPacket::lanes>;

class ViewTracer {
public:
    ViewTracer(const RayScene& scene, const PixelCamera& camera, const TracedSpace& space, TracedView& view)
        : scene_(scene),
          camera_(camera),
          space_(space),
          view_(view),
          right_(camera.right / samplesPerMetre(camera, 1)),
          up_(camera.up / samplesPerMetre(camera, 1)) {
        std::ranges::transform(space.trees, std::back_inserter(groups_), groupsOf);
    }

    void traceBlock(int column, int row) const {
        HitPacket packet;
        aimRays(blockAt(column, row), packet);
        packet.from.fill(space_.nearM);
        packet.distance.fill(space_.farM);
        if (camera_.section) limitToSection(packet);
        const std::uint32_t ground = endAtGround(space_.groundM, packet);
        const HitPacket::Lanes ends = packet.distance;
        for (float& distance : packet.distance) distance *= beyond;
        const HitPacket::Lanes farthest = packet.distance;
        scene_.firstHits(packet);
        if (!space_.hidden.empty()) passHidden(packet, farthest);
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane)
            if (packet.hit[lane] == HitPacket::nothing) packet.distance[lane] = ends[lane];
        const SeenTrees trees = space_.trees.empty() ? SeenTrees{} : traceTrees(packet);
        Bits bits;
        packPixels(packet, ground, camera_.section.has_value(), bits.data());
        if (trees.seen != 0) markTrees(trees, packet, bits);
        HitPacket::Lanes depths = packet.distance;
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane)
            if ((trees.behindBare >> lane & 1U) != 0) depths[lane] = -depths[lane];
        if (space_.towardsSun) markSun(packet, ground & ~trees.seen, bits);
        store(packet, depths, bits, column, row);
    }

private:
    /// The rays of a packet that meet trees. Bit k: ray k.
    struct SeenTrees {
        std::uint32_t seen = 0, behindBare = 0;
        std::array<TreePart, HitPacket::lanes> parts{};  ///< of rays in `seen`
    };

    /// Which groups of a scene of trees are what, as RayScene::firstHits() takes them; empty: none is.
    struct Groups {
        std::vector<std::uint8_t> solid, leaves, bare;
    };

    static Groups groupsOf(const TracedTrees& trees) {
        const auto choose = [&](auto isOne) {
            std::vector<std::uint8_t> chosen;
            for (const TreePart part : trees.parts) chosen.push_back(isOne(part) ? 1 : 0);
            if (std::ranges::find(chosen, 1) == chosen.end()) chosen.clear();
            return chosen;
        };
        const auto isBare = [](TreePart part) { return part == TreePart::bare; };
        return {choose(std::not_fn(isBare)),
                choose([&](TreePart part) { return !isBare(part) && part != TreePart::trunk; }),
                choose(isBare)};
    }

    [[nodiscard]] std::uint32_t findBlocked(std::vector<std::uint8_t> Groups::*which,
                                            const HitPacket& packet) const {
        std::uint32_t blocked = 0;
        for (std::size_t i = 0; i < space_.trees.size(); ++i)
            if (const auto& groups = groups_[i].*which; !groups.empty())
                blocked |= space_.trees[i].scene.findBlocked(packet, groups);
        return blocked;
    }

    // Ends rays at the trees that they meet before their hits.
    [[nodiscard]] SeenTrees traceTrees(HitPacket& packet) const {
        SeenTrees trees;
        for (std::size_t i = 0; i < space_.trees.size(); ++i) {
            if (groups_[i].solid.empty()) continue;
            HitPacket next = packet;
            space_.trees[i].scene.firstHits(next, groups_[i].solid);
            for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
                if (next.hit[lane] == HitPacket::nothing) continue;
                takeLane(packet, next, lane);
                trees.seen |= 1U << lane;
                trees.parts[lane] = space_.trees[i].parts[next.hit[lane]];
            }
        }
        trees.behindBare = findBlocked(&Groups::bare, packet);
        return trees;
    }

    static void markTrees(const SeenTrees& trees, HitPacket& packet, Bits& bits) {
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
            if ((trees.seen >> lane & 1U) == 0) continue;
            bits[lane] &= ~(3U << TracedPixel::kindShift);
            bits[lane] |= TracedPixel::tree | std::uint32_t(trees.parts[lane]) << TracedPixel::kindShift;
            packet.hit[lane] = HitPacket::nothing;  // none of the city's buildings
        }
    }

    [[nodiscard]] PixelBlock blockAt(int column, int row) const {
        const float x = float(column) + 0.5F - float(camera_.widthPx) * 0.5F;
        const float y = float(camera_.heightPx) * 0.5F - float(row) - 0.5F;
        const glm::vec3 eye(camera_.eye), forward(camera_.forward), aside = x * right_ + y * up_;
        const bool parallel = camera_.heightM > 0;
        return {parallel ? eye + aside : eye, parallel ? forward : forward + aside, right_, -up_, parallel};
    }

    void markSun(HitPacket& packet, std::uint32_t ground, Bits& bits) const {
        const std::uint32_t facing = turnToSun(*space_.towardsSun, bits.data(), packet);
        if (space_.terrain) liftToTerrain(packet, ground & facing);
        const std::uint32_t lit = facing == 0 ? 0 : facing & ~scene_.findBlocked(packet);
        const std::uint32_t dense = lit == 0 ? 0 : lit & findBlocked(&Groups::leaves, packet);
        const std::uint32_t light = lit == 0 ? 0 : lit & ~dense & findBlocked(&Groups::bare, packet);
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
            bits[lane] |= ((lit & ~dense) >> lane & 1U) << TracedPixel::sunBit;
            bits[lane] |= ((dense | light) >> lane & 1U) << TracedPixel::crownBit;
        }
    }

    // `ground`: rays that end at the plane if nothing lies before it.
    void liftToTerrain(HitPacket& packet, std::uint32_t ground) const {
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
            if ((ground >> lane & 1U) == 0 || packet.hit[lane] != HitPacket::nothing) continue;
            const float above = elevationAt(*space_.terrain, {packet.originX[lane], packet.originY[lane]});
            packet.originZ[lane] += std::max(0.0F, above - space_.groundM);
        }
    }

    // The pixels of a block that lie within the picture.
    void store(const HitPacket& packet, const HitPacket::Lanes& depths, const Bits& bits, int column,
               int row) const {
        const int columns = std::min(sidePx, camera_.widthPx - column);
        const int rows = std::min(sidePx, camera_.heightPx - row);
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const auto pixel =
                    std::size_t(row + i) * std::size_t(camera_.widthPx) + std::size_t(column + j);
                const auto lane = std::size_t(i * sidePx + j);
                const std::uint32_t marked = isIn(space_.marked, packet.hit[lane]) ? 1 : 0;
                view_.pixels[pixel] = {depths[lane], bits[lane] | marked << TracedPixel::markedBit};
                view_.hits[pixel] = packet.hit[lane];
            }
    }

    // A ray that misses the section gets an empty range.
    void limitToSection(HitPacket& packet) const {
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
            limit(packet, lane, 0, packet.originX[lane], packet.directionX[lane]);
            limit(packet, lane, 1, packet.originY[lane], packet.directionY[lane]);
            limit(packet, lane, 2, packet.originZ[lane], packet.directionZ[lane]);
        }
    }

    void limit(HitPacket& packet, std::size_t lane, int axis, float origin, float direction) const {
        const float toLow = camera_.section->low[axis] - sharedM - origin;
        const float toHigh = camera_.section->high[axis] + sharedM - origin;
        if (direction == 0) {
            if (toLow > 0 || toHigh < 0) packet.distance[lane] = -1;
            return;
        }
        const auto [near, far] = std::minmax({toLow / direction, toHigh / direction});
        packet.from[lane] = std::max(packet.from[lane], near);
        packet.distance[lane] = std::min(packet.distance[lane], far);
    }

    static bool isIn(std::span<const std::uint8_t> buildings, std::uint32_t hit) {
        return hit < buildings.size() && buildings[hit] != 0;
    }

    [[nodiscard]] bool isHidden(std::uint32_t hit) const { return isIn(space_.hidden, hit); }

    // Rays that hit a hidden building go on behind it.
    void passHidden(HitPacket& packet, const HitPacket::Lanes& farthest) const {
        while (std::ranges::any_of(packet.hit, [this](std::uint32_t hit) { return isHidden(hit); })) {
            HitPacket next = packet;
            for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
                next.from[lane] = std::nextafter(packet.distance[lane], space_.farM);
                next.distance[lane] = isHidden(packet.hit[lane]) ? farthest[lane] : -1;
            }
            scene_.firstHits(next);
            for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane)
                if (isHidden(packet.hit[lane])) takeLane(packet, next, lane);
        }
    }

    static void takeLane(HitPacket& packet, const HitPacket& next, std::size_t lane) {
        packet.distance[lane] = next.distance[lane];
        packet.normalX[lane] = next.normalX[lane], packet.normalY[lane] = next.normalY[lane];
        packet.normalZ[lane] = next.normalZ[lane];
        packet.hit[lane] = next.hit[lane];
    }

    const RayScene& scene_;
    const PixelCamera& camera_;
    const TracedSpace& space_;
    TracedView& view_;
    std::vector<Groups> groups_;  // of each of space_.trees
    const glm::vec3 right_, up_;  // one pixel further, at a depth of one metre
};

int partOf(std::uint32_t bits, unsigned shift) { return int(bits >> shift & 0xffU) - 127; }

bool isBuilding(TracedPixel pixel) { return !isTree(pixel) && kindOf(pixel) >= SeenKind::building; }

bool differs(const TracedView& view, std::size_t a, std::size_t b) {
    const std::uint32_t one = view.pixels[a].bits, other = view.pixels[b].bits;
    if (one == other && view.hits[a] == view.hits[b]) return false;
    if (!isBuilding(view.pixels[a]) && !isBuilding(view.pixels[b])) return false;
    const int x = partOf(one, 0) - partOf(other, 0), y = partOf(one, 8) - partOf(other, 8);
    const int z = partOf(one, 16) - partOf(other, 16);
    return view.hits[a] != view.hits[b] || x * x + y * y + z * z > minTurn * minTurn;
}

float depthOf(TracedPixel pixel) {
    return kindOf(pixel) == SeenKind::sky ? std::numeric_limits<float>::infinity() : std::abs(pixel.depthM);
}

// The nearer of two pixels has the edge, so that lines are one pixel wide.
bool bordersOn(const TracedView& view, std::size_t pixel, std::size_t neighbour) {
    if (isTree(view.pixels[pixel]) || !differs(view, pixel, neighbour)) return false;
    const float own = depthOf(view.pixels[pixel]), its = depthOf(view.pixels[neighbour]);
    return own < its || (own == its && pixel < neighbour);
}

void findEdges(TracedView& view, int row, int firstColumn, int lastColumn) {
    const auto width = std::size_t(view.widthPx);
    for (int column = firstColumn; column < lastColumn; ++column) {
        const std::size_t pixel = std::size_t(row) * width + std::size_t(column);
        const bool edge = (column + 1 < lastColumn && bordersOn(view, pixel, pixel + 1)) ||
                          (column > firstColumn && bordersOn(view, pixel, pixel - 1)) ||
                          (row + 1 < view.heightPx && bordersOn(view, pixel, pixel + width)) ||
                          (row > 0 && bordersOn(view, pixel, pixel - width));
        view.edges[pixel] = edge ? 1 : 0;
    }
}

void markEdges(TracedView& view, int row, int firstColumn, int lastColumn) {
    for (int column = firstColumn; column < lastColumn; ++column) {
        const std::size_t pixel = std::size_t(row) * std::size_t(view.widthPx) + std::size_t(column);
        view.pixels[pixel].bits |= std::uint32_t(view.edges[pixel]) << TracedPixel::edgeBit;
    }
}

}  // namespace

glm::vec3 normalOf(TracedPixel pixel) {
    return glm::normalize(glm::vec3(partOf(pixel.bits, 0), partOf(pixel.bits, 8), partOf(pixel.bits, 16)));
}

bool isInSun(TracedPixel pixel) { return (pixel.bits >> TracedPixel::sunBit & 1U) != 0; }

bool isUnderCrown(TracedPixel pixel) { return (pixel.bits >> TracedPixel::crownBit & 1U) != 0; }

bool isMarked(TracedPixel pixel) { return (pixel.bits >> TracedPixel::markedBit & 1U) != 0; }

bool isEdge(TracedPixel pixel) { return (pixel.bits >> TracedPixel::edgeBit & 1U) != 0; }

void traceView(const RayScene& scene, const PixelCamera& camera, const TracedSpace& space, TracedView& view) {
    view.widthPx = camera.widthPx;
    view.heightPx = camera.heightPx;
    view.pixels.resize(std::size_t(camera.widthPx) * std::size_t(camera.heightPx));
    view.hits.resize(view.pixels.size());
    view.edges.resize(view.pixels.size());
    const ViewTracer tracer(scene, camera, space, view);
    const int firstColumn = std::max(0, space.firstColumn) / sidePx * sidePx;
    const int lastColumn = std::min(camera.widthPx, space.lastColumn);
    const int blockRows = (camera.heightPx + sidePx - 1) / sidePx;
    tbb::parallel_for(tbb::blocked_range<int>(0, blockRows, 2), [&](const auto& rows) {
        for (int row = rows.begin(); row < rows.end(); ++row)
            for (int column = firstColumn; column < lastColumn; column += sidePx)
                tracer.traceBlock(column, row * sidePx);
    });
    // Edges are found first and marked then: a row reads the pixels of the rows beside it.
    for (const auto& work : {findEdges, markEdges})
        tbb::parallel_for(tbb::blocked_range<int>(0, camera.heightPx, 16), [&](const auto& rows) {
            for (int row = rows.begin(); row < rows.end(); ++row) work(view, row, firstColumn, lastColumn);
        });
}

}  // namespace noonmark
