#pragma once

#include <QString>
#include <stop_token>

#include "core/study/study.h"

namespace noonmark {

/// What one field by the ray reference is expected to cost, and how long the engine that is picked by itself
/// would take: the model that picks it (auto_engine.h).
struct RunEstimate {
    double rays = 0;
    double seconds = 0;
    double quickerSeconds = 0;
};

/// From so many seconds on a run is announced before it starts.
constexpr double longRunSeconds = 120;

/// Receivers and steps are those of the study: some 0.1 s, of a year by the minute a second. Error: what the
/// study itself would be refused for, or stopped.
Result<RunEstimate> estimateRays(const City& city, const StudySettings& settings,
                                 const std::stop_token& stop);

/// "about 40 s", "about 3 h", "about 12 days".
QString describeAbout(double seconds);

}  // namespace noonmark
