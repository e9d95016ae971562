#pragma once

#include <CLI/CLI.hpp>

namespace noonmark::cli {

/// Takes numbers from `lowest` to `highest`. CLI::Range would let "nan" pass.
CLI::Validator within(double lowest, double highest);

}  // namespace noonmark::cli
