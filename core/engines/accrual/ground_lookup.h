#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/accrual/depth_slice.h"
#include "core/engines/accrual/map_frame.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The cells of flat ground in the maps. They lie on the map's plane, so the texel of a cell is the same at
/// every step.
class GroundLookup {
public:
    GroundLookup(const Receivers& receivers, const MapFrame& frame, float biasM);

    /// Number of words with one bit per receiver.
    [[nodiscard]] std::size_t words() const { return (texel_.size() + 63) / 64; }

    /// Bit i % 64 of shaded[i / 64]: an occluder is closer to the sun than receivers.cells[i] by more than
    /// the bias. Bits after the last receiver are 0.
    void look(const DepthSlice& slice, std::span<std::uint64_t> shaded) const;

    /// Index in DepthSlice::depth of each receiver's texel.
    [[nodiscard]] std::span<const std::uint32_t> texels() const { return texel_; }

private:
    float biasM_;
    std::vector<std::uint32_t> texel_;  // indices in DepthSlice::depth
};

}  // namespace noonmark
