#include "core/io/files/file_kind.h"

#include <fstream>

#include "core/io/files/plain_file.h"
#include "core/io/files/stoppable_stream.h"

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

}  // namespace noonmark
