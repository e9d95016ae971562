#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/files/output_kind.h"

namespace noonmark {

/// Which existing files may be overwritten.
struct OutputRules {
    /// The files that the output is made from. Their companions (listCompanionFiles) count too, and for a
    /// folder that is a data set all files in it, which also gets no further ones. Names without a file
    /// ("sample:grid") are ignored.
    std::vector<std::filesystem::path> inputs{};
    bool overwrite = false;  ///< a file of the kind that is written may be replaced
};

/// Whether a file may be written: it does not exist, or rules.overwrite is set and the file is of the given
/// kind. Never overwritten: an input, under any name or link; a project, unless a project is written; a file
/// of another kind; a folder, a pipe, a device, or a dangling link; a database that another program is
/// writing to. The Error states the obstacle, its location and what to do. Writes nothing, and reads only the
/// beginnings of existing files. Call it before long work.
Result<void> checkOutput(const std::filesystem::path& file, OutputKind kind, const OutputRules& rules);

/// The same for several files in one folder, which need not exist; each file's kind is detectOutputKind() of
/// its name. A file that may never be replaced is reported first; otherwise the Error says how many of the
/// files exist.
Result<void> checkOutputs(const std::filesystem::path& folder, const std::vector<std::string>& names,
                          const OutputRules& rules);

/// The names that already exist in the folder.
std::vector<std::string> findExistingOutputs(const std::filesystem::path& folder,
                                             const std::vector<std::string>& names);

}  // namespace noonmark
