#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cctype>
#include <fstream>
#include <memory>
#include <optional>
#include <system_error>

#include "core/study/study.h"

namespace noonmark {

namespace {

using Digest = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

std::string hex(const unsigned char* bytes, unsigned count) {
    std::string text;
    for (unsigned i = 0; i < count; ++i) text += fmt::format("{:02x}", bytes[i]);
    return text;
}

std::optional<std::string> sha256Of(std::istream& file) {
    const Digest digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    if (!digest || EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) != 1) return std::nullopt;
    std::vector<char> piece(1 << 20);
    while (file.read(piece.data(), std::streamsize(piece.size())) || file.gcount() > 0)
        if (EVP_DigestUpdate(digest.get(), piece.data(), std::size_t(file.gcount())) != 1)
            return std::nullopt;
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned length = 0;
    if (file.bad() || EVP_DigestFinal_ex(digest.get(), sum.data(), &length) != 1) return std::nullopt;
    return hex(sum.data(), length);
}

std::vector<std::string> companionsOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& letter : extension) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    if (extension == ".shp") return {".dbf", ".shx", ".prj", ".cpg"};
    if (extension == ".gltf") return {".bin"};
    if (extension == ".asc" || extension == ".tif" || extension == ".tiff") return {".prj", ".tfw"};
    return {};
}

}  // namespace

Result<InputFile> inputFile(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    const auto sum = !error && file ? sha256Of(file) : std::nullopt;
    if (!sum)
        return failure("The file cannot be read", path.string(), "Check its name and that you may read it");
    return InputFile{path, bytes, *sum};
}

Result<std::vector<InputFile>> inputFiles(const std::filesystem::path& path) {
    auto main = inputFile(path);
    if (!main) return tl::make_unexpected(main.error());
    std::vector<InputFile> files{*std::move(main)};
    for (const std::string& extension : companionsOf(path)) {
        auto companion = inputFile(std::filesystem::path(path).replace_extension(extension));
        if (companion) files.push_back(*std::move(companion));
    }
    return files;
}

}  // namespace noonmark
