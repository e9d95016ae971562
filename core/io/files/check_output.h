#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/files/output_kind.h"

namespace noonmark {

/// What may be written over.
struct OutputRules {
    /// Files that the output is made from; their companions (companionFiles) count too, and of a folder that
    /// is a data set all that lies in it. Names of files that are not there ("sample:grid") do no harm.
    std::vector<std::filesystem::path> inputs{};
    bool overwrite = false;  ///< a file of the kind that is written may be replaced
};

/// Whether a file may be written: it is not there, or rules.overwrite holds and it is of the kind. Never an
/// input, by whatever name or link; a project, unless a project is written; a file of another kind; a
/// folder, a pipe, a device, or a link that leads nowhere; a database that another program writes to. Error:
/// what stands in the way, where, what to do. Reads and writes nothing but heads of files that are there. Ask
/// before long work.
Result<void> checkOutput(const std::filesystem::path& file, OutputKind kind, const OutputRules& rules);

/// The same of files in one folder, which need not be there, by detectOutputKind(). What may never be
/// replaced comes first; else the Error says how many of the files are there.
Result<void> checkOutputs(const std::filesystem::path& folder, const std::vector<std::string>& names,
                          const OutputRules& rules);

/// Those of the names that the folder holds already.
std::vector<std::string> findExistingOutputs(const std::filesystem::path& folder,
                                             const std::vector<std::string>& names);

}  // namespace noonmark
