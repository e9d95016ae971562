#pragma once

#include <memory>

#include "app/input/load_city.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

/// A study at points, and its list for view and table.
struct ElementAnswer {
    ElementStudy study;
    ElementMap map;
};

/// Runs a study at points of a city read from files, and adds the hash of the windows' file, the warnings of
/// reading and its time, as the command line does. Use it in a job.
Result<ElementAnswer> elementsOf(const LoadedCity& loaded, const StudySettings& settings,
                                 const ElementSettings& elements, Progress& progress,
                                 const std::stop_token& stop);

}  // namespace noonmark
