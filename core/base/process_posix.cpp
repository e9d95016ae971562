#include "core/base/process.h"

#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace noonmark {

long userId() { return long(::geteuid()); }

bool mayWrite(const std::filesystem::path& file) { return ::access(file.c_str(), W_OK) == 0; }

bool isTerminal(StandardStream stream) {
    return ::isatty(stream == StandardStream::output ? STDOUT_FILENO : STDERR_FILENO) != 0;
}

void ignoreFileSizeSignal() { std::signal(SIGXFSZ, SIG_IGN); }

void* allocateHugePages(std::size_t bytes) {
    constexpr std::size_t pageBytes = std::size_t{2} << 20U;
    const std::size_t whole = (std::max<std::size_t>(bytes, 1) + pageBytes - 1) / pageBytes * pageBytes;
    void* const memory = std::aligned_alloc(pageBytes, whole);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    madvise(memory, whole, MADV_HUGEPAGE);  // a hint; failure is harmless
#endif
    return memory;
}

void freeHugePages(void* memory) { std::free(memory); }

}  // namespace noonmark
