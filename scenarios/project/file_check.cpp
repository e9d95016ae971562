#include "scenarios/project/file_check.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "core/base/process.h"
#include "core/io/files/own_files.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;
using Head = std::array<unsigned char, 100>;

tl::unexpected<Error> damaged(const fs::path& file, const std::string& how) {
    return failure(fmt::format("The project file is damaged ({})", how), file.string(),
                   "Take a copy of it, or the recovery file beside it; this file was not changed");
}

std::uint64_t number(const Head& head, std::size_t at, int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8U | head[at + std::size_t(i)];
    return value;
}

// SQLite file format, section 1.3: page size (offset 16), change counter (24), page count (28), and the
// change counter for which the page count is valid (92).
Result<void> checkLength(const Head& head, const fs::path& file, std::uintmax_t size) {
    const std::uint64_t stated = number(head, 16, 2);
    const std::uint64_t pageBytes = stated == 1 ? 65536 : stated;
    const bool counts = number(head, 24, 4) == number(head, 92, 4);
    if (!counts || size >= number(head, 28, 4) * pageBytes) return {};
    return damaged(file, "its end is missing");
}

}  // namespace

Result<void> checkWhole(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) return failure("There is no such file", file.string(), "Check its name");
    if (!fs::is_regular_file(file, error))
        return failure("It is not a file", file.string(), "Give the path of a project file");
    if (auto harmless = checkBeside(file); !harmless) return harmless;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return failure("The project file cannot be read", file.string(), "Check its permissions");
    Head head{};
    stream.read(reinterpret_cast<char*>(head.data()), head.size());
    constexpr std::string_view magic("SQLite format 3\0", 16);
    const std::string_view begin(reinterpret_cast<const char*>(head.data()), magic.size());
    if (stream.gcount() == 0) return damaged(file, "it is empty");
    if (begin != magic)
        return failure("It is not a Noonmark project", file.string(),
                       "Choose a file that ends in .noonmark.gpkg");
    if (stream.gcount() < std::streamsize(head.size())) return damaged(file, "its end is missing");
    if (fs::exists(file.string() + "-journal", error)) return {};
    return checkLength(head, file, fs::file_size(file, error));
}

Result<void> checkWritable(const fs::path& file) {
    std::error_code error;
    const fs::perms anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    const bool marked = (fs::status(file, error).permissions() & anyWrite) == fs::perms::none;
    if (!fs::exists(file, error))
        return failure("The project file no longer exists", file.string(), "Save it under another name");
    if (!marked && mayWrite(file)) return {};
    return failure("The project file is read-only", file.string(), "Save it under another name");
}

}  // namespace noonmark
