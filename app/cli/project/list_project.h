#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/base/change_project.h"

namespace noonmark::cli {

/// One entry of a list.
struct Listed {
    std::string name;
    std::string about;            ///< description for the user
    nlohmann::ordered_json json;  ///< the description as a JSON object, without the name
};
using Lister = std::vector<Listed> (*)(const Project&);

/// Adds the command `list`, which prints one kind of the project's contents.
void addListCommand(CLI::App& group, const char* about, Lister lister, Run& run);

/// Options of the command `remove`.
struct RemoveOptions {
    ChangeOptions change;
    std::vector<std::string> names;
};

/// Removes the named entries from the list. Error: an unknown name, as reported by `named`.
template <class List, class NameOf, class Named>
Result<std::string> removeNamed(List& list, const std::vector<std::string>& names, NameOf nameOf,
                                Named named) {
    std::string words;
    for (const std::string& name : names) {
        if (const auto known = named(name); !known) return tl::make_unexpected(known.error());
        std::erase_if(list, [&](const auto& one) { return nameOf(one) == name; });
        words += name + ": removed\n";
    }
    return words;
}

/// Adds the command `remove`.
void addRemoveCommand(CLI::App& group, const char* about,
                      Result<std::string> (*remove)(const RemoveOptions&, Project&), Run& run);

}  // namespace noonmark::cli
