#pragma once

#include <chrono>
#include <mutex>
#include <optional>

#include "app/cli/base/command_line.h"
#include "core/base/progress.h"

namespace noonmark::cli {

/// Shows progress on one line that is rewritten in place if `err` is a terminal, otherwise nothing. The line
/// is cleared at the end.
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
