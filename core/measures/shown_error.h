#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/measures/error_sample.h"

namespace noonmark {

/// A displayed quantity whose error is measured.
struct ErrorFacts {
    std::string_view key;    ///< of JSON: "place_mean"
    std::string_view label;  ///< NM_TEXT: "Mean sun of a place"
    FigureUnit unit = FigureUnit::minutesADay;
};

/// How far one displayed quantity is off the ray reference, on a sample, in the unit of its facts.
struct ShownError {
    ErrorFacts facts;
    std::string of;         ///< what of several it is about, a date; empty: there is only one
    double mean = 0;        ///< of the absolute differences
    double p99 = 0;         ///< 99 of 100 differ by no more
    double largest = 0;     ///< NaN: of a single total
    std::size_t count = 0;  ///< values compared
};

/// The quantity with this key, which must be in the table.
const ErrorFacts& findErrorFacts(std::string_view key);

/// The error from absolute differences, at least one. O(n).
ShownError sumUpError(std::string_view key, std::vector<double> off, std::string of = {});

/// The error of a sum over an area, from a sample of it: the mean of the signed differences and, as 99 of
/// 100, that with 2.58 standard errors of it, both times `size`. At least one difference.
ShownError sumUpTotalError(std::string_view key, std::span<const double> differences, double size);

/// Gross and longest shadow of a cell, or their changes.
std::vector<ShownError> listErrors(const SampledError& error, bool ofChange);

/// "0.02 min"; "< 0.001 min"; "" of NaN: how far off something is, as tables state it.
std::string formatDifference(double difference, FigureUnit unit);

/// "Mean sun of a place", with what it is of: "Mean sun of a place, 2026-12-21"
std::string labelOf(const ShownError& error);
/// "0.02 min a day in the mean, 99 of 100 within 0.1 min a day, at most 0.2 min a day"
Sentence describe(const ShownError& error);

/// A list; read back without quantities that are not known.
nlohmann::ordered_json errorsJson(std::span<const ShownError> errors);
/// Reads errorsJson(); a missing member gives none. Throws nlohmann's exceptions for JSON of another
/// structure.
std::vector<ShownError> parseErrors(const nlohmann::ordered_json& json);

}  // namespace noonmark
