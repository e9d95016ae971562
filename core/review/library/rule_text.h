#pragma once

#include <string>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/review/rule/rule.h"

namespace noonmark {

/// A rule for people: every figure with its status and source, the readings, and what is not checked. Lines
/// end with a newline.
std::string describeRule(const Rule& rule);

/// "V", "R" or "U": the least certain status (FigureStatus) among the figures that a verdict rests on.
FigureStatus findLeastCertain(const Rule& rule);

/// Which of those figures have that status: "the hours", "the limit of 'Longest shadow'".
std::vector<Sentence> listLeastCertain(const Rule& rule);
/// "Least certain of what the verdicts rest on: the hours, the clock (U: not checked against the rule's
/// text)."
std::string describeLeastCertain(const Rule& rule);

}  // namespace noonmark
