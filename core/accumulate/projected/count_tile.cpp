#include "core/accumulate/projected/count_tile.h"

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

// The cells that change at any of the steps.
[[gnu::always_inline]] inline std::uint64_t atAnyStep(const StepBits& steps) {
    std::uint64_t cells = 0;
    for (std::size_t k = 0; k < stepsTogether; ++k) cells |= steps[k];
    return cells;
}

}  // namespace

[[gnu::always_inline]] inline StepBits& CountTile::at(std::size_t plane, int row) const {
    return reinterpret_cast<StepBits&>((*planes_[plane])[std::size_t(row)]);
}

[[gnu::noinline]] void CountTile::addPlane() { planes_.push_back(std::make_unique<Plane>()); }

// Ripple carry: as far as it goes.
[[gnu::always_inline]] inline void CountTile::add(int row, const StepBits& come, std::uint64_t& changed) {
    if (planes_.empty()) addPlane();
    StepBits& any = at(0, row);
    const StepBits begun = come & ~any;
    StepBits carry = come & any;
    any |= come;
    for (std::size_t k = 1; anySet(carry); ++k) {
        if (k == planes_.size()) addPlane();
        StepBits& plane = at(k, row);
        const StepBits both = plane & carry;
        plane ^= carry;
        carry = both;
    }
    changed |= atAnyStep(begun);
}

[[gnu::always_inline]] inline void CountTile::remove(int row, const StepBits& gone, std::uint64_t& changed) {
    StepBits others{};
    for (std::size_t k = 1; k < planes_.size(); ++k) others |= at(k, row);
    const StepBits ended = gone & ~others;
    StepBits borrow = gone & others;
    at(0, row) &= ~ended;
    for (std::size_t k = 1; anySet(borrow); ++k) {
        StepBits& plane = at(k, row);
        const StepBits lacking = borrow & ~plane;
        plane ^= borrow;
        borrow = lacking;
    }
    changed |= atAnyStep(ended);
}

NOONMARK_EVERY_ISA void CountTile::change(int first, int end, const StepWords* gone, const StepWords* come,
                                          std::uint64_t* changed) {
    for (int row = first; row < end; ++row) {
        const StepBits &before = reinterpret_cast<const StepBits&>(gone[row]),
                       &after = reinterpret_cast<const StepBits&>(come[row]);
        const StepBits less = before & ~after, more = after & ~before;
        if (anySet(less)) remove(row, less, changed[row]);
        if (anySet(more)) add(row, more, changed[row]);
    }
}

}  // namespace noonmark
