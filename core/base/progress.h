#pragma once

#include <string_view>

namespace noonmark {

class PartialSink;  // core/engines/api/partial_field.h

/// Where long work says how far it is. Passed beside a std::stop_token, which says when to give up.
class Progress {
public:
    virtual ~Progress() = default;

    /// `fraction` of the stage done, 0 to 1; `stage` is shown to the user ("tracing rays").
    /// Called from any thread, several at a time; implementations must be thread-safe and quick.
    virtual void report(double fraction, std::string_view stage) = 0;

    /// Who shows running results, where anybody does; outlives the work.
    virtual PartialSink* partials() { return nullptr; }
};

/// For callers who do not look.
class NoProgress final : public Progress {
public:
    void report(double, std::string_view) override {}
};

}  // namespace noonmark
