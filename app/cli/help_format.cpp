#include "app/cli/help_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace noonmark::cli {

namespace {

std::string listOptions(const std::string& label, const std::set<CLI::Option*>& options) {
    std::set<std::string> names;
    for (const CLI::Option* option : options) names.insert(option->get_name());
    return names.empty() ? std::string() : fmt::format(" {}: {}", label, fmt::join(names, " "));
}

}  // namespace

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
    const std::string text = CLI::Formatter::make_option_opts(option);
    if (!option->get_option_text().empty()) return text;
    const std::string needs = get_label("Needs"), excludes = get_label("Excludes");
    const auto lists = std::min(text.find(" " + needs + ":"), text.find(" " + excludes + ":"));
    return text.substr(0, lists) + listOptions(needs, option->get_needs()) +
           listOptions(excludes, option->get_excludes());
}

}  // namespace noonmark::cli
