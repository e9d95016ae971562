#pragma once

#include <cstddef>

#include "core/base/progress.h"

namespace noonmark {

/// One or some of several equal parts of a longer work: its fraction is a share of the whole's.
class ProgressShare final : public Progress {
public:
    /// Part `index` of `count`, or `parts` from there on. `whole` must outlive it.
    ProgressShare(Progress& whole, std::size_t index, std::size_t count, std::size_t parts = 1)
        : whole_(whole), index_(index), count_(count), parts_(parts) {}

    void report(double fraction, std::string_view stage) override {
        whole_.report((double(index_) + fraction * double(parts_)) / double(count_), stage);
    }

private:
    Progress& whole_;
    std::size_t index_, count_, parts_;
};

}  // namespace noonmark
