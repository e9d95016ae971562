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

/// Name that ReadSettings::heightField takes for the highest Z of each outline, where no field has heights.
inline constexpr const char* outlineZ = "outline Z";

/// What a comparison with the other fields of a sample of features says about a field.
struct FieldEvidence {
    std::optional<double> perStorey;  ///< median of its values for each storey of a known field
    bool followsFootprint = false;    ///< it grows with the area of the footprints: an area or a length
};

/// Collects statistics on the fields with unknown names, to list those that could be heights or storeys.
/// Cost: a few sums per field.
class UnknownFields {
public:
    /// Adds a feature's value, as a number or as text ("12,5 m").
    void add(const std::string& field, std::string_view text, std::optional<double> number);

    /// What is known of a field besides its values.
    void compare(const std::string& field, const FieldEvidence& evidence) { evidence_[field] = evidence; }

    /// Fields whose values over 0 could all be heights (up to 4,000, for feet) or storeys, and that are not
    /// years, areas, codes, notes on quality or feature numbers, by name, values and evidence; at most eight,
    /// those whose name says heights or storeys first, then those with the most values.
    [[nodiscard]] std::vector<UnknownField> listPossibleHeights(const std::string& file) const;

private:
    struct Values {
        double low = 0;
        double high = 0;
        bool whole = true;
        bool halves = true;  // multiples of 0.5: storeys may be
        bool odd = false;    // a text that is not a length
        std::size_t above0 = 0;
        std::set<double> different;  // up to as many as are needed to decide
    };
    [[nodiscard]] bool couldBeHeights(const std::string& field, const Values& values) const;
    [[nodiscard]] UnknownField describeField(const std::string& file, const std::string& field,
                                             const Values& values) const;
    [[nodiscard]] FieldEvidence evidenceOf(const std::string& field) const;
    std::map<std::string, Values> fields_;
    std::map<std::string, FieldEvidence> evidence_;
};

/// How the advice for a file without heights begins.
inline constexpr std::string_view noFieldKnown = "no field of heights or storeys is known";

/// "no field of heights or storeys is known; ...": the advice for a file without heights.
Warning noKnownField(const std::vector<UnknownField>& unknown, const std::string& file);

}  // namespace noonmark
