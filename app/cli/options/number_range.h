#pragma once

#include <CLI/CLI.hpp>

namespace noonmark::cli {

/// Accepts numbers from `lowest` to `highest`. CLI::Range would accept "nan".
CLI::Validator within(double lowest, double highest);

}  // namespace noonmark::cli
