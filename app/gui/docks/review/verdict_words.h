#pragma once

#include <QColor>
#include <QString>

#include "core/review/criteria/verdict.h"
#include "core/review/glazing/building_review.h"
#include "core/review/rule/rule.h"
#include "core/study/review_study.h"

namespace noonmark {

/// "✓ pass", "✗ fail", "≈ borderline": a verdict is told by its symbol and word as well as by its colour.
QString describeVerdict(Verdict verdict);
/// The same; "figures only" where the rule states no limit for the place.
QString describeVerdict(const PlaceReview& review);
/// "1 ✗ fail, 12 ✓ pass": the worst first, those without a place left out.
QString describeCounts(const VerdictCounts& counts);
/// Dark enough to be read on white, and told apart by people who do not see red and green apart.
QColor verdictColour(Verdict verdict);

/// "1 ✗ fail, 2 ✓ pass": the number of places of each verdict, the worst first.
QString describeVerdicts(const ReviewStudy& study);

/// How sure the figures of a rule are, in a sentence.
QString describeStatus(const Rule& rule);

}  // namespace noonmark
