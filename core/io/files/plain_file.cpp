#include "core/io/files/plain_file.h"

#include <algorithm>
#include <utility>

#include "core/base/stop_scope.h"

namespace noonmark {

Result<const Format*> detectFormat(const std::filesystem::path& file, Formats formats) {
    std::error_code ignored;
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (std::filesystem::is_directory(file, ignored)) return detectFormatWithGdal(file, formats);
    if (!std::ifstream(file, std::ios::binary))
        return failure("The file cannot be opened", file.string(), "Check that you may read it");
    FileHead head = readFileHead(file);
    if (head.bytes.empty()) return failure("The file is empty", file.string(), "Export or download it again");
    if (const auto known = refuseForeignFormat(file, formats); !known)
        return tl::make_unexpected(known.error());
    if (head.text().starts_with('{')) {
        StoppableStream stream(file);
        head.json = detectJsonKind(stream);
    }
    if (const Format* format = findReadFormat(head, formats)) return format;
    return detectFormatWithGdal(file, formats);
}

Result<FileKind> detectFileKind(const std::filesystem::path& file) {
    return detectFormat(file).map([](const Format* format) { return format->reader.kind; });
}

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

StoppableStream::StoppableStream(const std::filesystem::path& file, std::stop_token stop)
    : std::istream(static_cast<std::streambuf*>(this)),
      file_(file, std::ios::binary),
      stop_(std::move(stop)) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (!error) bytes_ = std::max<std::uintmax_t>(1, bytes);
}

std::streambuf::int_type StoppableStream::underflow() {
    if (stop_.stop_requested() || StopScope::isStopped()) return std::streambuf::traits_type::eof();
    file_.read(piece_.data(), std::streamsize(piece_.size()));
    const std::streamsize count = file_.gcount();
    if (count == 0) return std::streambuf::traits_type::eof();
    taken_ += std::uintmax_t(count);
    setg(piece_.data(), piece_.data(), piece_.data() + count);
    return std::streambuf::traits_type::to_int_type(*gptr());
}

}  // namespace noonmark
