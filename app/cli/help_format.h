#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace noonmark::cli {

/// Help as the parser writes it, with the options that an option needs or excludes in alphabetical order. The
/// parser lists them by their addresses, so that two runs would print two orders.
class HelpFormat : public CLI::Formatter {
public:
    [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace noonmark::cli
