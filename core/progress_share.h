#pragma once

#include <cstddef>

#include "core/progress.h"

namespace noonmark {

/// One of several equal parts of a longer work: its fraction is a share of the whole's.
class ProgressShare final : public Progress {
public:
    /// Part `index` of `count`. `whole` must outlive it.
    ProgressShare(Progress& whole, std::size_t index, std::size_t count)
        : whole_(whole), index_(index), count_(count) {}

    void report(double fraction, std::string_view stage) override {
        whole_.report((double(index_) + fraction) / double(count_), stage);
    }

private:
    Progress& whole_;
    std::size_t index_, count_;
};

}  // namespace noonmark
