#pragma once

#include <string>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/study/glazing/glazing_study.h"
#include "core/study/review_study.h"

namespace noonmark {

/// How many places, or windows after the change, have which verdict. Those of windows count them before it,
/// and how many get worse, too.
const Figures<VerdictCounts>& placeVerdictFigures();
const Figures<VerdictChanges>& glazingVerdictFigures();

VerdictCounts countVerdicts(const ReviewStudy& study);

/// A place that fails or is borderline, and why.
struct CriticalPlace {
    std::string name, reason;  ///< describeReason()
};
/// The places that fail, then those that are borderline.
std::vector<CriticalPlace> listDoubtful(const ReviewStudy& study);

/// The verdicts in sentences: how many places fail the rule in the scenario, and the first of them with their
/// reasons.
AnswerPage makeReviewPage(const VerdictCounts& counts, const std::string& rule, const std::string& scenario,
                          const std::vector<CriticalPlace>& doubtful);
/// The same of windows; `from`: the baseline.
AnswerPage makeGlazingPage(const VerdictChanges& changes, const std::string& rule, const std::string& from,
                           const std::string& scenario);

}  // namespace noonmark
