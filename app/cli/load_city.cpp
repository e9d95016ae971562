#include "app/cli/load_city.h"

#include <algorithm>
#include <chrono>

#include "app/cli/interrupt.h"
#include "app/cli/progress_line.h"
#include "core/samples/sample_city.h"

namespace noonmark::cli {

namespace {

constexpr std::string_view samplePrefix = "sample:";

Result<CityRead> sampleRead(const std::string& file) {
    auto city = sampleCity(file.substr(samplePrefix.size()));
    if (!city) return tl::make_unexpected(city.error());
    CityRead read;
    read.city = *std::move(city);
    read.format = "Noonmark sample";
    for (const auto& building : read.city.buildings) read.features += building->parts.size();
    return read;
}

bool isSample(const std::string& file) { return file.starts_with(samplePrefix); }

Result<CityRead> readOrMake(const ReadOptions& options, Progress& progress, std::stop_token stop) {
    if (std::ranges::none_of(options.files, isSample))
        return readCity({options.files.begin(), options.files.end()}, options.settings, progress,
                        std::move(stop));
    if (options.files.size() == 1) return sampleRead(options.files.front());
    return failure("A sample stands alone", options.files.front(),
                   "Write it to a file with `noonmark-cli sample` and read that with the others");
}

Result<std::vector<InputFile>> inputsOf(const std::vector<std::string>& files) {
    std::vector<InputFile> inputs;
    for (const std::string& file : files) {
        if (isSample(file)) {
            inputs.push_back({.path = file});
            continue;
        }
        const auto some = inputFiles(file);
        if (!some) return tl::make_unexpected(some.error());
        inputs.insert(inputs.end(), some->begin(), some->end());
    }
    return inputs;
}

}  // namespace

Result<City> sampleCity(const std::string& name) {
    if (name == "central-park-south") return centralParkSouthSample();
    if (name == "grid") return gridSample({});
    return failure("There is no such sample", "sample '" + name + "'",
                   "The samples are central-park-south and grid");
}

Result<LoadedCity> loadCity(const ReadOptions& options, Progress& progress, std::stop_token stop) {
    auto inputs = inputsOf(options.files);
    if (!inputs) return tl::make_unexpected(inputs.error());
    const auto begin = std::chrono::steady_clock::now();
    auto read = readOrMake(options, progress, std::move(stop));
    if (!read) return tl::make_unexpected(read.error());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    return LoadedCity{*std::move(read), *std::move(inputs), took.count()};
}

Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    return loadCity(options, progress, interrupt.token());
}

}  // namespace noonmark::cli
