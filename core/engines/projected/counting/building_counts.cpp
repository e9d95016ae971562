#include "core/engines/projected/counting/building_counts.h"

#include "core/engines/projected/filling/step_registers.h"

namespace noonmark {

namespace {

// The cells that are set at any of the steps.
template <class Register>
[[gnu::always_inline]] inline std::uint64_t atAnyStep(const EightWords<Register>& steps) {
    StepWords words;
    steps.store(words);
    std::uint64_t cells = 0;
    for (const std::uint64_t word : words.words) cells |= word;
    return cells;
}

}  // namespace

[[gnu::always_inline]] inline StepWords& CountTile::at(std::size_t plane, int row) const {
    return (*planes_[plane])[std::size_t(row)];
}

[[gnu::noinline]] void CountTile::addPlane() { planes_.push_back(std::make_unique<Plane>()); }

// A ripple-carry addition, which stops when the carry is empty.
template <class Register>
[[gnu::always_inline]] inline void CountTile::add(int row, const EightWords<Register>& come,
                                                  std::uint64_t& changed) {
    if (planes_.empty()) addPlane();
    const EightWords<Register> any(at(0, row));
    (any | come).store(at(0, row));
    EightWords<Register> carry = come & any;
    for (std::size_t k = 1; anySet(carry); ++k) {
        if (k == planes_.size()) addPlane();
        const EightWords<Register> plane(at(k, row));
        (plane ^ carry).store(at(k, row));
        carry = plane & carry;
    }
    changed |= atAnyStep(come & ~any);
}

template <class Register>
[[gnu::always_inline]] inline void CountTile::remove(int row, const EightWords<Register>& gone,
                                                     std::uint64_t& changed) {
    EightWords<Register> others = EightWords<Register>(StepWords{});
    for (std::size_t k = 1; k < planes_.size(); ++k) others = others | at(k, row);
    const EightWords<Register> ended = gone & ~others;
    EightWords<Register> borrow = gone & others;
    (at(0, row) & ~ended).store(at(0, row));
    for (std::size_t k = 1; anySet(borrow); ++k) {
        const EightWords<Register> plane(at(k, row));
        (plane ^ borrow).store(at(k, row));
        borrow = borrow & ~plane;
    }
    changed |= atAnyStep(ended);
}

void CountTile::change(int first, int end, const StepWords* gone, const StepWords* come,
                       std::uint64_t* changed) {
    runWithWidestRegisters([ =, this ](auto registers) __attribute__((always_inline)) {
        using Words = EightWords<decltype(registers)>;
        for (int row = first; row < end; ++row) {
            const Words before(gone[row]), after(come[row]);
            const Words less = before & ~after, more = after & ~before;
            if (anySet(less)) remove(row, less, changed[row]);
            if (anySet(more)) add(row, more, changed[row]);
        }
    });
}

}  // namespace noonmark
