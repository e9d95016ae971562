#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/heights/height_facts.h"

namespace noonmark {

/// Collects statistics on the fields with unknown names, to list those that could be heights or storeys.
/// Cost: a few sums per field.
class UnknownFields {
public:
    /// Adds a feature's value, as a number or as text ("12,5 m").
    void add(const std::string& field, std::string_view text, std::optional<double> number);

    /// Fields whose values over 0 could all be heights (up to 4,000, for feet) or storeys, and that are not
    /// years, areas, codes or feature numbers; at most eight, those with the most values first.
    [[nodiscard]] std::vector<UnknownField> thatCouldBeHeights(const std::string& file) const;

private:
    struct Values {
        double low = 0;
        double high = 0;
        bool whole = true;
        bool odd = false;  // a text that is not a length
        std::size_t above0 = 0;
        std::set<double> different;  // up to as many as are needed to decide
    };
    static bool couldBeHeights(const std::string& field, const Values& values);
    std::map<std::string, Values> fields_;
};

/// "no field of heights or storeys is known; ...": the advice for a file without heights.
Warning noKnownField(const std::vector<UnknownField>& unknown, const std::string& file);

}  // namespace noonmark
