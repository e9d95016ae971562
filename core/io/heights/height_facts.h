#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/answer_page.h"

namespace noonmark {

/// A field that heights were read from; stated by info, study.json and reports.
struct HeightField {
    std::string file;          ///< file name, with the layer if there are several: "town.gpkg: houses"
    std::string field;         ///< "RelH2"; a difference of elevations: "AbsH2 - AbsHMin"
    std::string meaning;       ///< "base of the roof"; empty if the name does not say
    std::string unit;          ///< unit of numbers without a unit: "m", "ft"; or "storeys"
    std::size_t features = 0;  ///< number of features whose height came from it
    bool operator==(const HeightField&) const = default;
};

/// What an unknown field could hold, by its name and its values.
enum class FieldKind {
    heights,
    storeys,
    elevations,  ///< of roofs, above a datum: heights only where the ground lies near 0
    either,      ///< heights or storeys
};

/// A number field with an unknown name whose values could be heights or storeys.
struct UnknownField {
    std::string file;
    std::string field;
    double low = 0;  ///< smallest value over 0
    double high = 0;
    bool whole = false;        ///< all values are whole
    std::size_t features = 0;  ///< number of features with a value over 0
    FieldKind kind = FieldKind::either;
    std::string unit = {};  ///< of heights, as --height-unit takes it: "ft"; empty: metres or unknown
    bool operator==(const UnknownField&) const = default;
};

/// How the buildings of a file were placed on the terrain.
enum class StandRule {
    asStated,  ///< at the elevations that the file states
    shifted,   ///< all by the same height: the median gap
    setDown,   ///< each by the gap below it
};
/// "as stated", "shifted", "set down": the names used in files.
std::string_view nameOf(StandRule rule);
/// The rule of that name; nothing for any other text.
std::optional<StandRule> parseStandRule(std::string_view name);

/// The bases of a file's buildings, held against the terrain. The gap of a building is its base minus the
/// lowest ground under its outline.
struct BaseFit {
    std::string file;
    std::size_t buildings = 0;  ///< that state a base and do not stand on others
    double gapM = 0;            ///< median of the gaps, metres
    double spreadM = 0;         ///< of the gaps, between their quartiles
    StandRule rule = StandRule::asStated;
    std::size_t aloft = 0;  ///< buildings that stay above the ground: bridges, and what others carry
    std::size_t apart = 0;  ///< set down by themselves: their gap is far from that of the others
    /// Whether the median gap is within 1 m, or within the spread.
    [[nodiscard]] bool fits() const;
    /// Whether they were not simply left at the elevations that their file states.
    [[nodiscard]] bool isRemarkable() const;
    bool operator==(const BaseFit&) const = default;
};

/// A field of heights whose unit is doubtful.
struct HeightDoubt {
    std::string file;
    std::string field;
    std::string why;  ///< with the options that settle it
    bool operator==(const HeightDoubt&) const = default;
};

/// Where the heights and bases of a city's files come from.
struct HeightFacts {
    std::vector<HeightField> fields;    ///< fields that gave heights, those with the most features first
    std::vector<UnknownField> unknown;  ///< candidates in files where features have no height
    std::vector<HeightDoubt> doubts;    ///< units that were assumed but fit badly
    std::vector<BaseFit> bases;         ///< of each file that states bases, if there is a terrain
    bool operator==(const HeightFacts&) const = default;
};

/// "H_BAT (2.5 to 41.2 in 1,204 features)": for a list of fields that a user could choose from.
std::string describe(const UnknownField& field);

/// The options that select it: "--levels-field NUM", "--height-field H --height-unit ft"; one that could be
/// either has "--levels-field X or --height-field X".
std::string selectingOptions(const UnknownField& field);

/// "RelH2 (base of the roof), m: 1,204 features"
std::string describe(const HeightField& field);

/// "Bases of town.city.json lie 20 m above the terrain (median of 120, spread 0.1 m); all were shifted onto
/// it"
std::string describe(const BaseFit& fit);
std::vector<Sentence> listSentences(const BaseFit& fit);

/// "town.gpkg: height: half of its heights are over 1200 m as they are read, in metres; ..."
std::string describe(const HeightDoubt& doubt);

/// Formats 22133 as "22,133".
std::string formatThousands(std::size_t count);

}  // namespace noonmark
