#pragma once

namespace noonmark {

/// Which quantities are computed for a period. The longest runs cost about as much as everything else
/// together.
enum class ShadowCounts {
    gross,  ///< continuousMin is NaN everywhere
    grossAndRuns,
};

}  // namespace noonmark
