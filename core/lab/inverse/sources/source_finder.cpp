#include "core/lab/inverse/sources/source_finder.h"

#include <array>
#include <vector>

#include "core/engines/ray/ray_reference.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

constexpr int packetSide = 4;  // in cells: rays of 4 x 4 neighbouring cells are the most coherent

/// Up to 16 positions of a block, close together.
struct Packet {
    struct Place {
        int major, lane;
    };
    std::array<Place, 16> places{};
    std::array<glm::vec3, 16> origins{};
    int count = 0;
};

class TracedInstant final : public SourceInstant {
public:
    TracedInstant(const RayScene& scene, const Lanes& lanes, glm::dvec3 towardsSun, float nearestHitM)
        : scene_(scene), lanes_(lanes), towardsSun_(towardsSun), nearestHitM_(nearestHitM) {}

    void fill(int block, LaneSources& sources, int into) const override {
        const FlushDenormals flush;
        clear(sources, into);
        std::vector<Occluder> occluders(std::size_t(16 * sources.levels));
        for (int major = 0; major < sources.majors; major += packetSide)
            for (int lane = 0; lane < Lanes::perBlock; lane += packetSide)
                trace(packetAt(block, major, lane), sources, into, occluders);
    }

private:
    static void clear(LaneSources& sources, int into) {
        for (std::size_t line = sources.line(into, 0); line < sources.line(into + 1, 0); ++line) {
            sources.heightM[line] = {};
            std::ranges::fill(sources.building[line].values, LaneSources::nobody);
        }
    }

    [[nodiscard]] Packet packetAt(int block, int firstMajor, int firstLane) const {
        Packet packet;
        for (int major = firstMajor; major < std::min(firstMajor + packetSide, lanes_.majors()); ++major)
            for (int lane = firstLane; lane < firstLane + packetSide; ++lane) {
                const int minor = lanes_.minor(block * Lanes::perBlock + lane, major);
                if (!lanes_.onGrid(minor)) continue;
                packet.places[std::size_t(packet.count)] = {major, lane};
                packet.origins[std::size_t(packet.count++)] =
                    placeRayOrigin({glm::vec2(centre(major, minor)), 0});
            }
        return packet;
    }

    [[nodiscard]] glm::dvec2 centre(int major, int minor) const {
        return lanes_.alongX() ? lanes_.grid().centre(major, minor) : lanes_.grid().centre(minor, major);
    }

    void trace(const Packet& packet, LaneSources& sources, int into, std::vector<Occluder>& occluders) const {
        if (packet.count == 0) return;
        scene_.firstOccluders(std::span(packet.origins).first(std::size_t(packet.count)),
                              glm::vec3(towardsSun_), nearestHitM_, sources.levels, occluders);
        for (int i = 0; i < packet.count; ++i)
            for (int level = 0; level < sources.levels; ++level) {
                const Occluder& occluder =
                    occluders[std::size_t(i) * std::size_t(sources.levels) + std::size_t(level)];
                const auto [major, lane] = packet.places[std::size_t(i)];
                const std::size_t line = sources.line(into, major, level);
                sources.heightM[line].values[lane] = occluder.distanceM * float(towardsSun_.z);
                sources.building[line].values[lane] =
                    occluder.distanceM > 0 ? occluder.building : LaneSources::nobody;
            }
    }

    const RayScene& scene_;
    const Lanes& lanes_;
    glm::dvec3 towardsSun_;
    float nearestHitM_;
};

}  // namespace

RaySourceFinder::RaySourceFinder(RayScene scene, const Grid& grid, int levels, float nearestHitM)
    : scene_(std::move(scene)), cells_(grid.size()), levels_(levels), nearestHitM_(nearestHitM) {}

std::unique_ptr<SourceInstant> RaySourceFinder::at(glm::dvec3 towardsSun, const Lanes& lanes) const {
    return std::make_unique<TracedInstant>(scene_, lanes, towardsSun, nearestHitM_);
}

}  // namespace noonmark
