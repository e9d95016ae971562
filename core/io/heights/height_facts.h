#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace noonmark {

/// A field that heights were read from: a fact that info, study.json and reports state.
struct HeightField {
    std::string file;          ///< its name
    std::string field;         ///< "RelH2"; a difference of elevations: "AbsH2 - AbsHMin"
    std::string meaning;       ///< "base of the roof"; empty where its name does not say it
    std::string unit;          ///< of its bare numbers: "m", "ft"; or "storeys"
    std::size_t features = 0;  ///< whose height it gave
    bool operator==(const HeightField&) const = default;
};

/// A field of numbers whose name means nothing to us, and whose values could be heights or storeys.
struct UnknownField {
    std::string file;
    std::string field;
    double low = 0;  ///< of the values over 0
    double high = 0;
    bool whole = false;        ///< no value has decimals: storeys rather than heights
    std::size_t features = 0;  ///< with a value over 0
    bool operator==(const UnknownField&) const = default;
};

/// Where the heights of a city's files come from.
struct HeightFacts {
    std::vector<HeightField> fields;    ///< that gave heights, the most features first
    std::vector<UnknownField> unknown;  ///< of files in which features have no height
    bool operator==(const HeightFacts&) const = default;
};

/// "H_BAT (2.5 to 41.2 in 1,204 features)": for a list of fields that a user may name.
std::string describe(const UnknownField& field);

/// "RelH2 (base of the roof), m: 1,204 features"
std::string describe(const HeightField& field);

/// 22133 as "22,133".
std::string formatThousands(std::size_t count);

}  // namespace noonmark
