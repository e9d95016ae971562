#include "app/cli/verify/repeat_run.h"

#include <fmt/format.h>

#include <sstream>
#include <system_error>

#include "app/cli/base/command_line.h"

namespace noonmark::cli {

namespace {

namespace fs = std::filesystem;

/// Changes the working folder for its lifetime: the recorded command names files without their folders.
class WorkingFolder {
public:
    explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
    ~WorkingFolder() {
        std::error_code ignored;
        fs::current_path(before_, ignored);
    }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
    fs::path before_;
};

std::string nameOf(const RecordedFile& file) { return file.path.substr(file.path.find_last_of("/\\") + 1); }

// A link where the system permits it; files of a city may have gigabytes.
Result<void> place(const fs::path& file, const fs::path& at) {
    std::error_code error;
    fs::create_symlink(fs::absolute(file), at, error);
    if (error) fs::copy_file(file, at, error);
    if (error) return failure("The file cannot be placed beside the others", file.string(), error.message());
    return {};
}

}  // namespace

Result<RepeatFolder> RepeatFolder::make(const std::vector<FoundFile>& files) {
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    RepeatFolder folder{PrivateFolder(temporary)};
    const fs::path& path = folder.folder_.path();
    if (error || path.empty())
        return failure("The folder for the repeated run cannot be made", temporary.string(),
                       "Check the folder for temporary files (TMPDIR)");
    for (const FoundFile& file : files) {
        if (!file.path) continue;
        const fs::path at = path / nameOf(file.recorded);
        if (fs::exists(at))
            return failure("Two recorded files have the same name", nameOf(file.recorded),
                           "Run the recorded command by hand with paths that distinguish them");
        if (auto placed = place(*file.path, at); !placed) return tl::make_unexpected(placed.error());
    }
    return folder;
}

Result<void> RepeatFolder::add(const fs::path& file) const {
    const fs::path at = folder_.path() / file.filename();
    return fs::exists(at) ? Result<void>() : place(file, at);
}

Result<void> RepeatFolder::run(const std::vector<std::string>& words, const Console& console) const {
    std::vector<const char*> argv;
    argv.reserve(words.size());
    for (const std::string& word : words) argv.push_back(word.c_str());
    std::ostringstream out, err;
    const WorkingFolder there(folder_.path());
    const int code = runCommandLine(int(argv.size()), argv.data(),
                                    {out, console.watched ? console.err : err, console.watched});
    if (code == exitCancelled) return cancelled();
    if (code == exitOk) return {};
    return failure(fmt::format("The recorded command fails: {}", err.str()), "repeat",
                   "The record may come from another version of Noonmark");
}

}  // namespace noonmark::cli
