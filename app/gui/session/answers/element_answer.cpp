#include "app/gui/session/answers/element_answer.h"

#include "scenarios/project/project_provenance.h"

namespace noonmark {

namespace {

// Described before the run, so that the hash is that of what was read.
Result<std::optional<InputFile>> describeWindows(const ElementSettings& elements) {
    if (elements.places != ElementPlaces::windows) return std::nullopt;
    if (elements.windows.empty())
        return failure("The windows are missing", "windows", "Choose a file of windows");
    return describeInputFile(elements.windows).map([](InputFile file) { return std::optional(file); });
}

void addReading(ElementStudy& study, const LoadedCity& loaded) {
    study.provenance = provenanceOf(loaded);
    study.heights = loaded.read.heights;
    putBefore(study.warnings, loaded.read.warnings);
    study.seconds["read"] = loaded.seconds;
    study.seconds["total"] += loaded.seconds;
}

}  // namespace

Result<ElementAnswer> elementsOf(const LoadedCity& loaded, const StudySettings& settings,
                                 const ElementSettings& elements, Progress& progress,
                                 const std::stop_token& stop) {
    auto windows = describeWindows(elements);
    if (!windows) return tl::make_unexpected(windows.error());
    auto study = runElementStudy(loaded.read.city, settings, elements, progress, stop);
    if (!study) return tl::make_unexpected(study.error());
    study->windowsFile = *std::move(windows);
    addReading(*study, loaded);
    ElementMap map = makeElementMap(*study);
    return ElementAnswer{*std::move(study), std::move(map)};
}

}  // namespace noonmark
