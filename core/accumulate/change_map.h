#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/accumulate/lanes.h"
#include "core/accumulate/shadow_lines.h"
#include "core/accumulate/source_runs.h"

namespace noonmark {

/// The cells of a grid at which some source of shadow begins or ends on the way along their lane: most cells
/// are shaded by what shades the one before. All cores.
class ChangeMap {
public:
    /// `rule`: cellsPerMetre is negative where shadows move against the lanes.
    ChangeMap(const Grid& grid, const Lanes& lanes, const ShadowSources& sources, const RunRule& rule);

    /// Whether the sources of this cell do not simply go on from the one before it on the lane (in the order
    /// of major positions).
    [[nodiscard]] bool at(std::size_t cell) const { return changed_[cell] != 0; }

    /// body(i) for every i of 0 .. count - 1 with at(first + i), in order. Eight cells at a time: few change.
    template <class Body>
    void forEachFrom(std::size_t first, std::size_t count, const Body& body) const {
        for (std::size_t i = 0; i < count; i += 8) {
            std::uint64_t marks = 0;
            std::memcpy(&marks, &changed_[first + i], std::min<std::size_t>(8, count - i));
            if (marks == 0) continue;
            for (std::size_t k = i; k < std::min(i + 8, count); ++k)
                if (at(first + k)) body(k);
        }
    }

private:
    void markRow(int row);
    void compare(int row, int fromRow, int shift, std::uint8_t* changed) const;

    const Grid& grid_;
    const Lanes& lanes_;
    const ShadowSources& sources_;
    RunRule rule_;
    std::vector<std::uint8_t> changed_;
};

}  // namespace noonmark
