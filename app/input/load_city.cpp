#include "app/input/load_city.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <glm/common.hpp>

#include "core/base/stop_scope.h"
#include "core/base/stopwatch.h"
#include "core/city/main_part.h"
#include "core/city/map_context.h"
#include "core/samples/sample_city.h"

namespace noonmark {

namespace {

constexpr std::string_view samplePrefix = "sample:";
constexpr std::string_view parkSample = "sample:central-park-south";

Result<CityRead> sampleRead(const std::string& file) {
    auto city = sampleCity(file.substr(samplePrefix.size()));
    if (!city) return tl::make_unexpected(city.error());
    CityRead read;
    read.city = *std::move(city);
    read.format = "Noonmark sample";
    for (const auto& building : read.city.buildings) read.features += building->parts.size();
    return read;
}

Result<CityRead> readOrMake(const std::vector<std::string>& files, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop) {
    if (std::ranges::none_of(files, isSample))
        return readCity({files.begin(), files.end()}, settings, progress, std::move(stop));
    if (files.size() == 1) return sampleRead(files.front());
    return failure("A sample cannot be combined with other files", files.front(),
                   "Write it to a file with `noonmark-cli sample` and read that file with the others");
}

Result<std::vector<InputFile>> inputsOf(const std::vector<std::string>& files) {
    std::vector<InputFile> inputs;
    for (const std::string& file : files) {
        if (isSample(file)) {
            inputs.push_back({.path = file});
            continue;
        }
        const auto some = describeInputFiles(file);
        if (!some) return tl::make_unexpected(some.error());
        inputs.insert(inputs.end(), some->begin(), some->end());
    }
    return inputs;
}

}  // namespace

bool isSample(std::string_view file) { return file.starts_with(samplePrefix); }
bool isParkSample(std::string_view file) { return file == parkSample; }

Result<City> sampleCity(const std::string& name) {
    if (name == "central-park-south") return makeCentralParkSouthSample();
    if (name == "grid") return makeGridSample({});
    return failure("There is no such sample", "sample '" + name + "'",
                   "The samples are central-park-south and grid");
}

Result<LoadedCity> loadCity(const std::vector<std::string>& files, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop) {
    Result<std::vector<InputFile>> inputs;
    tbb::task_group describing;  // beside the reading; both mostly wait for the disk
    describing.run([&, stop] {
        const StopScope scope(stop);
        inputs = inputsOf(files);
    });
    const Stopwatch watch;
    auto read = readOrMake(files, settings, progress, std::move(stop));
    describing.wait();
    if (!inputs) return tl::make_unexpected(inputs.error());
    if (!read) return tl::make_unexpected(read.error());
    const double seconds = watch.seconds();
    return LoadedCity{files, settings, *std::move(read), *std::move(inputs), seconds};
}

Provenance provenanceOf(const LoadedCity& loaded) {
    Provenance provenance;
    provenance.inputs = loaded.inputs;
    provenance.reading = loaded.settings;
    provenance.attribution = joinAttribution(loaded.read.attribution, loaded.read.city.context.get());
    return provenance;
}

void addReading(Study& study, const LoadedCity& loaded) {
    study.provenance = provenanceOf(loaded);
    study.heights = loaded.read.heights;
    study.warnings.insert(study.warnings.begin(), loaded.read.warnings.begin(), loaded.read.warnings.end());
    study.seconds["read"] = loaded.seconds;
    study.seconds["total"] += loaded.seconds;
}

Result<Region> cityRegion(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty())
        return failure("There is no building, so \"city\" is no region", {},
                       "Name files with buildings, or give the region as west,south,east,north");
    Region region = makeRegionFromLocalBox(box);
    region.name = "the whole city";
    return region;
}

Region firstRegion(const LoadedCity& loaded, float maxM) {
    if (loaded.files.size() == 1 && loaded.files.front() == parkSample)
        return centralParkRegion(loaded.read.city);
    Box2 box = findMainPart(loaded.read.city).box;
    if (box.empty()) box = {{-maxM / 2, -maxM / 2}, {maxM / 2, maxM / 2}};
    // The border leaves some open ground even around a single building.
    constexpr float borderM = 50;
    const Box2 within{box.low - borderM, box.high + borderM};
    Region region = makeRegionFromLocalBox(findDensestBox(loaded.read.city, within, glm::vec2(maxM)));
    region.name = "the middle of the city";
    return region;
}

}  // namespace noonmark
