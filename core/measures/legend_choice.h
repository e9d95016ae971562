#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/command_options.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/palette.h"
#include "core/measures/shown_quantity.h"

namespace noonmark {

struct ShadowStatistics;

std::span<const Choice<Ramp>> rampChoices();        ///< from much sun to much shadow
std::span<const Choice<Ramp>> changeRampChoices();  ///< around zero

/// The shadows that one map can show of a result with trees: all but TreeColumns::all.
constexpr std::span<const Choice<TreeColumns>> mappedTreeChoices() {
    return std::span(treeColumnChoices).subspan(1);
}

/// The values of the two ends of a scale, in the unit shown.
struct LegendRange {
    double low = 0;
    double high = 0;
    bool operator==(const LegendRange&) const = default;
};
std::string formatText(LegendRange range);  ///< "0:8"
/// Error: no two numbers of which the second is larger.
Result<LegendRange> parseLegendRange(std::string_view text);

/// How values become colours.
struct LegendClasses {
    static constexpr int minCount = 2;
    static constexpr int maxCount = 12;
    enum class Kind {
        continuous,
        equal,      ///< `count` classes of equal width
        quantiles,  ///< `count` classes of about as many cells each
        breaks,     ///< classes between the numbers that the user typed; one number: two colours
    };
    Kind kind = Kind::continuous;
    int count = 5;
    std::vector<double> breaks{};  ///< ascending, in the unit shown; only of Kind::breaks
    bool operator==(const LegendClasses&) const = default;
};
std::string formatText(LegendClasses classes);  ///< "continuous", "equal:5", "quantiles:4", "2,4,6"
/// Error: neither of these.
Result<LegendClasses> parseLegendClasses(std::string_view text);

/// What a user chose for the legends of maps: of minutes, and around zero, of differences and scores.
struct LegendChoice {
    ShownAs show = ShownAs::shadow;
    Ramp ramp = Ramp::noonmark;
    bool reversed = false;               ///< dark where the ramp is bright
    std::optional<LegendRange> range{};  ///< unset: fitted to each map
    LegendClasses classes{};
    Ramp changeRamp = Ramp::greenBrown;  ///< of differences and scores
    bool changeReversed = false;
    LegendClasses changeClasses{};             ///< breaks: of differences in minutes, of scores in theirs
    TreeColumns trees = TreeColumns::without;  ///< which shadow maps show where trees reach; never `all`
    bool operator==(const LegendChoice&) const = default;
};

/// Flags --show, --ramp, --reverse-ramp, --range, --classes, --change-ramp, --reverse-change-ramp,
/// --change-classes, --map-trees. No result depends on them.
const Fields<LegendChoice>& legendFields();

/// The options that state what a command would draw otherwise without them: of a map of minutes, or of one
/// around zero.
std::vector<CommandOption> listLegendOptions(const LegendChoice& choice, bool aroundZero);

/// The choice as the JSON of its fields that differ from their default, and back: what is not valid there
/// stays as it is in LegendChoice{}.
std::string formatText(const LegendChoice& choice);
LegendChoice parseLegendChoice(const std::string& text);

/// The choice with range and breaks in the unit of `as`, so that each cell keeps its class.
LegendChoice showAs(const LegendChoice& choice, ShownAs as, double sunlitMin);

/// What a field says (core/measures/shadow_figures.h) of the column of trees that a legend shows, if the
/// field has it. `statistics`: those without trees.
AnswerPage makePage(const ShadowField& field, const ShadowStatistics& statistics, const std::string& where,
                    const LegendChoice& shown);
/// A sentence that names the column of what a page says.
Sentence nameColumn(TreeColumns trees);

}  // namespace noonmark
