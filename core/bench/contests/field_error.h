#pragma once

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark::bench {

/// How far a field is from the truth on the same receivers and steps; percent.
struct FieldError {
    double areaPct = 0;      ///< difference of the shadow areas, absolute, of the receivers' area
    double cellMeanPct = 0;  ///< mean over the cells of the difference of gross shadow, of the sunlit time
    double cellP99Pct = 0;   ///< 99 of 100 cells are nearer
    double cellMaxPct = 0;
    bool operator==(const FieldError&) const = default;
};

/// Over `receivers`, which may be a sample of those of the fields. O(n log n).
FieldError errorOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers);

}  // namespace noonmark::bench
