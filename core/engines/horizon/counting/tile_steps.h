#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/counting/longest_runs.h"

namespace noonmark {

/// Steps to be added to the sums of a tile, modulo 2^32, and the parts of 64 numbers that are affected.
struct TileSteps {
    std::vector<std::uint32_t> more;  ///< one per number
    std::vector<std::uint8_t> parts;

    explicit TileSteps(std::size_t numbers)
        : more(numbers), parts((numbers + lanesPerPart - 1) / lanesPerPart) {}
    void add(std::uint32_t number, std::uint32_t steps) {
        more[number] += steps;
        parts[number / lanesPerPart] = 1;
    }
};

}  // namespace noonmark
