#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/engines/projected/filling/step_lanes.h"

namespace noonmark {

template <class Register>
struct EightWords;

/// How many buildings shade each of 64 x 64 cells at eight steps: a raster of the cells that any shades, and
/// bit by bit how many do so besides one. There are as many rasters as the darkest cell needs, of 4 kB each;
/// none where no shadow ever fell.
class CountTile {
public:
    static constexpr int rows = 64;

    /// Takes the shadow of one building away, which was added before, and adds another's; both may be empty.
    /// What both shade costs nothing. `gone`, `come`, `changed`: one a row of the tile, of which those of
    /// rows [first, end) are looked at. Adds the cells to `changed` that went into or out of shadow.
    void change(int first, int end, const StepWords* gone, const StepWords* come, std::uint64_t* changed);

    /// The cells of a row that are in shadow at each of the steps.
    [[nodiscard]] const StepWords& shaded(int row) const {
        return planes_.empty() ? lit : (*planes_[0])[std::size_t(row)];
    }

    [[nodiscard]] std::uint64_t bytes() const { return planes_.size() * sizeof(Plane); }

private:
    using Plane = std::array<StepWords, rows>;
    static constexpr StepWords lit{};
    template <class Register>
    void add(int row, const EightWords<Register>& come, std::uint64_t& changed);
    template <class Register>
    void remove(int row, const EightWords<Register>& gone, std::uint64_t& changed);
    [[nodiscard]] StepWords& at(std::size_t plane, int row) const;
    void addPlane();

    std::vector<std::unique_ptr<Plane>>
        planes_;  // any; then the bits of the number besides one, lowest first
};

}  // namespace noonmark
