#pragma once

#include "core/io/footprints/footprint_scan.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"

namespace noonmark {

/// What is known about all inputs together before any district is read.
struct InputsScan {
    FootprintScan footprints;  ///< frame of the first file, the rest of all files together
    std::vector<std::filesystem::path> buildings, terrain;  ///< the files by kind
    std::vector<LonLatBox> boxes;                           ///< around each of `buildings`
    std::vector<bool> indexed;  ///< of each of `buildings`: it is read by window, else whole
    bool byExtent = false;

    /// The boxes around all files of a plan, in its order; no file of terrain is outside of any window.
    [[nodiscard]] std::vector<LonLatBox> boxesOf(const std::vector<std::string>& files) const;
};

/// Error: as the readers', or files that are too large to be read whole.
Result<InputsScan> scanInputs(const TaskPlanRequest& request, Progress& progress,
                              const std::stop_token& stop);

/// Districts without tiles yet: one with the frame that readCity() would choose, if the region fits into one.
Result<std::vector<District>> findDistricts(const TaskPlanRequest& request, const InputsScan& scan);

/// The files of a plan as paths.
std::vector<std::filesystem::path> pathsOf(const std::vector<std::string>& files);

}  // namespace noonmark
