#pragma once

#include <QString>
#include <stop_token>

#include "core/study/study.h"

namespace noonmark {

/// The expected cost of one field by the ray reference, and the time of the automatic engine, by the model
/// that chooses it (auto_engine.h).
struct RunEstimate {
    double rays = 0;
    double seconds = 0;
    double quickerSeconds = 0;
};

/// A run expected to take at least this many seconds is announced before it starts.
constexpr double longRunSeconds = 120;

/// Uses the receivers and steps of the study: takes about 0.1 s, or a second for a year in steps of a minute.
/// Error: the study's own refusal, or stopped.
Result<RunEstimate> estimateRays(const City& city, const StudySettings& settings,
                                 const std::stop_token& stop);

/// "about 40 s", "about 3 h", "about 12 days".
QString describeAbout(double seconds);

}  // namespace noonmark
