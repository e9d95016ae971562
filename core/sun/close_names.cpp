#include "core/sun/close_names.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace noonmark {

namespace {

/// Lower case, with blanks as in the tz database.
std::string plain(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
        if (c == ' ') c = '_';
    }
    return result;
}

/// Levenshtein distance: letters to insert, delete or change.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, changed}));
        }
    }
    return row.back();
}

std::string_view lastPart(std::string_view name) { return name.substr(name.rfind('/') + 1); }

/// The distance between the two, if it is small for their length.
std::optional<std::size_t> nearness(std::string_view wanted, std::string_view candidate) {
    const std::size_t away = distance(wanted, candidate);
    if (away > std::max<std::size_t>(1, wanted.size() / 4)) return std::nullopt;
    return away;
}

}  // namespace

std::vector<std::string> findCloseNames(std::string_view text, const std::vector<std::string>& names,
                                        std::size_t most) {
    constexpr std::size_t longestName = 64;
    const std::string wanted = plain(text.substr(0, longestName));
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const std::string& name : names) {
        const std::string candidate = plain(name);
        const auto whole = nearness(wanted, candidate);
        const auto part = nearness(lastPart(wanted), lastPart(candidate));
        if (whole || part)
            ranked.emplace_back(std::min(whole.value_or(longestName), part.value_or(longestName)), name);
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<std::string> best;
    for (const auto& [away, name] : ranked) {
        if (best.size() < most) best.push_back(name);
    }
    return best;
}

}  // namespace noonmark
