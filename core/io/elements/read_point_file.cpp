#include "core/io/elements/read_point_file.h"

#include <fstream>
#include <iterator>

#include "core/io/files/plain_file.h"

namespace noonmark {

Result<std::vector<ListedPoint>> readPointFile(const std::filesystem::path& file) {
    constexpr std::uintmax_t maxBytes = 16'000'000;
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    std::error_code failed;
    if (std::filesystem::file_size(file, failed) > maxBytes || failed)
        return failure("It is not a list of points", file.string(), "Give a CSV file of up to 16 MB");
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) return failure("It cannot be read", file.string(), "Check its permissions");
    return parsePointList(text, file.filename().string());
}

}  // namespace noonmark
