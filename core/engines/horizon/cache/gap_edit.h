#pragma once

#include <span>
#include <vector>

#include "core/engines/horizon/cache/bin_edit.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

/// A receiver whose gaps may have changed or may hide other suns.
struct GapChange {
    std::uint32_t number;
    std::uint32_t added;  ///< how many more suns they hide above the horizon, modulo 2^32
};

/// Updates the gaps of one azimuth after its horizons have been updated. Gaps are recomputed for new
/// receivers, where the horizon fell (gaps below it are not cached) and where overhangs were removed or
/// added. Elsewhere they stay, but a horizon that rose covers more of them. One per thread.
class GapEdit {
public:
    /// The cached data of one azimuth.
    struct Bin {
        glm::dvec2 away;
        HorizonCode lowest;
        std::span<const HorizonCode> codes;   ///< after the change
        std::span<const CodeChange> changes;  ///< how the codes changed
        const HiddenSuns* hidden;             ///< of the period; null: it does not visit the bin
    };

    /// Returns the receivers whose gaps may have changed, possibly with two entries for one number; for new
    /// receivers all hidden suns. Valid until the next call. Empty if the period does not visit the bin.
    std::span<const GapChange> run(const TileEdit& edit, const Bin& bin, std::vector<Gap>& gaps);

private:
    enum State : std::uint8_t {
        untouched = 0,
        touched = 1,  ///< the horizon changed
        stale = 2,    ///< gaps to be recomputed
        fresh = 4,    ///< a new receiver
        gone = 8      ///< no longer a receiver
    };

    void begin(const TileEdit& edit, const Bin& bin);
    void mark(std::uint32_t number, State state);
    void markHit(const TileEdit& edit, const Bin& bin, std::span<const OverhangShapes> shapes);
    [[nodiscard]] static OverhangView viewOf(const TileEdit& edit, const Bin& bin,
                                             std::span<const OverhangShapes* const> shapes);
    void add(const Bin& bin, std::span<const Gap> gaps, bool before);
    void recompute(const TileEdit& edit, const Bin& bin);
    using FoundGap = std::vector<Gap>::const_iterator;
    void findBlocks();
    void rewrite(const Bin& bin, std::span<const Gap> gaps, std::uint32_t block, FoundGap& found);
    void merge(std::span<const Gap> gaps, std::uint32_t end, FoundGap& found);
    void replace(std::vector<Gap>& gaps);
    void clear();

    OverhangSweep sweep_;
    std::vector<std::uint8_t> states_;    // one per number
    std::vector<HorizonCode> before_;     // previous codes, for touched numbers
    std::vector<HorizonCode> horizons_;   // blind except where gaps are recomputed
    std::vector<std::uint32_t> numbers_;  // numbers that are not untouched
    OverhangList list_;
    std::vector<Gap> found_, merged_, rest_;
    std::vector<std::uint32_t> blocks_;  // blocks with numbers that are not untouched; ascending
    /// The gaps [first, end) of a block, and the end of their replacement in merged_.
    struct Rewritten {
        std::size_t first, end, mergedEnd;
    };
    std::vector<Rewritten> rewritten_;
    std::vector<GapChange> changes_;
};

}  // namespace noonmark
