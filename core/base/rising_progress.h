#pragma once

#include <mutex>

#include "core/base/progress.h"

namespace noonmark {

/// Passes on only what is further than before: threads report out of order, and some work is done again.
class RisingProgress final : public Progress {
public:
    /// `whole` must outlive this object.
    explicit RisingProgress(Progress& whole) : whole_(whole) {}

    void report(double fraction, std::string_view stage) override {
        const std::lock_guard lock(mutex_);
        if (fraction <= last_) return;
        last_ = fraction;
        whole_.report(fraction, stage);
    }

private:
    Progress& whole_;
    std::mutex mutex_;
    double last_ = 0;
};

}  // namespace noonmark
