#include "core/study/verification/result_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <map>
#include <system_error>

#include "core/describe/command_options.h"
#include "core/study/provenance/command_text.h"
#include "core/study/provenance/provenance.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

std::string textAt(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void addInputs(std::vector<RecordedFile>& files, const Json& record, const char* key, bool needed) {
    const auto inputs = record.find(key);
    if (inputs == record.end() || !inputs->is_array()) return;
    for (const Json& input : *inputs)
        if (input.is_object()) files.push_back({textAt(input, "path"), textAt(input, "sha256"), needed});
}

// Of a record, or of its part about one scenario.
void addSources(std::vector<RecordedFile>& files, const Json& record) {
    const auto project = record.find("project");
    const bool saved = project != record.end() && project->is_object() && !textAt(*project, "file").empty() &&
                       !textAt(*project, "file_sha256").empty();
    if (saved) files.push_back({textAt(*project, "file"), textAt(*project, "file_sha256")});
    addInputs(files, record, "inputs", !saved);
}

bool isSame(const RecordedFile& one, const RecordedFile& other) {
    return one.path == other.path && one.sha256 == other.sha256;
}

// Scenarios that were measured side by side have the same files, which are found once.
void addScenarioSources(std::vector<RecordedFile>& files, const Json& record) {
    const auto scenarios = record.find("scenarios");
    if (scenarios == record.end() || !scenarios->is_array()) return;
    std::vector<RecordedFile> all;
    for (const Json& one : *scenarios)
        if (one.is_object()) addSources(all, one);
    for (RecordedFile& file : all)
        if (std::ranges::none_of(files, [&](const RecordedFile& known) { return isSame(known, file); }))
            files.push_back(std::move(file));
}

std::vector<RecordedFile> filesOf(const Json& record) {
    std::vector<RecordedFile> files;
    addSources(files, record);
    addScenarioSources(files, record);
    addInputs(files, record, "windows_file", true);
    if (const auto elements = record.find("elements"); elements != record.end() && elements->is_object())
        addInputs(files, *elements, "windows", true);
    return files;
}

// The command may only read files of the folder in which it runs, and only write into `repeated` there.
bool leavesFolder(const std::string& word) {
    const std::string value = word.starts_with("--") ? word.substr(word.find('=') + 1) : word;
    return value.starts_with('/') || value.starts_with('\\') || value.starts_with('~') ||
           value.find("..") != value.npos || value.find(":/") != value.npos ||
           value.find(":\\") != value.npos;
}

// "sunrise+1h..sunset-1h" is no path.
bool isWindow(const std::string& word) {
    return (word.starts_with("sunrise") ||
            word.starts_with(std::string(flagOf(periodFields().rows(), "window")) + "=")) &&
           word.find_first_of("/\\") == word.npos;
}

// Into the project, which is the user's own file and no copy.
bool saves(const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    return name == flags::save || name == flags::keep || name == flags::overwrite;
}

Result<void> checkCommand(const std::vector<std::string>& words, const Commands& known,
                          const std::string& where) {
    const auto refuse = [&](const std::string& why) {
        return failure(fmt::format("The recorded command is not run: {}", why), where,
                       "Read the command in the report and run it yourself if you trust it");
    };
    if (words.size() < 2 || words[0] != "noonmark-cli" || std::ranges::find(known, words[1]) == known.end())
        return refuse(fmt::format("it is none of {}", fmt::join(known, ", ")));
    const auto out = std::ranges::find(words, std::string(flags::out));
    if (std::ranges::count_if(words, [](const auto& word) { return word.starts_with(flags::out); }) != 1 ||
        out == words.end() || std::next(out) == words.end() || *std::next(out) != "repeated")
        return refuse("it does not write into the folder 'repeated'");
    for (const std::string& word : words)
        if (saves(word) || (leavesFolder(word) && !isWindow(word)))
            return refuse(fmt::format("'{}' may reach or change files elsewhere", word));
    return {};
}

}  // namespace

Result<ResultRecord> parseResultRecord(const std::string& text, const Commands& known,
                                       const std::string& where) {
    ResultRecord record;
    record.json = Json::parse(text, nullptr, false);
    if (!record.json.is_object())
        return failure("This is not the record of a result", where,
                       "Give a report of Noonmark, or the record beside it, such as study.json");
    const std::string command = textAt(record.json, "repeat");
    if (command.empty()) {
        const std::string note = textAt(record.json, "repeat_note");
        return failure(
            "The record has no command that repeats the result" + (note.empty() ? "" : ": " + note), where,
            {});
    }
    auto words = splitCommand(command);
    if (!words) return tl::make_unexpected(words.error());
    if (auto may = checkCommand(*words, known, where); !may) return tl::make_unexpected(may.error());
    record.command = *std::move(words);
    record.files = filesOf(record.json);
    return record;
}

namespace {

namespace fs = std::filesystem;
using FilesByName = std::multimap<std::string, fs::path>;

constexpr std::size_t maxEntries = 100'000;

FilesByName listFiles(const fs::path& folder, const std::stop_token& stop) {
    FilesByName files;
    std::error_code error;
    std::size_t seen = 0;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (++seen > maxEntries || stop.stop_requested()) break;
        std::error_code ignored;
        if (entry->is_regular_file(ignored) || entry->is_directory(ignored))
            files.emplace(entry->path().filename().string(), entry->path());
    }
    return files;
}

// A recorded path may be one of another system.
std::string nameIn(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

FoundFile find(const RecordedFile& recorded, const FilesByName& files) {
    FoundFile found{recorded, {}, false};
    const auto [first, last] = files.equal_range(nameIn(recorded.path));
    for (auto file = first; file != last && !found.agrees; ++file) {
        const auto described = describeInputFile(file->second);
        found.agrees = described && described->sha256 == recorded.sha256;
        if (!found.path || found.agrees) found.path = file->second;
    }
    return found;
}

}  // namespace

std::vector<FoundFile> findInputs(const std::vector<RecordedFile>& files, const fs::path& folder,
                                  const std::stop_token& stop) {
    const FilesByName there = listFiles(folder, stop);
    std::vector<FoundFile> found;
    found.reserve(files.size());
    for (const RecordedFile& file : files) {
        const bool sample = file.sha256.empty() && file.path.starts_with("sample:");
        found.push_back(sample ? FoundFile{file, {}, true} : find(file, there));
    }
    return found;
}

void findInputsBeside(std::vector<FoundFile>& files, const fs::path& folder) {
    for (FoundFile& file : files) {
        const fs::path there = folder / nameIn(file.recorded.path);
        std::error_code ignored;
        if (file.agrees || !(fs::is_regular_file(there, ignored) || fs::is_directory(there, ignored)))
            continue;
        FoundFile other = find(file.recorded, {{there.filename().string(), there}});
        if (!file.path || other.agrees) file = std::move(other);
    }
}

bool areComplete(const std::vector<FoundFile>& files) {
    return std::ranges::all_of(files,
                               [](const FoundFile& file) { return file.agrees || !file.recorded.needed; });
}

}  // namespace noonmark
