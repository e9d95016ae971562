#pragma once

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark::bench {

/// Error of a field against the truth at the same receivers and steps; percent.
struct FieldError {
    double areaPct = 0;  ///< absolute difference of the shadow areas, % of the receivers' area
    /// Absolute difference of gross shadow, mean over the cells, % of the sunlit time
    double cellMeanPct = 0;
    double cellP99Pct = 0;  ///< 99 of 100 cells differ by less
    double cellMaxPct = 0;
    bool operator==(const FieldError&) const = default;
};

/// Over `receivers`, which may be a sample of those of the fields. O(n log n).
FieldError errorOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers);

}  // namespace noonmark::bench
