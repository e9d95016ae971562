#pragma once

#include "core/base/progress.h"

namespace noonmark::tests {

/// Records whether any reported fraction decreased or left the range 0 to 1.
struct GrowingProgress final : Progress {
    double last = 0;
    bool grew = true;
    void report(double fraction, std::string_view) override {
        grew = grew && fraction >= last && fraction <= 1;
        last = fraction;
    }
};

}  // namespace noonmark::tests
