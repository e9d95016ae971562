#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/projected/counting/receiver_count.h"
#include "core/engines/projected/filling/caster_fill.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// What filling did, and did not need to do.
struct FillCount {
    std::uint64_t rows = 0;        ///< of eight steps each
    std::uint64_t outOfReach = 0;  ///< casters x steps whose shadow meets no receiver of a band
    FillCount& operator+=(const FillCount& other);
};

/// Fills the rasters of the sun's steps over some rows of a grid. One for each thread.
class StepFiller {
public:
    StepFiller(const ShadowCasters& casters, const ReceiverCount& where, const Receivers& receivers,
               const SunSteps& sun, const RowBand& band);

    /// The rasters of eight steps from `first` on (convex_fill.h); what was in them goes. Beyond the period
    /// they are as at its last step. Cells that are no receivers are set from the start: what falls on them
    /// only need not be filled. Steps in time order cost least.
    void fill(std::size_t first, std::span<std::uint64_t> rasters);

    [[nodiscard]] const BitLayout& layout() const { return layout_; }  ///< of the band
    [[nodiscard]] std::span<const std::uint64_t> noReceivers() const { return noReceivers_; }
    [[nodiscard]] const FillCount& count() const { return count_; }

private:
    using Indices = std::vector<std::uint32_t>;
    void reach(const StepOffsets& throws, const Indices& among, Indices& inReach) const;

    const ShadowCasters& casters_;
    const ReceiverCount& where_;
    const SunSteps& sun_;
    RowBand band_;
    BitLayout layout_;
    double cellM_;
    std::vector<std::uint64_t> noReceivers_;  // raster
    CasterFill caster_;
    Indices everInReach_, inReach_;  // at any step; at the eight
    FillCount count_;
};

/// Rows of a grid in bands whose rasters stay in the first-level cache, and some for each core.
std::vector<RowBand> bandsOf(const Grid& grid);

}  // namespace noonmark
