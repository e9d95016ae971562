#pragma once

#include <chrono>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/units.h"
#include "core/describe/figure.h"

namespace noonmark {

/// A number as people read it.
struct Amount {
    double value = 0;  ///< as FigureUnit says that it is held; NaN: not counted
    FigureUnit unit = FigureUnit::none;
    int decimals = 1;  ///< at most; areas have none
    bool isChange = false;
};

/// "4.3 h", "+1,204 m²", "not counted".
std::string valueOf(const Amount& amount, UnitSystem units = UnitSystem::metric);

/// A sentence about a result, which the GUI translates.
struct Sentence {
    using Argument = std::variant<std::string, Amount>;  ///< a name of the user's, or a number

    std::string_view source = {};  ///< NM_TEXT: "%1" to "%9" stand for the arguments. Empty: no sentence
    std::vector<Argument> arguments{};
};

/// The sentence in English, with a capital at its beginning.
std::string formatText(const Sentence& sentence, UnitSystem units = UnitSystem::metric);

/// Replaces "%1" by the first value and so on, each where it stands in `text`; values are not searched.
std::string fillIn(std::string_view text, std::span<const std::string> values);

/// What the bars of a single series show.
enum class BarTone {
    amount,
    sun,   ///< hours of sun, or what gets them
    gain,  ///< sun gained, or shade that is wanted
    loss,  ///< sun lost, or shadow that is unwanted
};

/// Bars in groups, one bar of each series: by month, or by class of a histogram.
struct Bars {
    /// A class of a histogram, in the unit of groupName; high is excluded.
    struct Class {
        double low = 0, high = 0;
        bool operator==(const Class&) const = default;
    };
    struct Group {
        std::variant<std::string, std::chrono::year_month, Class> name;
        std::vector<double> values;  ///< as many as series; NaN: no bar
        BarTone tone = BarTone::amount;
        bool operator==(const Group&) const = default;
    };
    std::string_view title = {};      ///< NM_TEXT, with its unit: "Hours of sun a day by month"
    std::string_view groupName = {};  ///< NM_TEXT: what the groups are, with its unit; empty: months
    std::vector<std::string> series{std::string()};  ///< names of scenarios; a single one may have none
    std::vector<Group> groups{};
    /// What each series has more than another one, which has no bars here: the first of the chart above.
    bool isChange = false;
    bool operator==(const Bars&) const = default;
};

/// What each further series has more than the first. Without groups where there is only one.
Bars changesOf(const Bars& bars, std::string_view title);

/// The first `maximum` series.
Bars firstSeries(Bars bars, std::size_t maximum);

/// "2026-01" of a month, "2 to 4" of a class.
std::string groupKey(const Bars::Group& group);

/// What an answer states, as data: the window, sheets and the command line draw it. Its map, figures and
/// settings are members of the answer itself.
struct AnswerPage {
    Sentence headline;                 ///< the answer in one sentence
    std::vector<Sentence> findings{};  ///< what else it says, most important first
    std::vector<Bars> charts{};
};

}  // namespace noonmark
