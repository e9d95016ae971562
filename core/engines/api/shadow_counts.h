#pragma once

namespace noonmark {

/// What is counted of a period: the longest runs cost about as much as all the rest.
enum class ShadowCounts {
    gross,  ///< continuousMin is NaN everywhere
    grossAndRuns,
};

}  // namespace noonmark
