#include "core/describe/answer_page.h"

#include <fmt/format.h>

namespace noonmark {

Bars changesOf(const Bars& bars, std::string_view title) {
    Bars changes{.title = title, .groupName = bars.groupName, .series = {}, .isChange = true};
    if (bars.series.size() < 2) return changes;
    changes.series.assign(bars.series.begin() + 1, bars.series.end());
    for (const Bars::Group& group : bars.groups) {
        Bars::Group& change = changes.groups.emplace_back(Bars::Group{group.name, {}, group.tone});
        for (std::size_t i = 1; i < group.values.size(); ++i)
            change.values.push_back(group.values[i] - group.values.front());
    }
    return changes;
}

Bars firstSeries(Bars bars, std::size_t most) {
    if (bars.series.size() <= most) return bars;
    bars.series.resize(most);
    for (Bars::Group& group : bars.groups) group.values.resize(most);
    return bars;
}

std::string groupKey(const Bars::Group& group) {
    if (const auto* text = std::get_if<std::string>(&group.name)) return *text;
    if (const auto* values = std::get_if<Bars::Class>(&group.name))
        return fmt::format("{:g} to {:g}", values->low, values->high);
    const auto* month = std::get_if<std::chrono::year_month>(&group.name);
    return fmt::format("{:04}-{:02}", int(month->year()), unsigned(month->month()));
}

}  // namespace noonmark
