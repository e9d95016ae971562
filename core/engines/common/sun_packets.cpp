#include "core/engines/common/sun_packets.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr std::size_t capacity = DirectionPacket::capacity;

DirectionPacket collectDirections(const SunStep* steps, std::size_t count) {
    DirectionPacket packet;
    packet.count = int(count);
    for (std::size_t lane = 0; lane < capacity; ++lane) {
        const glm::vec3 direction = steps[std::min(lane, count - 1)].direction;
        packet.x[lane] = direction.x;
        packet.y[lane] = direction.y;
        packet.z[lane] = direction.z;
    }
    return packet;
}

void markStart(std::vector<SunPacket>& packets, std::size_t step) {
    packets[step / capacity].starts |= 1U << unsigned(step % capacity);
}

}  // namespace

std::vector<SunPacket> packSteps(const SunSteps& sun) {
    const std::size_t count = sun.steps.size();
    std::vector<SunPacket> packets((count + capacity - 1) / capacity);
    for (std::size_t i = 0; i < packets.size(); ++i) {
        const std::size_t first = i * capacity;
        packets[i].directions =
            collectDirections(sun.steps.data() + first, std::min(capacity, count - first));
    }
    for (const SunDay& day : sun.days)
        if (day.count > 0) markStart(packets, day.first);
    for (std::size_t i = 1; i < count; ++i)
        if (sun.steps[i].slot != sun.steps[i - 1].slot + 1) markStart(packets, i);
    return packets;
}

}  // namespace noonmark
