#pragma once

#include <chrono>
#include <mutex>
#include <optional>

#include "app/cli/console.h"
#include "core/base/progress.h"

namespace noonmark::cli {

/// Progress as one line that is written over and over, for a person who watches; silent for anyone else. The
/// line is wiped at the end.
class ProgressLine final : public Progress {
public:
    explicit ProgressLine(const Console& console) : console_(console) {}
    ~ProgressLine() override;
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void report(double fraction, std::string_view stage) override;

private:
    const Console& console_;
    std::mutex mutex_;
    std::optional<std::chrono::steady_clock::time_point> shown_;
};

}  // namespace noonmark::cli
