#pragma once

#include "app/gui/session/answers/result_rows.h"
#include "core/study/elements/element_tables.h"

namespace noonmark {

/// The figures of a study at points.
struct PointFigures {
    ElementFigures figures;
    std::size_t points = 0;
    double possibleMin = 0;  ///< minutes a day with the sun up
    std::uint64_t steps = 0, belowHorizon = 0;
    double seconds = 0;
    std::string period;  ///< in words
    std::string error;   ///< against rays, in words; empty: not measured
    bool byRays = false;
    std::string engine;  ///< in words, with what "auto" chose it for
};

std::vector<ResultRow> makeRows(const PointFigures& figures);
std::vector<ResultRow> makeElementRows(const ElementStudy& study);

}  // namespace noonmark
