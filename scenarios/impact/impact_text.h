#pragma once

#include <string>
#include <vector>

#include "scenarios/impact/impact_figures.h"

namespace noonmark {

/// An impact with the question that it answers, for files and kept results.
struct ImpactAnswer {
    std::string from;  ///< scenarios
    std::string to;
    ImpactSettings settings;
    std::vector<double> thresholdsMin{30, 60};  ///< Boston's rules ask for 60
    ImpactStudy study;
    Provenance provenance{};
};

/// The figures of an impact without its fields, as lists show them.
struct ComparisonFigures {
    struct NewBuilding {
        std::string name;       ///< or its id
        ImpactFigures figures;  ///< of the first threshold
    };
    std::string from;
    std::string to;
    std::vector<ImpactFigures> all;  ///< for every threshold
    std::vector<NewBuilding> byBuilding;
    std::string period;  ///< in words
    std::string engine;
};
ComparisonFigures computeFigures(const ImpactAnswer& answer);

/// The command that repeats it; see core/study/provenance/repeat_command.h.
Result<std::string> repeatCommand(const ImpactAnswer& answer, std::size_t width = 120);

/// Keys are stable, units in their names; figures for every threshold, of all and of each new building.
std::string impactJson(const ImpactAnswer& answer);

/// One line for all and each new building and every threshold, with a heading; RFC 4180.
std::string impactCsv(const ImpactAnswer& answer);

}  // namespace noonmark
