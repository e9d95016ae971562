#include "app/cli/options/number_range.h"

#include <fmt/format.h>

namespace noonmark::cli {

CLI::Validator within(double lowest, double highest) {
    const auto trouble = [=](const std::string& text) -> std::string {
        double number = 0;
        if (CLI::detail::lexical_cast(text, number) && number >= lowest && number <= highest) return {};
        return fmt::format("{} is out of range: give {:g} to {:g}", text, lowest, highest);
    };
    return {trouble, fmt::format("{:g} to {:g}", lowest, highest)};
}

}  // namespace noonmark::cli
