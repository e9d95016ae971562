#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure_text.h"
#include "core/measures/legend_choice.h"
#include "core/sun/stated_period.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/impact/proposal_region.h"

namespace noonmark {

/// An impact with its settings, for files and saved results.
struct ImpactAnswer {
    std::string from;  ///< scenario of the city before
    std::string to;
    ImpactSettings settings;
    ImpactStudy study;
    Provenance provenance{};
    City proposal{};  ///< the buildings that only the city after has; empty: not known, or none
    City removed{};   ///< those that only the city before has, likewise
    std::optional<BeyondRegion> beyond{};  ///< findBeyond() of this answer, once it was found
};

/// The figures of an impact without its fields, for lists in the window.
struct ComparisonFigures {
    struct NewBuilding {
        std::string name;       ///< or its id where it has no name
        ImpactFigures figures;  ///< for the first threshold
    };
    std::string from;
    std::string to;
    std::vector<ImpactFigures> all;  ///< one per threshold
    std::vector<NewBuilding> byBuilding;
    StatedPeriod period;
    std::string engine;
    double waterM2 = 0;                ///< of the region, left out
    std::vector<ShownError> errors{};  ///< of the changes of a cell; none: not measured
};
ComparisonFigures computeFigures(const ImpactAnswer& answer);

/// The page of a comparison: how much sun the scenario takes or gives, on average and at most, over how much
/// area, and how the area divides into minutes. O(cells).
AnswerPage makePage(const Impact& impact, const ComparisonFigures& figures, ShownAs show = ShownAs::shadow);
/// The same of the column of trees that a legend shows, if it was measured.
AnswerPage makePage(const ImpactAnswer& answer, const LegendChoice& shown);

/// The comparison with trees of a column; that without trees where none reaches a receiver.
const Impact& impactOfColumn(const ImpactStudy& study, TreeColumns column);

/// The lines of a comparison for tables and sheets: the change of the shadow area, the change of gross and
/// continuous shadow over each threshold, that of gross shadow in the whole, and what was compared.
std::vector<FigureLine> listLines(const ComparisonFigures& figures, ShownAs show = ShownAs::shadow);
/// The areas of gross shadow over the threshold.
std::vector<FigureLine> listThresholdLines(const ImpactFigures& figures);

/// One entry of `impact` in impact.json.
nlohmann::ordered_json figuresJson(const ImpactFigures& figures);

/// The command line that repeats this impact; see core/study/provenance/repeat_command.h.
Result<std::string> makeRepeatCommand(const ImpactAnswer& answer, std::size_t width = 120);

/// Stable keys with their units; figures per threshold for the total and for each new building.
std::string impactJson(const ImpactAnswer& answer);

/// A heading and one line per threshold for the total and for each new building; RFC 4180.
std::string impactCsv(const ImpactAnswer& answer);

}  // namespace noonmark
