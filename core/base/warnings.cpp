#include "core/base/warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/safe_text.h"

namespace noonmark {

std::string_view nameOf(WarningKind kind) {
    switch (kind) {
        case WarningKind::repaired:
            return "repaired";
        case WarningKind::clipped:
            return "clipped";
        case WarningKind::dropped:
            return "dropped";
        case WarningKind::leftOut:
            return "left out";
        case WarningKind::assumed:
            return "assumed";
    }
    return "unknown";
}

std::vector<WarningGroup> groupWarnings(const Warnings& warnings) {
    std::vector<WarningGroup> groups;
    std::map<std::pair<WarningKind, std::string_view>, std::size_t> groupOf;
    for (const Warning& warning : warnings) {
        const auto [place, isNew] = groupOf.try_emplace({warning.kind, warning.what}, groups.size());
        if (isNew) groups.push_back({warning.kind, warning.what, {}});
        groups[place->second].where.push_back(warning.where);
    }
    return groups;
}

std::string lineOf(const WarningGroup& group, std::size_t maximum) {
    const std::size_t shown = std::min(maximum, group.where.size());
    const std::vector<std::string> places(group.where.begin(), group.where.begin() + std::ptrdiff_t(shown));
    const char* rest = shown < group.where.size() ? ", ..." : "";
    return cleanText(fmt::format("{} {}: {} ({}{})", group.where.size(), nameOf(group.kind), group.what,
                                 fmt::join(places, ", "), rest));
}

}  // namespace noonmark
