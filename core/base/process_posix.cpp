#include "core/base/process.h"

#include <unistd.h>

#include <csignal>

namespace noonmark {

long userId() { return long(::geteuid()); }

bool mayWrite(const std::filesystem::path& file) { return ::access(file.c_str(), W_OK) == 0; }

bool isTerminal(StandardStream stream) {
    return ::isatty(stream == StandardStream::output ? STDOUT_FILENO : STDERR_FILENO) != 0;
}

void letLargeWritesFail() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace noonmark
