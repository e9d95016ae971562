#include "core/io/files/write_text.h"

#include <fstream>

#include "core/io/files/pending_file.h"

namespace noonmark {

Result<void> writeText(const std::filesystem::path& file, std::string_view text) {
    PendingFile pending(file);
    std::ofstream stream(pending.path(), std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream)
        return limitReached("The file could not be written", file.string(),
                            "Choose a folder that you may write to, and check that the disk has space");
    return pending.commit();
}

}  // namespace noonmark
