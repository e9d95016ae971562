#pragma once

#include <span>
#include <vector>

#include "core/engines/horizon/cache/bin_edit.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

/// A receiver whose gaps may be others now, or hide others.
struct GapChange {
    std::uint32_t number;
    std::uint32_t added;  ///< suns that they hide more above the horizon, modulo 2^32
};

/// Brings the gaps of one azimuth up to date after the horizons there. They are found again where receivers
/// are new, where the horizon fell (gaps below it are not kept) and where parts went or came; elsewhere they
/// stay, but a horizon that rose hides more of them. One for each thread.
class GapEdit {
public:
    /// One azimuth as it is kept.
    struct Bin {
        glm::dvec2 away;
        HorizonCode lowest;
        std::span<const HorizonCode> codes;   ///< as they are now
        std::span<const CodeChange> changes;  ///< how they became so
        const HiddenSuns* hidden;             ///< of the period; null: it does not visit the bin
    };

    /// Returns what may have changed, a number perhaps twice; of new receivers all that is there now. Valid
    /// until the next call. Nothing where the period does not visit the bin.
    std::span<const GapChange> run(const TileEdit& edit, const Bin& bin, std::vector<Gap>& gaps);

private:
    enum State : std::uint8_t {
        untouched = 0,
        touched = 1,     ///< the horizon is another
        undoesLast = 2,  ///< to be found again
        fresh = 4,       ///< a new receiver
        gone = 8         ///< no receiver any more
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
    std::vector<std::uint8_t> states_;    // one a number
    std::vector<HorizonCode> before_;     // codes, of those touched
    std::vector<HorizonCode> horizons_;   // blind but for those found again
    std::vector<std::uint32_t> numbers_;  // not untouched
    OverhangList list_;
    std::vector<Gap> found_, merged_, rest_;
    std::vector<std::uint32_t> blocks_;  // with numbers that are not untouched; ascending
    /// Gaps [first, end) of a block, and where what replaces them ends in merged_.
    struct Rewritten {
        std::size_t first, end, mergedEnd;
    };
    std::vector<Rewritten> rewritten_;
    std::vector<GapChange> changes_;
};

}  // namespace noonmark
