#include "core/study/text/error_words.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

std::string describePlace(const Study& study, glm::dvec2 localM) {
    const LonLat place = study.city.frame.lonLatFromLocal(localM);
    return fmt::format("{:.5f} {}, {:.5f} {}", std::abs(place.latDeg), place.latDeg < 0 ? "S" : "N",
                       std::abs(place.lonDeg), place.lonDeg < 0 ? "W" : "E");
}

std::string describeCell(const Study& study, const CellError& error) {
    const std::string worst =
        fmt::format("worst {:.3f} % ({:.1f} min)", error.percent(error.maxMin), error.maxMin);
    const std::string place = error.maxMin > 0 ? " at " + describePlace(study, error.worstM) : "";
    return fmt::format("mean {:.4f} % ({:.2f} min), 99 % of cells within {:.3f} %, {}{}",
                       error.percent(error.meanMin), error.meanMin, error.percent(error.p99Min), worst,
                       place);
}

std::string describeSample(const Study& study, const SampledError& error) {
    const auto seconds = study.seconds.find("error_sample");
    return fmt::format("{} of {} receivers against the ray reference, the same {} steps, in {:.2f} s",
                       error.receivers, error.ofReceivers, study.sun.steps.size(),
                       seconds == study.seconds.end() ? 0 : seconds->second);
}

}  // namespace

std::string whyNoError(const Study& study) {
    if (study.error) return {};
    if (study.byReference())
        return "The engine is the ray reference itself, against which others are measured.";
    if (study.settings.errorSample.receivers == 0)
        return "The engine's error against the ray reference was not measured: it was switched off.";
    return "The engine's error against the ray reference could not be measured: see the warnings.";
}

std::vector<ErrorLine> makeErrorLines(const Study& study) {
    if (!study.error) return {{"error", whyNoError(study)}};
    const SampledError& error = *study.error;
    std::vector<ErrorLine> lines;
    const auto add = [&lines](std::string name, std::string value) {
        lines.push_back({std::move(name), std::move(value)});
    };
    add("area error", fmt::format("{:+.4f} % of the ground, standard error {:.4f}", error.areaPct,
                                  error.areaStandardErrorPct));
    add("cell error, gross", describeCell(study, error.gross));
    if (study.sun.steps.size() > 1 && hasRuns(error))
        add("cell error, continuous", describeCell(study, error.continuous));
    add("error measured on", describeSample(study, error));
    return lines;
}

}  // namespace noonmark
