#include "core/study/text/next_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/describe/command_options.h"
#include "core/io/settings/read_fields.h"
#include "core/study/provenance/command_words.h"
#include "core/study/study_fields.h"
#include "core/study/text/height_words.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

/// Writes commands that read the same files in the same way.
class StepWriter {
public:
    StepWriter(const std::vector<std::string>& files, const ReadSettings& settings)
        : files_(files), options_(listOptions(readSettingsFields().of(settings))) {}

    [[nodiscard]] std::string write(const char* program, const std::string& more,
                                    const std::string& file = {}) const {
        CommandWords words(program);
        for (const std::string& name : files_) words.file(name);
        if (!file.empty()) words.file(file);
        for (const CommandOption& option : options_) words.option(option);
        const std::string command = words.wrapped(std::numeric_limits<std::size_t>::max());
        return more.empty() ? command : command + " " + more;
    }

    [[nodiscard]] bool hasOptions() const { return !options_.empty(); }

private:
    const std::vector<std::string>& files_;
    std::vector<CommandOption> options_;
};

std::string_view nameFlag(std::span<const Field> rows, std::string_view key) {
    return std::ranges::find(rows, key, &Field::key)->flag;
}

// 500 m around the middle of the buildings, or all of them where that is less.
std::string firstRegion(const City& city) {
    constexpr double halfM = 250;
    const Box2 box = bounds(city);
    const glm::dvec2 middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
    const glm::dvec2 half = glm::min(glm::dvec2(box.high) - middle, glm::dvec2(halfM));
    const LonLat low = city.frame.lonLatFromLocal(middle - half);
    const LonLat high = city.frame.lonLatFromLocal(middle + half);
    return fmt::format("{:.5f},{:.5f},{:.5f},{:.5f}", low.lonDeg, low.latDeg, high.lonDeg, high.latDeg);
}

}  // namespace

std::vector<NextStep> listNextSteps(const CityRead& read, const std::vector<std::string>& files,
                                    const ReadSettings& settings) {
    if (read.city.buildings.empty()) return {};
    const StepWriter writer(files, settings);
    std::vector<NextStep> steps;
    const auto assumed = makeAssumedHeadline(countHeights(read.city));
    if (assumed && !read.heights.unknown.empty()) {
        const std::string options = selectingOptions(read.heights.unknown.front());
        steps.push_back(
            {*assumed, writer.write("noonmark-cli info", options.substr(0, options.find(" or ")))});
    }
    const bool showsRoofs = read.city.terrain && read.city.terrain->source.underBuildings > 0;
    if (assumed && showsRoofs && !settings.heightsFromSurface)
        steps.push_back({"heights that the surface model shows",
                         writer.write("noonmark-cli info", readOption("heights_from_surface"))});
    if (!read.city.terrain)
        steps.push_back({"the ground is flat, since there is no terrain",
                         writer.write("noonmark-cli info", {}, "TERRAIN.tif")});
    steps.push_back(
        {"a day around its middle",
         writer.write(
             "noonmark-cli study",
             fmt::format("{} 2026-06-21 {} sunrise..sunset {}={} {} first-study",
                         nameFlag(periodFields().rows(), "start"), nameFlag(periodFields().rows(), "window"),
                         nameFlag(studyFields().rows(), "region"), firstRegion(read.city), flags::out))});
    steps.push_back(writer.hasOptions()
                        ? NextStep{"a project, which opens in the window",
                                   writer.write("noonmark-cli project new city.noonmark.gpkg", {})}
                        : NextStep{"to see it in the window", writer.write("noonmark", {})});
    constexpr std::size_t most = 3;
    steps.resize(std::min(steps.size(), most));
    return steps;
}

}  // namespace noonmark
