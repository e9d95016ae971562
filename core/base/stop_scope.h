#pragma once

#include <stop_token>

namespace noonmark {

/// Makes a stop token known to everything that runs on this thread until the end of the scope: to functions
/// that a library calls back without an argument, which then make the library give up. Scopes nest; one
/// without a token ends with those around it.
class StopScope {
public:
    explicit StopScope(std::stop_token stop = {});
    ~StopScope();
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

    /// Whether a stop was requested of a scope of this thread. What failed since is then no defect of the
    /// data.
    [[nodiscard]] static bool isStopped();
    /// The token of the innermost scope of this thread that has one, for scopes of the threads that help it.
    [[nodiscard]] static std::stop_token current();

private:
    std::stop_token stop_;
    const StopScope* outer_;
};

}  // namespace noonmark
