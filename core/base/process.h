#pragma once

#include <filesystem>

namespace noonmark {

// What the standard library does not tell about this process; process_posix.cpp asks POSIX.

/// A number that no other running process has: for names of temporary files.
long processId();

/// Whether this process may write to an existing file. Permission bits alone do not tell: they differ for
/// owner, group and others, and a file system may be mounted read-only.
bool mayWrite(const std::filesystem::path& file);

enum class StandardStream { output, error };
/// Whether a person reads the stream, who likes a line of progress that changes.
bool isTerminal(StandardStream stream);

}  // namespace noonmark
