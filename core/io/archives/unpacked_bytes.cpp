#include "core/io/archives/unpacked_bytes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/clean_text.h"

namespace noonmark {

namespace {

constexpr const char* unpackAdvice = "Unpack it yourself if you trust it, and name the files in it";

// Names with a backslash are those of Windows; a drive or a stream would have a colon.
bool leadsOut(const std::string& name) {
    const std::filesystem::path path(name);
    const auto isUp = [](const std::filesystem::path& step) { return step == ".."; };
    return path.is_absolute() || name.find_first_of("\\:") != name.npos || name.find('\0') != name.npos ||
           std::any_of(path.begin(), path.end(), isUp);
}

}  // namespace

UnpackedFile::UnpackedFile(std::filesystem::path path, UnpackBudget& budget)
    : path_(std::move(path)), stream_(path_, std::ios::binary), budget_(&budget) {}

Result<UnpackedFile> UnpackedFile::create(const std::filesystem::path& folder, const std::string& name,
                                          UnpackBudget& budget) {
    if (leadsOut(name))
        return failure(
            fmt::format("The archive holds a file \"{}\", outside of its own folder", cleanText(name)), {},
            "Do not trust it");
    if (++budget.files > budget.limits.files)
        return limitReached(fmt::format("The archive holds more than {} files", budget.limits.files), {},
                            unpackAdvice);
    const std::filesystem::path path = folder / name;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (std::filesystem::exists(path, error))
        return failure(fmt::format("The archive holds two files \"{}\"", cleanText(name)), {},
                       "Pack it again");
    UnpackedFile file(path, budget);
    if (!file.stream_) return failure(fmt::format("\"{}\" cannot be unpacked", cleanText(name)));
    return file;
}

Result<void> UnpackedFile::write(std::span<const char> bytes) {
    budget_->bytes += bytes.size();
    const UnpackLimits& limits = budget_->limits;
    const bool tooDense = budget_->bytes > limits.anyRatio &&
                          double(budget_->bytes) > limits.ratio * double(budget_->packedBytes);
    if (budget_->bytes > limits.bytes || tooDense)
        return limitReached(
            tooDense ? fmt::format("The archive grows to more than {:g} times its size", limits.ratio)
                     : fmt::format("The archive grows to more than {:.1f} GB", double(limits.bytes) / 1e9),
            {}, unpackAdvice);
    stream_.write(bytes.data(), std::streamsize(bytes.size()));
    if (stream_) return {};
    return failure("The archive cannot be unpacked: is the disk full?", path_.parent_path().string(),
                   "Make room, or state a folder with more in TMPDIR");
}

Result<void> UnpackedFile::close() {
    stream_.close();
    if (stream_) return {};
    return write({});
}

}  // namespace noonmark
