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

/// Watches the fields of a file whose names mean nothing to us, to list those that could be heights or
/// storeys. A few sums for every field.
class UnknownFields {
public:
    /// A value of a feature, as a number field has it or as text ("12,5 m").
    void add(const std::string& field, std::string_view text, std::optional<double> number);

    /// Fields of which all values over 0 could be heights (to 4,000, which are feet) or storeys, and no
    /// years, areas, codes or numbers of features; at most eight, those with the most values first.
    [[nodiscard]] std::vector<UnknownField> thatCouldBeHeights(const std::string& file) const;

private:
    struct Values {
        double low = 0;
        double high = 0;
        bool whole = true;
        bool odd = false;  // a text that is no length
        std::size_t above0 = 0;
        std::set<double> different;  // up to a number that is enough to tell
    };
    static bool couldBeHeights(const std::string& field, const Values& values);
    std::map<std::string, Values> fields_;
};

/// "no field of heights or storeys is known; ...": what a user can do about a file without heights.
Warning noKnownField(const std::vector<UnknownField>& unknown, const std::string& file);

}  // namespace noonmark
