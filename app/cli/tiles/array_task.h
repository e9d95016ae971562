#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace noonmark::cli {

/// The value of an environment variable; nothing if it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;
std::optional<std::string> readEnvironment(const char* name);

/// The number that a scheduler gave this process in an array of jobs, from 0: SLURM_ARRAY_TASK_ID,
/// JOB_COMPLETION_INDEX of Kubernetes, or AWS_BATCH_JOB_ARRAY_INDEX, in this order. Error: none is set, or
/// not to a whole number.
Result<std::size_t> findArrayTask(const Environment& environment);

}  // namespace noonmark::cli
