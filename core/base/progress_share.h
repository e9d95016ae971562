#pragma once

#include <cstddef>

#include "core/base/progress.h"

namespace noonmark {

/// Progress of one or more of several equal parts of a longer task: maps the fraction of the part to a
/// fraction of the whole task.
class ProgressShare final : public Progress {
public:
    /// Covers part `index` of `count`, or `parts` parts beginning with it. `whole` must outlive this object.
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
