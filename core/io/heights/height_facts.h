#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace noonmark {

/// A field that heights were read from; stated by info, study.json and reports.
struct HeightField {
    std::string file;          ///< file name
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

/// The fields that the heights of a city's files come from.
struct HeightFacts {
    std::vector<HeightField> fields;    ///< fields that gave heights, those with the most features first
    std::vector<UnknownField> unknown;  ///< candidates in files where features have no height
    bool operator==(const HeightFacts&) const = default;
};

/// "H_BAT (2.5 to 41.2 in 1,204 features)": for a list of fields that a user could choose from.
std::string describe(const UnknownField& field);

/// The options that select it: "--levels-field NUM", "--height-field H --height-unit ft"; one that could be
/// either has "--levels-field X or --height-field X".
std::string selectingOptions(const UnknownField& field);

/// "RelH2 (base of the roof), m: 1,204 features"
std::string describe(const HeightField& field);

/// Formats 22133 as "22,133".
std::string formatThousands(std::size_t count);

}  // namespace noonmark
