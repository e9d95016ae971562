#pragma once

#include <QIODevice>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/files/check_output.h"
#include "core/io/files/write_text.h"

namespace noonmark {

/// Writes the content of a file to an open device; false if the write failed.
using WriteContent = std::function<bool(QIODevice&)>;

/// Writes the bytes unchanged.
WriteContent textContent(std::string content);

/// Creates the folder if missing and checks that it is writable. Call it before long computations, because
/// their files are written at the end.
Result<void> prepareFolder(const std::filesystem::path& folder);

/// Writes a set of files into a folder, which is created if missing: either all files or none. Existing files
/// are replaced only where checkOutput() permits.
class OutputFolder {
public:
    /// Creates a file at this path.
    using WriteFile = std::function<Result<void>(const std::filesystem::path&)>;

    explicit OutputFolder(const std::filesystem::path& folder, OutputRules rules = {});

    /// Adds a file, whose name OutputRules::renamed may change. result() calls the writer, on any thread:
    /// what it refers to must live until then.
    void add(const std::string& name, WriteContent write);
    /// For writers that create the file themselves.
    void add(const std::string& name, WriteFile write);

    /// Adds a text that is written after all other files, made from the seconds that each of them took.
    using Durations = std::map<std::string, double>;
    void addLast(const std::string& name, std::function<std::string(const Durations&)> makeText);

    /// Writes the files side by side on all cores, under temporary names, and then gives them their own.
    /// Returns the paths in the order in which they were added, or the error of the first file that failed;
    /// then no file is left.
    Result<std::vector<std::filesystem::path>> result() &&;

private:
    struct File {
        std::string name;
        WriteFile write;
        bool last = false;
        double seconds = 0;
    };
    Result<void> writeAll(std::deque<PendingFile>& pending, bool last);
    [[nodiscard]] Result<void> writeFile(const File& file, const PendingFile& to) const;

    std::filesystem::path folder_;
    OutputRules rules_;
    std::vector<File> files_;
    Result<void> state_;
};

}  // namespace noonmark
