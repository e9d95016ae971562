#pragma once

#include <QString>
#include <vector>

#include "core/study/study.h"
#include "core/study/text/error_words.h"

namespace noonmark {

/// A row of the results: name, value with unit, and meaning.
struct ResultRow {
    QString name;
    QString value;
    QString meaning;
};

/// The figures of a study, new or saved.
struct StudyFigures {
    ShadowStatistics statistics;
    bool instant = false;            ///< of one moment: no minutes
    std::uint64_t steps = 0;         ///< steps with the sun above the horizon
    std::uint64_t belowHorizon = 0;  ///< steps left out
    double sunlitMinutesPerDay = 0;
    std::uint64_t rays = 0;
    double seconds = 0;  ///< engine time; 0: not known
    std::string period;  ///< in words
    std::vector<ErrorLine> errors;
    std::string engine;
};

/// Adds how much of the region was left out as water; nothing for none.
void addWaterRow(std::vector<ResultRow>& rows, double waterM2);

/// The meaning of the row of steps: "Positions of the sun above the horizon; 312 below it were left out".
QString describeSteps(std::uint64_t belowHorizon);
std::vector<ResultRow> makeRows(const StudyFigures& figures);
std::vector<ResultRow> makeResultRows(const Study& study);

}  // namespace noonmark
