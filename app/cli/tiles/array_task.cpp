#include "app/cli/tiles/array_task.h"

#include <charconv>
#include <cstdlib>

namespace noonmark::cli {

std::optional<std::string> readEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

Result<std::size_t> findArrayTask(const Environment& environment) {
    for (const char* name : {"SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX", "AWS_BATCH_JOB_ARRAY_INDEX"}) {
        const auto text = environment(name);
        if (!text) continue;
        std::size_t task = 0;
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), task);
        if (error == std::errc() && end == text->data() + text->size()) return task;
        return failure("\"" + *text + "\" is not the number of a task", name,
                       "Give --task N, or run in an array of jobs that counts from 0");
    }
    return failure("No task is named", {},
                   "Give --task N, or run in an array of Slurm, Kubernetes or AWS Batch");
}

}  // namespace noonmark::cli
