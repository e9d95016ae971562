#include "core/measures/mask_runs.h"

#include <algorithm>
#include <bit>
#include <tuple>
#include <vector>

namespace noonmark {

namespace {

// Words of a row that are searched together: with a day's minutes they stay in the first level of the cache.
constexpr std::size_t stripWords = 4;

/// Some words of all rows, of which a bit remains where a run of `length()` rows begins.
class StripRuns {
public:
    StripRuns(std::span<const BitRow> rows, std::size_t word, std::size_t words)
        : bits_(rows.size() * stripWords) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (rows[row].set == nullptr) continue;
            for (std::size_t i = 0; i < words; ++i) {
                const std::uint64_t unset = rows[row].unset == nullptr ? 0 : rows[row].unset[word + i];
                bits_[row * stripWords + i] = rows[row].set[word + i] & ~unset;
            }
        }
        any_ = std::ranges::any_of(bits_, [](std::uint64_t bits) { return bits != 0; });
    }

    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] std::size_t length() const { return length_; }

    /// Keeps runs of `length` rows only, or more precisely their beginnings.
    void keep(std::size_t length) {
        while (any_ && length_ < length) {
            const std::size_t by = std::min(length_, length - length_);
            any_ = extend(by, bits_);
            length_ += by;
        }
    }

    /// Keeps the longest runs. Some run must be there.
    void keepLongest() {
        while (tryExtending(length_)) {
        }
        for (std::size_t by = std::bit_floor(length_ - 1); by > 0; by /= 2) tryExtending(by);
    }

    /// The first run in the earliest row; `column` is counted from the first word of the strip.
    [[nodiscard]] ColumnRun first() const {
        const auto at =
            std::size_t(std::ranges::find_if(bits_, [](auto bits) { return bits != 0; }) - bits_.begin());
        return {at / stripWords, at % stripWords * 64 + std::size_t(std::countr_zero(bits_[at])), length_};
    }

private:
    // Writes where runs begin that are longer by some rows, at most length(). Returns whether there are any.
    bool extend(std::size_t by, std::vector<std::uint64_t>& longer) const {
        const std::size_t offset = by * stripWords,
                          common = bits_.size() > offset ? bits_.size() - offset : 0;
        longer.resize(bits_.size());
        std::uint64_t any = 0;
        for (std::size_t i = 0; i < common; ++i) any |= longer[i] = bits_[i] & bits_[i + offset];
        std::fill(longer.begin() + std::ptrdiff_t(common), longer.end(), 0);
        return any != 0;
    }

    bool tryExtending(std::size_t by) {
        if (!extend(by, longer_)) return false;
        bits_.swap(longer_);
        length_ += by;
        return true;
    }

    std::vector<std::uint64_t> bits_, longer_;  // by row
    std::size_t length_ = 1;
    bool any_ = false;
};

bool isBetter(const ColumnRun& run, const ColumnRun& than) {
    return std::tuple(than.length, run.row, run.column) < std::tuple(run.length, than.row, than.column);
}

}  // namespace

std::optional<ColumnRun> findLongestColumnRun(std::span<const BitRow> rows, std::size_t words) {
    std::optional<ColumnRun> longest;
    for (std::size_t word = 0; word < words; word += stripWords) {
        StripRuns runs(rows, word, std::min(stripWords, words - word));
        if (longest) runs.keep(longest->length);
        if (!runs.any()) continue;
        runs.keepLongest();
        ColumnRun run = runs.first();
        run.column += word * 64;
        if (!longest || isBetter(run, *longest)) longest = run;
    }
    return longest;
}

}  // namespace noonmark
