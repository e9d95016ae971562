#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace noonmark {

/// Sets of indices that are joined pair by pair. The lowest index of a set stands for it.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    }

    std::size_t of(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::size_t a, std::size_t b) {
        a = of(a), b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

    /// The members of each set, ascending; sets in the order of their first members.
    std::vector<std::vector<std::size_t>> list() {
        std::vector<std::vector<std::size_t>> sets;
        std::vector<std::size_t> numbers = number();
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i] == sets.size()) sets.emplace_back();
            sets[numbers[i]].push_back(i);
        }
        return sets;
    }

    /// The number of each index's set, from 0 in the order of their first members.
    std::vector<std::size_t> number() {
        std::vector<std::size_t> numbers(parent_.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < parent_.size(); ++i) numbers[i] = of(i) == i ? count++ : numbers[of(i)];
        return numbers;
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace noonmark
