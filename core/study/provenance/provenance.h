#pragma once

// The folder core/study/provenance records what a result was made from, so that others can check and repeat
// it: Provenance (this file) with the SHA-256 of its input files (sha256.h); the hash of a city and of a
// study (study_hash.h); the command line that repeats a result or a review
// (repeat_command.h); and provenance in JSON, in tags of raster files and in columns of tables
// (provenance_texts.h).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/read_city.h"

namespace noonmark {

/// A file that a result was made from; its hash lets others check that theirs is the same.
struct InputFile {
    std::filesystem::path path;
    std::uintmax_t bytes = 0;
    std::string sha256;  ///< lower-case hex; empty for a sample, which is generated
};
Result<InputFile> describeInputFile(const std::filesystem::path& path);

/// The file and its companions (listCompanionFiles). Missing companions are left out; `path` itself must
/// exist.
Result<std::vector<InputFile>> describeInputFiles(const std::filesystem::path& path);

/// Describes the city of a scenario in outputs, with its edits as text: core does not know edits.
struct ScenarioRecord {
    std::string name;  ///< "Existing" for the city without edits
    /// In the order in which they are applied, those of its base scenarios first
    std::vector<std::string> edits;
    std::string citySha256;  ///< hashCity(); equal for cities with identical shadows
};

/// The project in which a result was computed.
struct ProjectRecord {
    std::string file;           ///< file name without the folder; empty: never saved
    std::string fileSha256;     ///< empty: the file does not hold the state that was measured
    std::string contentSha256;  ///< hash of the content that the result depends on: see contentHashText
    ScenarioRecord scenario;
    std::optional<ScenarioRecord> baseline;  ///< for a comparison

    /// Whether a command that names the file reproduces the result.
    [[nodiscard]] bool saved() const { return !file.empty() && !fileSha256.empty(); }
};

/// How ProjectRecord::contentSha256 is computed (scenarios/project/project_provenance.cpp).
inline constexpr const char* contentHashText =
    "SHA-256 over lines of text that end in a line feed: 'city' and the SHA-256 of the existing city's "
    "origin, geometry and terrain; 'scenario', and for each of its edits, those of its base scenarios first, "
    "'edit', its kind and its value as stored in the table edits; likewise 'baseline' for a comparison; "
    "'weights' and the weight table for a score. Names, regions, periods, results and the view are not "
    "included.";

/// What a result was made from. A value that travels with every result; outputs state it, and the command
/// that repeats the result is built from it.
struct Provenance {
    std::vector<InputFile> inputs;  ///< the files that the city was read from
    /// Settings of the readers; nothing if they are not known, as for a project file of version 1.
    std::optional<ReadSettings> reading = ReadSettings{};
    std::string attribution;
    std::optional<ProjectRecord> project;  ///< nothing: the city came directly from its files
    /// The region in the form of a command line; empty: not known yet, see formatRegion().
    std::string region;
};

}  // namespace noonmark
