#pragma once

#include <QIODevice>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/files/check_output.h"
#include "core/io/files/pending_file.h"

namespace noonmark {

/// Writes the content of a file to an open device; false if the write failed.
using WriteContent = std::function<bool(QIODevice&)>;

/// Writes the bytes unchanged.
WriteContent textContent(std::string content);

/// Creates the folder if missing and checks that it is writable. Call it before long computations, because
/// their files are written at the end.
Result<void> prepareFolder(const std::filesystem::path& folder);

/// Writes a set of files into a folder, which is created if missing: either all files or none. Files are
/// written under temporary names, and result() renames them; existing files are replaced only where
/// checkOutput() permits. After the first error nothing more is written.
class OutputFolder {
public:
    explicit OutputFolder(const std::filesystem::path& folder, OutputRules rules = {});

    void add(const std::string& name, const WriteContent& write);
    /// For writers that create the file themselves.
    void add(const std::string& name, const std::function<Result<void>(const std::filesystem::path&)>& write);

    /// Renames the files. Returns the paths written, or the first error.
    Result<std::vector<std::filesystem::path>> result() &&;

private:
    std::filesystem::path folder_;
    OutputRules rules_;
    std::vector<std::filesystem::path> files_;
    std::vector<std::unique_ptr<PendingFile>> pending_;
    Result<void> state_;
};

}  // namespace noonmark
