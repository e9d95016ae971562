#include "core/io/files/check_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

#include "core/describe/command_flags.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/formats/format.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;

constexpr const char* anotherName = "Name another file";

// True if a plain file exists, false if nothing does. Error: something else exists.
Result<bool> isPlainFileThere(const fs::path& file) {
    std::error_code ignored;
    if (fs::symlink_status(file, ignored).type() == fs::file_type::not_found) return false;
    switch (fs::status(file, ignored).type()) {
        case fs::file_type::regular:
            return true;
        // Without permission to look there is none to write either; writing then reports it
        case fs::file_type::none:
            return false;
        case fs::file_type::not_found:
            return failure("This is a link to a file that does not exist", file.string(),
                           "Remove the link, or name another file");
        case fs::file_type::directory:
            return failure("A folder has this name", file.string(), anotherName);
        default:
            return failure("This is a pipe or a device, not a file", file.string(), "Name a file on a disk");
    }
}

bool isSame(const fs::path& one, const fs::path& other) {
    std::error_code ignored;
    return fs::equivalent(one, other, ignored);
}

bool liesInFolder(const fs::path& file, const fs::path& input) {
    std::error_code ignored;
    return fs::is_directory(input, ignored) && isSame(fs::absolute(file, ignored).parent_path(), input);
}

bool belongsTo(const fs::path& file, const fs::path& input) {
    if (liesInFolder(file, input)) return true;
    const auto companions = listCompanionFiles(input);
    return isSame(file, input) || std::ranges::any_of(companions, [&](const fs::path& companion) {
               return isSame(file, companion);
           });
}

Result<void> checkNoInput(const fs::path& file, const std::vector<fs::path>& inputs) {
    const auto input =
        std::ranges::find_if(inputs, [&](const fs::path& one) { return belongsTo(file, one); });
    if (input == inputs.end()) return {};
    std::string where = file.string();
    if (*input != file)
        where +=
            fmt::format(" ({} {})", isSame(file, *input) ? "the same file as" : "read with", input->string());
    return failure("This file is an input, which would be lost", where, anotherName);
}

// A folder that is a data set (a file geodatabase, Shapefiles) is hashed with all its files: with one more it
// would be another, and no result of it could be verified.
Result<void> checkNoInputFolder(const fs::path& file, const std::vector<fs::path>& inputs) {
    const auto input =
        std::ranges::find_if(inputs, [&](const fs::path& one) { return liesInFolder(file, one); });
    if (input == inputs.end()) return {};
    return failure("This folder is an input, which would be changed", input->string(), "Name another folder");
}

Result<void> checkNoProject(const fs::path& file, OutputKind kind) {
    if (kind == OutputKind::project) return {};
    const auto project = holdsProject(file);
    if (!project) return tl::make_unexpected(project.error());
    if (!*project) return {};
    return failure("This file is a Noonmark project, which would be lost", file.string(), anotherName);
}

Result<void> checkKind(const fs::path& file, OutputKind kind) {
    if (isOfKind(file, kind)) return {};
    return failure(fmt::format("There is a file of this name already, and it is not {}", describe(kind)),
                   file.string(), "Name another file, or remove this one first");
}

// SQLite would replay a journal of the old file into the new one.
Result<void> checkNoJournal(const fs::path& file, OutputKind kind) {
    const bool database = kind == OutputKind::geoPackage || kind == OutputKind::project;
    if (!database || !isBeingWritten(file)) return {};
    return failure("Another program is writing to this file, or was stopped while it did", file.string(),
                   "Close the file in that program, remove the journal beside it, or name another file");
}

Result<void> checkReplaceable(const fs::path& file, OutputKind kind, const OutputRules& rules) {
    return checkNoInput(file, rules.inputs)
        .and_then([&] { return checkNoProject(file, kind); })
        .and_then([&] { return checkKind(file, kind); });
}

std::string addOverwrite(const char* what, const char* other) {
    return fmt::format("Add {} to replace {}, or name another {}", flags::overwrite, what, other);
}

Result<void> areThere(const fs::path& folder, const std::vector<std::string>& names) {
    if (names.size() == 1)
        return failure("There is a file of this name already", (folder / names.front()).string(),
                       addOverwrite("it", "folder"));
    return failure(
        fmt::format("{} and {} more of the files to write exist already", names.front(), names.size() - 1),
        folder.string(), addOverwrite("them", "folder"));
}

}  // namespace

Result<void> checkOutput(const fs::path& file, OutputKind kind, const OutputRules& rules) {
    const auto there = isPlainFileThere(file);
    if (!there) return tl::make_unexpected(there.error());
    // Also where the old file is gone and only its journal was left behind.
    if (auto free = checkNoJournal(file, kind); !free) return free;
    if (!*there) return checkNoInputFolder(file, rules.inputs);
    if (auto may = checkReplaceable(file, kind, rules); !may || rules.overwrite) return may;
    return failure("There is a file of this name already", file.string(), addOverwrite("it", "file"));
}

Result<void> checkOutputs(const fs::path& folder, const std::vector<std::string>& names,
                          const OutputRules& rules) {
    OutputRules replacing = rules;
    replacing.overwrite = true;
    for (const std::string& name : names)
        if (auto may = checkOutput(folder / name, detectOutputKind(name), replacing); !may) return may;
    const auto there = findExistingOutputs(folder, names);
    return there.empty() || rules.overwrite ? Result<void>() : areThere(folder, there);
}

std::vector<std::string> findExistingOutputs(const fs::path& folder, const std::vector<std::string>& names) {
    std::vector<std::string> there;
    std::error_code ignored;
    std::ranges::copy_if(names, std::back_inserter(there),
                         [&](const std::string& name) { return fs::exists(folder / name, ignored); });
    return there;
}

}  // namespace noonmark
