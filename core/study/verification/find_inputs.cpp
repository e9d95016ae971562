#include "core/study/verification/find_inputs.h"

#include <algorithm>
#include <map>
#include <string>
#include <system_error>

#include "core/study/provenance/provenance.h"

namespace noonmark {

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

bool areComplete(const std::vector<FoundFile>& files) {
    return std::ranges::all_of(files,
                               [](const FoundFile& file) { return file.agrees || !file.recorded.needed; });
}

}  // namespace noonmark
