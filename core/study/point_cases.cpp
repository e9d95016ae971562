#include "core/study/point_cases.h"

namespace noonmark {

namespace {

PointCaseFigures figuresOf(const std::string& name, const PointStudy& study) {
    PointCaseFigures figures{.name = name,
                             .skyView = study.baseline.factors.skyView,
                             .skyComponentPct = study.baseline.factors.skyComponentPct};
    for (const SunBand& band : study.baseline.sunlit) figures.dayMin += band.minutes();
    for (const double minutes : sumMonths(study.baseline.minutes)) figures.yearMin += minutes;
    return figures;
}

}  // namespace

Result<std::vector<PointCaseFigures>> measurePointCases(const std::vector<PointCase>& cases,
                                                        const PointQuestion& question,
                                                        const std::stop_token& stop) {
    std::vector<PointCaseFigures> measured;
    std::optional<glm::vec3> position;
    for (const PointCase& one : cases) {
        if (stop.stop_requested()) return cancelled();
        const auto study = runPointStudy(*one.city, nullptr, question, stop);
        if (!study && (!position || isCancelled(study.error()))) return tl::make_unexpected(study.error());
        if (!study)
            measured.push_back({.name = one.name, .why = study.error().what});
        else if (position && study->position != *position)
            measured.push_back({.name = one.name, .why = "The scenario builds where the point is"});
        else
            measured.push_back(figuresOf(one.name, *study));
        if (!position) position = study->position;
    }
    return measured;
}

}  // namespace noonmark
