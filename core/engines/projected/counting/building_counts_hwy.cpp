#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/projected/counting/building_counts_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/projected/counting/cached_band.h"
#include "core/simd/kernel.h"

// After kernel.h.
#include "core/engines/projected/filling/step_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

// A ripple-carry addition, which stops when the carry is empty.
HWY_INLINE void add(CountPlanes& planes, int row, const EightWords& added, std::uint64_t& changed) {
    const EightWords any(planes.at(0, row));
    (any | added).store(planes.at(0, row));
    EightWords carry = added & any;
    for (std::size_t k = 1; anySet(carry); ++k) {
        if (k == planes.count()) planes.add();
        const EightWords plane(planes.at(k, row));
        (plane ^ carry).store(planes.at(k, row));
        carry = plane & carry;
    }
    changed |= joinSteps(without(added, any));
}

HWY_INLINE void remove(CountPlanes& planes, int row, const EightWords& removed, std::uint64_t& changed) {
    EightWords others = EightWords(StepWords{});
    for (std::size_t k = 1; k < planes.count(); ++k) others = others | planes.at(k, row);
    const EightWords ended = without(removed, others);
    EightWords borrow = removed & others;
    without(planes.at(0, row), ended).store(planes.at(0, row));
    for (std::size_t k = 1; anySet(borrow); ++k) {
        const EightWords plane(planes.at(k, row));
        (plane ^ borrow).store(planes.at(k, row));
        borrow = without(borrow, plane);
    }
    changed |= joinSteps(ended);
}

}  // namespace

void changeCounts(CountPlanes& planes, int first, int end, const StepWords* removed, const StepWords* added,
                  std::uint64_t* changed) {
    for (int row = first; row < end; ++row) {
        const EightWords before(removed[row]), after(added[row]);
        const EightWords less = without(before, after), more = without(after, before);
        if (anySet(less)) remove(planes, row, less, changed[row]);
        if (!anySet(more)) continue;
        if (planes.count() == 0) planes.add();
        add(planes, row, more, changed[row]);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

void CountPlanes::add() { planes_.push_back(std::make_unique<Plane>()); }

NOONMARK_KERNEL(changeCounts);
void CountTile::change(int first, int end, const StepWords* removed, const StepWords* added,
                       std::uint64_t* changed) {
    NOONMARK_CALL(changeCounts)(planes_, first, end, removed, added, changed);
}

}  // namespace noonmark
#endif
