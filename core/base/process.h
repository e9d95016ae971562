#pragma once

#include <cstddef>
#include <filesystem>

namespace noonmark {

// What the standard library does not provide about this process; process_posix.cpp asks POSIX.

/// A number that no other user of this computer has: for names of folders of the user.
long userId();

/// Whether this process may write to an existing file. Permission bits alone do not show it: they differ for
/// owner, group and others, and a file system may be mounted read-only.
bool mayWrite(const std::filesystem::path& file);

enum class StandardStream { output, error };
/// Whether the stream is a terminal, where a line of progress may be overwritten.
bool isTerminal(StandardStream stream);

/// A write beyond the size that the user allows files to have (ulimit -f) fails from now on, and is reported
/// as any other; by itself the system would end the process with SIGXFSZ.
void ignoreFileSizeSignal();

/// Memory of at least this many bytes, not initialised and aligned to 2 MB, so that the system can map it in
/// huge pages: with few page faults, and few entries of the processor's table of pages. Throws
/// std::bad_alloc. Free it with freeHugePages().
[[nodiscard]] void* allocateHugePages(std::size_t bytes);
void freeHugePages(void* memory);

}  // namespace noonmark
