#include "core/io/files/plain_file.h"

namespace noonmark {

Result<void> checkPlainFile(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
        return failure("There is no such file", file.string());
    if (error)
        return failure("The file cannot be opened", file.string(),
                       "Check that you have permission to read it");
    if (std::filesystem::is_regular_file(status) || std::filesystem::is_directory(status)) return {};
    return failure("This is a pipe or a device, not a file", file.string(),
                   "Save its output to a file, and name that file");
}

Result<void> checkNoLink(const std::filesystem::path& fileOrFolder) {
    std::error_code ignored;
    const auto status = std::filesystem::symlink_status(fileOrFolder, ignored);
    if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status) ||
        std::filesystem::is_directory(status))
        return {};
    return failure("This is a link, a pipe or a device, which Noonmark never makes here",
                   fileOrFolder.string(), "Remove it if you do not know where it leads");
}

}  // namespace noonmark
