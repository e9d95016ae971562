#pragma once

#include "core/review/glazing/glazing_review.h"

namespace noonmark {

/// How many windows, or buildings, have which verdict.
struct VerdictCounts {
    std::size_t pass = 0, borderline = 0, fail = 0, notApplicable = 0, notChecked = 0;
    void add(Verdict verdict);
    [[nodiscard]] std::size_t judged() const { return pass + borderline + fail; }
    [[nodiscard]] std::size_t notJudged() const { return notApplicable + notChecked; }
    [[nodiscard]] std::size_t all() const { return judged() + notJudged(); }
};

/// How verdicts change from the baseline to the scenario.
struct VerdictChanges {
    VerdictCounts before, after;
    std::size_t worse = 0, better = 0;  ///< from pass to borderline or fail, ...; both verdicts are known
    void add(Verdict former, Verdict verdict);
};

/// Whether both verdicts are known and the later one is worse: from pass to borderline or fail, ...
bool isWorse(Verdict former, Verdict verdict);

/// A share of a building's units that must meet a criterion.
struct BuildingShare {
    std::size_t units = 0, meeting = 0, borderline = 0;  ///< of the units to which the criterion applies
    Verdict verdict = Verdict::notApplicable;
};

/// A rule's answer for the windows of one building.
struct BuildingReview {
    std::string id, name;  ///< empty: windows at no building
    VerdictChanges windows;
    std::vector<BuildingShare> shares, formerShares;  ///< by share of the rule
    Verdict verdict = Verdict::notApplicable, formerVerdict = Verdict::notApplicable;
};

/// Windows by building, in the order in which buildings occur. Where the rule demands shares, they decide a
/// building's verdict; else its worst window does. A share is counted: it is borderline only if it depends on
/// windows that are.
std::vector<BuildingReview> reviewBuildings(const Rule& rule, const std::vector<GlazingReview>& windows);

/// Windows whose verdict gets worse, then others that fail, borderline ones, and the rest.
std::vector<const GlazingReview*> sortWorstFirst(const std::vector<GlazingReview>& windows);

}  // namespace noonmark
