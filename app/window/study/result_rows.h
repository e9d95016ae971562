#pragma once

#include <QString>
#include <vector>

#include "core/study/study.h"
#include "core/study/text/error_words.h"

namespace noonmark {

/// A line of the results: name, value with unit, and what it means.
struct ResultRow {
    QString name;
    QString value;
    QString meaning;
};

/// The figures of a study, whether it was just made or is a kept one.
struct StudyFigures {
    ShadowStatistics statistics;
    bool instant = false;            ///< of one moment: there are no minutes
    std::uint64_t steps = 0;         ///< of the sun above the horizon
    std::uint64_t belowHorizon = 0;  ///< left out
    double sunlitMinutesPerDay = 0;
    std::uint64_t rays = 0;
    double seconds = 0;  ///< that the engine took; 0: not known
    std::string period;  ///< in words
    std::vector<ErrorLine> errors;
    std::string engine;
};

std::vector<ResultRow> makeRows(const StudyFigures& figures);
std::vector<ResultRow> makeResultRows(const Study& study);

}  // namespace noonmark
