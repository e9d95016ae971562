#pragma once

namespace noonmark {

/// Large arrays that are freed go back to the system at once, so that the window holds no more memory after
/// an hour than its caches need. glibc by itself keeps blocks up to 32 MB for later, torn among the threads.
/// Does nothing with another C library. Call it before the first thread starts.
void returnFreedMemory();

}  // namespace noonmark
