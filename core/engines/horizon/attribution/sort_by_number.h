#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace noonmark {

/// Sorts by the receiver's number, and the items of one receiver by `less`. Uses a counting sort where that
/// is less work: O(items + numbers). Reuses its memory.
template <class T>
class NumberSort {
public:
    /// `numbers`: upper limit of all numbers. `numberOf(item)`: its number.
    template <class NumberOf, class Less>
    void run(std::vector<T>& items, std::size_t numbers, const NumberOf& numberOf, const Less& less) {
        if (items.size() < numbers / 8) {
            std::sort(items.begin(), items.end(), [&](const T& a, const T& b) {
                return numberOf(a) != numberOf(b) ? numberOf(a) < numberOf(b) : less(a, b);
            });
            return;
        }
        distribute(items, numbers, numberOf);
        std::uint32_t first = 0;
        for (std::size_t number = 0; number < numbers; first = ends_[number++])
            sortFew(items.begin() + first, items.begin() + ends_[number], less);
    }

private:
    template <class NumberOf>
    void distribute(std::vector<T>& items, std::size_t numbers, const NumberOf& numberOf) {
        ends_.assign(numbers + 1, 0);
        for (const T& item : items) ++ends_[numberOf(item) + 1];
        for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
        sorted_.resize(items.size());
        for (const T& item : items) sorted_[ends_[numberOf(item)]++] = item;
        std::swap(items, sorted_);
    }

    // A receiver has only a handful of items.
    static void sortFew(auto first, auto end, const auto& less) {
        if (end - first > 32) return std::sort(first, end, less);
        for (auto item = first; item != end; ++item)
            std::rotate(std::upper_bound(first, item, *item, less), item, item + 1);
    }

    std::vector<std::uint32_t> ends_;  // end of each number's items
    std::vector<T> sorted_;
};

}  // namespace noonmark
