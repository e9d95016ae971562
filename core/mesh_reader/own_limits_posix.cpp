// The C++ library cannot limit a process: the POSIX calls (and two of Linux) for it are all here.
#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>

#include "core/io/meshes/mesh_reader_process.h"
#include "core/mesh_reader/own_limits.h"

namespace noonmark {

namespace {

void limit(int resource, std::uint64_t maximum) {
    rlimit limits{};
    if (::getrlimit(resource, &limits) != 0) return;
    limits.rlim_cur = std::min<rlim_t>(limits.rlim_cur, maximum);
    limits.rlim_max = limits.rlim_cur;
    ::setrlimit(resource, &limits);
}

}  // namespace

void limitMemory([[maybe_unused]] std::uint64_t memoryBytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    limit(RLIMIT_AS, memoryBytes);
#endif
}

void limitThisProcess(std::uint64_t memoryBytes, std::uint64_t cpuSeconds) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::ofstream("/proc/self/oom_score_adj") << 1000;  // the kernel ends this process before any other
    std::set_new_handler([] { std::_Exit(exitOutOfMemory); });
    constexpr std::uint64_t openFiles = 32;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NPROC, 0);
    limit(RLIMIT_NOFILE, openFiles);
    limit(RLIMIT_CPU, cpuSeconds);
    limitMemory(memoryBytes);
}

}  // namespace noonmark
