#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/project/change_project.h"

namespace noonmark::cli {

/// One line of a list.
struct Listed {
    std::string name;
    std::string about;            ///< for people
    nlohmann::ordered_json json;  ///< what `about` says, beside the name; an object
};
using Lister = std::vector<Listed> (*)(const Project&);

/// Adds `list`, which says what the project has of something.
void addListCommand(CLI::App& group, const char* about, Lister lister, Run& run);

/// Options of `remove`.
struct RemoveOptions {
    ChangeOptions change;
    std::vector<std::string> names;
};

/// Takes those of the names out of the list. Error: a name that is not there, as `named` says it.
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

/// Adds `remove`.
void addRemoveCommand(CLI::App& group, const char* about,
                      Result<std::string> (*remove)(const RemoveOptions&, Project&), Run& run);

}  // namespace noonmark::cli
