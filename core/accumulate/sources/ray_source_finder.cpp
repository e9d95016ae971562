#include "core/accumulate/sources/ray_source_finder.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/accumulate/flush_denormals.h"
#include "core/accumulate/ray_reference.h"

namespace noonmark {

namespace {
constexpr int packetSide = 4;  // cells: rays of a square of 4 x 4 stay together best
}

RaySourceFinder::RaySourceFinder(RayScene scene, const Grid& grid, int levels, float nearestHitM)
    : scene_(std::move(scene)), grid_(grid), levels_(levels), nearestHitM_(nearestHitM) {
    for (int row = 0; row < grid.rows; row += packetSide)
        for (int column = 0; column < grid.columns; column += packetSide) {
            Packet packet;
            for (int y = row; y < std::min(row + packetSide, grid.rows); ++y)
                for (int x = column; x < std::min(column + packetSide, grid.columns); ++x)
                    packet.cells[std::size_t(packet.count++)] = std::uint32_t(grid.index(x, y));
            packets_.push_back(packet);
        }
}

void RaySourceFinder::find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) const {
    sources.levels = levels_;
    sources.steepestM = steepestOnASurface(towardsSun, grid_.cellM);
    sources.heightM.assign(std::size_t(levels_) * grid_.size(), 0);
    sources.building.assign(sources.heightM.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, packets_.size(), 64), [&](const auto& range) {
        if (stop.stop_requested()) return;
        const FlushDenormals flush;
        std::vector<Occluder> occluders(std::size_t(16 * levels_));
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            find(packets_[i], towardsSun, sources, occluders);
    });
}

void RaySourceFinder::find(const Packet& packet, glm::dvec3 towardsSun, ShadowSources& sources,
                           std::vector<Occluder>& occluders) const {
    std::array<glm::vec3, 16> origins;
    for (int i = 0; i < packet.count; ++i) {
        const std::uint32_t cell = packet.cells[std::size_t(i)];
        const int column = int(cell % std::uint32_t(grid_.columns)),
                  row = int(cell / std::uint32_t(grid_.columns));
        origins[std::size_t(i)] = rayOrigin({glm::vec2(grid_.centre(column, row)), 0});
    }
    scene_.firstOccluders(std::span(origins).first(std::size_t(packet.count)), glm::vec3(towardsSun),
                          nearestHitM_, levels_, occluders);
    for (int i = 0; i < packet.count; ++i)
        for (int level = 0; level < levels_; ++level) {
            const Occluder& occluder = occluders[std::size_t(i * levels_ + level)];
            const std::size_t at = std::size_t(level) * grid_.size() + packet.cells[std::size_t(i)];
            sources.heightM[at] = occluder.distanceM * float(towardsSun.z);
            sources.building[at] = occluder.building;
        }
}

}  // namespace noonmark
