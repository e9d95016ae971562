#include "core/review/criteria/verdict.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/describe/text.h"

namespace noonmark {

namespace {

// In the order of Verdict.
constexpr std::array<std::string_view, 5> verdictNames{NM_TEXT("pass"), NM_TEXT("borderline"),
                                                       NM_TEXT("fail"), NM_TEXT("not applicable"),
                                                       NM_TEXT("not checked")};

double quotient(double value, double former) {
    if (former > 0) return value / former;
    return value > 0 ? std::numeric_limits<double>::infinity() : 1;
}

Verdict compareLow(double limit, const Measured& measured) {
    if (measured.high < limit || (limit == 0 && measured.high == 0)) return Verdict::pass;
    return measured.low > limit ? Verdict::fail : Verdict::borderline;
}

Verdict compareHigh(double limit, const Measured& measured) {
    if (measured.low > limit || (limit == 1 && measured.low == 1)) return Verdict::pass;
    return measured.high < limit ? Verdict::fail : Verdict::borderline;
}

}  // namespace

std::string_view nameOf(Verdict verdict) { return verdictNames.at(std::size_t(verdict)); }

Verdict compareWith(Comparison comparison, double limit, const Measured& measured) {
    const bool low = comparison == Comparison::atMost || comparison == Comparison::below;
    return low ? compareLow(limit, measured) : compareHigh(limit, measured);
}

Measured ratioOf(const Measured& value, const Measured& former) {
    return {quotient(value.value, former.value), quotient(value.low, former.high),
            quotient(value.high, former.low)};
}

Measured lossOf(const Measured& value, const Measured& former) {
    return {former.value - value.value, former.low - value.high, former.high - value.low};
}

Verdict worseOf(Verdict a, Verdict b) { return std::max(a, b); }
Verdict betterOf(Verdict a, Verdict b) { return std::min(a, b); }

}  // namespace noonmark
