#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/describe/sentence.h"

namespace noonmark {

/// What bars of a single series stand for.
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

/// The first `most` series.
Bars firstSeries(Bars bars, std::size_t most);

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
