#include "core/base/process.h"

#include <unistd.h>

namespace noonmark {

long processId() { return ::getpid(); }

bool mayWrite(const std::filesystem::path& file) { return ::access(file.c_str(), W_OK) == 0; }

bool isTerminal(StandardStream stream) {
    return ::isatty(stream == StandardStream::output ? STDOUT_FILENO : STDERR_FILENO) != 0;
}

}  // namespace noonmark
