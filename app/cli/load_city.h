#pragma once

#include <stop_token>

#include "app/cli/console.h"
#include "app/cli/read_options.h"
#include "core/study/study.h"

namespace noonmark::cli {

/// A city with what it was made of.
struct LoadedCity {
    CityRead read;
    std::vector<InputFile> inputs;  ///< a sample has no bytes and no hash
    double seconds = 0;             ///< to read it; hashing the files is not in it
};

/// Reads the files, or makes the sample where the only "file" is sample:NAME.
Result<LoadedCity> loadCity(const ReadOptions& options, Progress& progress, std::stop_token stop);

/// The same with a progress line, stopped by Ctrl-C.
Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console);

/// The sample of a name ("central-park-south", "grid"), made with its defaults; error for an unknown name.
Result<City> sampleCity(const std::string& name);

}  // namespace noonmark::cli
