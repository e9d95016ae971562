#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/accrual/depth_slice.h"
#include "core/engines/accrual/map_frame.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The cells of flat ground in the maps: on the plane itself, so each has its texel once and for all.
class GroundLookup {
public:
    GroundLookup(const Receivers& receivers, const MapFrame& frame, float biasM);

    /// Words that hold a bit for each receiver.
    [[nodiscard]] std::size_t words() const { return (texel_.size() + 63) / 64; }

    /// Bit i % 64 of shaded[i / 64]: something is more than the bias before receivers.cells[i]. Bits beyond
    /// the last are 0.
    void look(const DepthSlice& slice, std::span<std::uint64_t> shaded) const;

    /// Column and row of the texel that holds each receiver.
    [[nodiscard]] std::span<const std::uint32_t> texels() const { return texel_; }

private:
    float biasM_;
    std::vector<std::uint32_t> texel_;  // of DepthSlice::depth
};

}  // namespace noonmark
