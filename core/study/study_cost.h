#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/study/study.h"

namespace noonmark {

/// Estimates the peak memory of a study, bytes, from the sizes of its parts; within some 30 % for the ray
/// engine. O(parts).
std::uint64_t estimateMemory(const City& city, const StudySettings& settings,
                             const EngineList& engines = coreEngines());

/// Error, stating the memory needed, if the study exceeds settings.memoryLimit (0: 3/4 of what is available).
Result<void> checkMemory(const City& city, const StudySettings& settings,
                         const EngineList& engines = coreEngines());

/// "about 2 s", "about 14 min", "about 3.5 h"
std::string describeDuration(double seconds);

/// "about 14 min left", "about 20 s left"; rounded so that the text does not flicker.
std::string describeRemaining(double seconds);

/// Progress of work in pieces of known sizes. Each piece reports its own fraction; `progress` receives the
/// fraction of the whole and the remaining time, estimated from the speed of the pieces done so far in this
/// run.
class PiecewiseProgress final : public Progress {
public:
    /// `whole`: the sum of all sizes; `before`: the part that earlier runs have done.
    PiecewiseProgress(Progress& progress, double whole, double before)
        : progress_(progress), whole_(whole), before_(before) {}

    /// `name`: "tile 12 of 96". Call only between pieces.
    void begin(std::string name, double size);
    void end();

    void report(double fraction, std::string_view stage) override;

private:
    Progress& progress_;
    double whole_;
    double before_;
    double done_ = 0;
    double size_ = 0;
    std::string name_;
    Stopwatch watch_;
};

/// Error (ErrorKind::unsupported): the settings ask for months or contributions, which an engine with these
/// capabilities does not sum. The error names engines that do.
Result<void> checkBreakdown(const StudySettings& settings, const EngineCapabilities& able,
                            const EngineList& engines);

}  // namespace noonmark
