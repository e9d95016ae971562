#include "core/study/provenance/sha256.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/base/stop_scope.h"
#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

namespace {

/// Empty if the file cannot be read to its end.
std::string sha256Of(std::istream& file) {
    Sha256 sum;
    std::vector<char> piece(1 << 20);
    while (!StopScope::isStopped() &&
           (file.read(piece.data(), std::streamsize(piece.size())) || file.gcount() > 0))
        sum.add(piece.data(), std::size_t(file.gcount()));
    return file.bad() ? std::string() : sum.hex();
}

Result<std::vector<std::filesystem::path>> filesIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(error)) files.push_back(entry->path());
    if (error || files.empty())
        return failure(error ? "The folder cannot be listed" : "The folder holds no file", folder.string(),
                       "Name a folder of Shapefiles, or a file geodatabase");
    std::ranges::sort(files);
    return files;
}

// A folder that is a data set is one input: its hash is that of the names and hashes of its files.
Result<InputFile> describeFolder(const std::filesystem::path& folder) {
    InputFile all{folder, 0, {}};
    Sha256 sum;
    const auto files = filesIn(folder);
    if (!files) return tl::make_unexpected(files.error());
    for (const std::filesystem::path& path : *files) {
        const auto file = describeInputFile(path);
        if (!file) return file;
        const std::string line = path.filename().string() + " " + file->sha256 + "\n";
        sum.add(line.data(), line.size());
        all.bytes += file->bytes;
    }
    all.sha256 = sum.hex();
    return all;
}

}  // namespace

Result<InputFile> describeInputFile(const std::filesystem::path& given) {
    const std::filesystem::path path =
        given.has_filename() ? given : given.parent_path();  // a folder, with a slash

    if (auto plain = checkPlainFile(path); !plain) return tl::make_unexpected(plain.error());
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return describeFolder(path);
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    const std::string sum = !error && file ? sha256Of(file) : std::string();
    if (StopScope::isStopped()) return cancelled();
    if (sum.empty())
        return failure("The file cannot be read", path.string(),
                       "Check its name and that you have permission to read it");
    return InputFile{path, bytes, sum};
}

Result<std::vector<InputFile>> describeInputFiles(const std::filesystem::path& path) {
    auto main = describeInputFile(path);
    if (!main) return tl::make_unexpected(main.error());
    std::vector<InputFile> files{*std::move(main)};
    for (const std::filesystem::path& name : listCompanionFiles(path)) {
        auto companion = describeInputFile(name);
        if (companion) files.push_back(*std::move(companion));
    }
    return files;
}

}  // namespace noonmark
