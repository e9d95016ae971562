#include <tbb/global_control.h>

#include "core/base/cgroup_limits.h"

namespace noonmark {

struct ThreadLimit::Control {
    tbb::global_control limit;
};

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(new Control{{tbb::global_control::max_allowed_parallelism, threads}}) {}
ThreadLimit::~ThreadLimit() = default;

}  // namespace noonmark
