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

/// Writes a file's content into an open device; false when not all of it could be.
using WriteContent = std::function<bool(QIODevice&)>;

/// The bytes as they are.
WriteContent textContent(std::string content);

/// Makes the folder when it is missing, and checks that files can be made in it. Ask before long work: its
/// files come last.
Result<void> prepareFolder(const std::filesystem::path& folder);

/// The files of one piece of work, in a folder that is made when missing: all of them or none. Each is
/// written beside its place, and result() gives them their names; what lies there is replaced only where
/// checkOutput allows it. After the first error nothing more is written.
class OutputFolder {
public:
    explicit OutputFolder(const std::filesystem::path& folder, OutputRules rules = {});

    void add(const std::string& name, const WriteContent& write);
    /// For what writes files by itself.
    void add(const std::string& name, const std::function<Result<void>(const std::filesystem::path&)>& write);

    /// Gives the files their names: the paths written, or the first error.
    Result<std::vector<std::filesystem::path>> result() &&;

private:
    std::filesystem::path folder_;
    OutputRules rules_;
    std::vector<std::filesystem::path> files_;
    std::vector<std::unique_ptr<PendingFile>> pending_;
    Result<void> state_;
};

}  // namespace noonmark
