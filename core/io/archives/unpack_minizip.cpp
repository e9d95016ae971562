#include <fmt/format.h>
#include <unzip.h>

#include <array>
#include <memory>

#include "core/base/safe_text.h"
#include "core/io/archives/unpack_archive.h"

namespace noonmark {

namespace {

constexpr const char* damagedZipAdvice = "Pack or download it again";

struct CloseZip {
    void operator()(void* zip) const { unzClose(zip); }
};
using Zip = std::unique_ptr<void, CloseZip>;

struct ZipEntry {
    std::string name;
    bool isEncrypted = false;
};

Result<ZipEntry> readEntry(unzFile zip) {
    constexpr std::size_t longest = 1024;
    std::array<char, longest> name{};
    unz_file_info64 info{};
    if (unzGetCurrentFileInfo64(zip, &info, name.data(), name.size(), nullptr, 0, nullptr, 0) != UNZ_OK)
        return failure("The archive is damaged", {}, damagedZipAdvice);
    if (info.size_filename >= longest)
        return failure("The archive holds a file with a very long name", {}, damagedZipAdvice);
    return ZipEntry{std::string(name.data(), info.size_filename), (info.flag & 1U) != 0};
}

// Folders, and what computers by Apple put beside the files.
bool isPassedOver(const std::string& name) {
    return name.empty() || name.ends_with('/') || name.starts_with("__MACOSX/");
}

Result<void> copyEntry(unzFile zip, UnpackedFile& file, const std::stop_token& stop) {
    std::array<char, 1U << 16U> bytes{};
    for (;;) {
        if (stop.stop_requested()) return cancelled();
        const int count = unzReadCurrentFile(zip, bytes.data(), unsigned(bytes.size()));
        if (count < 0) return failure("The archive is damaged", {}, damagedZipAdvice);
        if (count == 0) return file.close();
        if (auto written = file.write({bytes.data(), std::size_t(count)}); !written) return written;
    }
}

Result<void> unpackEntry(unzFile zip, const ZipEntry& entry, const std::filesystem::path& folder,
                         UnpackBudget& budget, const std::stop_token& stop) {
    if (entry.isEncrypted)
        return unsupported(fmt::format("\"{}\" in the archive is encrypted", cleanText(entry.name)), {},
                           "Unpack it with its password, and name the files in it");
    auto file = UnpackedFile::create(folder, entry.name, budget);
    if (!file) return tl::make_unexpected(file.error());
    if (unzOpenCurrentFile(zip) != UNZ_OK)
        return failure(fmt::format("\"{}\" in the archive cannot be unpacked", cleanText(entry.name)), {},
                       "Pack it again by the usual method (deflate)");
    const Result<void> copied = copyEntry(zip, *file, stop);
    const bool isWhole = unzCloseCurrentFile(zip) == UNZ_OK;  // the checksum
    if (!copied) return copied;
    if (!isWhole)
        return failure(fmt::format("\"{}\" in the archive is damaged", cleanText(entry.name)), {},
                       damagedZipAdvice);
    return {};
}

}  // namespace

Result<void> unpackZip(const std::filesystem::path& file, const std::filesystem::path& folder,
                       UnpackBudget& budget, const std::stop_token& stop) {
    const Zip zip(unzOpen64(file.c_str()));
    if (!zip) return failure("The archive is damaged or cut off", {}, damagedZipAdvice);
    for (int at = unzGoToFirstFile(zip.get()); at != UNZ_END_OF_LIST_OF_FILE;
         at = unzGoToNextFile(zip.get())) {
        if (at != UNZ_OK) return failure("The archive is damaged", {}, damagedZipAdvice);
        const auto entry = readEntry(zip.get());
        if (!entry) return tl::make_unexpected(entry.error());
        if (isPassedOver(entry->name)) continue;
        if (auto done = unpackEntry(zip.get(), *entry, folder, budget, stop); !done) return done;
    }
    return {};
}

}  // namespace noonmark
