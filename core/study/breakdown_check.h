#pragma once

#include "core/study/study.h"

namespace noonmark {

/// Error (ErrorKind::unsupported): the settings ask for months or contributions, which an engine with these
/// capabilities does not sum. The error names engines that do.
Result<void> checkBreakdown(const StudySettings& settings, const EngineCapabilities& able,
                            const EngineList& engines);

}  // namespace noonmark
