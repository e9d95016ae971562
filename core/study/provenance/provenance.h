#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/read_city.h"

namespace noonmark {

/// A file that a result rests on, so that a reader can tell that theirs is the same.
struct InputFile {
    std::filesystem::path path;
    std::uintmax_t bytes = 0;
    std::string sha256;  ///< lower-case hex; empty for a sample, which is made and not read
};
Result<InputFile> inputFile(const std::filesystem::path& path);

/// The file and its companions (companionFiles). Companions that are not there are left out; `path` itself
/// must be there.
Result<std::vector<InputFile>> inputFiles(const std::filesystem::path& path);

/// The city of a scenario as an output names it: core knows no edits, only their words.
struct ScenarioRecord {
    std::string name;                ///< "Existing" for the city as it stands
    std::vector<std::string> edits;  ///< in the order in which they are made, those of its bases first
    std::string citySha256;          ///< cityHash(); equal where every shadow is the same
};

/// The project that a result was measured in.
struct ProjectRecord {
    std::string file;           ///< its name without the folder; empty: it was never saved
    std::string fileSha256;     ///< empty: the file does not hold what was measured
    std::string contentSha256;  ///< of what the result rests on: see contentHashWords
    ScenarioRecord scenario;
    std::optional<ScenarioRecord> baseline;  ///< of a comparison

    /// Whether a command that names the file gives the result again.
    [[nodiscard]] bool saved() const { return !file.empty() && !fileSha256.empty(); }
};

/// How ProjectRecord::contentSha256 is computed (scenarios/project/project_provenance.cpp).
inline constexpr const char* contentHashWords =
    "SHA-256 over lines of text that end in a line feed: 'city' and the SHA-256 of the existing city's "
    "origin, geometry and terrain; 'scenario', and for each of its edits, its bases' first, 'edit', its kind "
    "and its value as the table edits holds it; likewise 'baseline' of a comparison; 'weights' and the "
    "weight table of a score. Names, regions, periods, results and the view are not in it.";

/// What a result was made from. A value that travels with every answer; outputs state it and the command that
/// repeats the answer rests on it.
struct Provenance {
    std::vector<InputFile> inputs;  ///< the files that the city was read from
    /// How they were read; nothing where it is not known, as of a project file of version 1.
    std::optional<ReadSettings> reading = ReadSettings{};
    std::string attribution;
    std::optional<ProjectRecord> project;  ///< none: the city came straight from its files
    /// The region as a command line names it; empty: not known yet, see regionText().
    std::string region;
};

}  // namespace noonmark
