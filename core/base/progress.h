#pragma once

#include <string_view>

namespace noonmark {

/// Receives the progress of long work. Passed together with a std::stop_token, which requests cancellation.
class Progress {
public:
    virtual ~Progress() = default;

    /// `fraction` of the stage done, 0 to 1; `stage` is shown to the user ("tracing rays").
    /// Called from any thread, several at a time; implementations must be thread-safe and quick.
    virtual void report(double fraction, std::string_view stage) = 0;
};

/// Discards all progress.
class NoProgress final : public Progress {
public:
    void report(double, std::string_view) override {}
};

}  // namespace noonmark
