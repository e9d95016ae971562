#pragma once

#include <string_view>

#include "core/review/rule/rule.h"

namespace noonmark {

enum class Verdict {
    pass,
    borderline,  ///< within the stated error of the limit
    fail,
    notApplicable,  ///< the rule states no limit, or does not cover this kind of place
    notChecked,     ///< the rule has a limit that could not be evaluated
};

/// "pass", "borderline", "fail", "not applicable", "not checked"
std::string_view nameOf(Verdict verdict);

/// A value and the range in which it lies by the stated error.
struct Measured {
    double value = 0, low = 0, high = 0;
};

/// Compares with a limit. Borderline if the range holds the limit, even where the value equals it exactly. A
/// value at the end of its scale is exact: no shadow at any step is at most 0, and a share of 1 of which no
/// spot is within the error is at least 1.
Verdict compareWith(Comparison comparison, double limit, const Measured& measured);

/// The value as a ratio to the former one. 0 / 0 counts as 1, any other value / 0 as infinite.
Measured ratioOf(const Measured& value, const Measured& former);

/// The former value minus this one.
Measured lossOf(const Measured& value, const Measured& former);

/// pass, borderline or fail: the first of these that is worse, or better.
Verdict worseOf(Verdict a, Verdict b);
Verdict betterOf(Verdict a, Verdict b);

}  // namespace noonmark
