#pragma once

namespace noonmark {

/// Makes the allocator return large freed arrays to the system at once, so that a long session holds no more
/// memory than its caches need. By default glibc keeps freed blocks of up to 32 MB, scattered over the
/// threads' heaps. Does nothing with another C library. Call it before the first thread starts.
void returnFreedMemory();

}  // namespace noonmark
