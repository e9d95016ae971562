#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// How these programs were built. CMake writes the values when it configures; the commit is looked up at each
/// build (cmake/NoonmarkBuildFacts.cmake).
struct BuildFacts {
    std::string_view releaseDate;  ///< of this version: "2026-11-24"
    std::string_view buildType;    ///< "Release"
    std::string_view compiler;     ///< "GNU 12.2.0"
    std::string_view system;       ///< "Linux x86_64"
    std::string_view libraries;    ///< those that figures and pictures depend on: "GDAL 3.6.2, Embree 3.13.5"
};

const BuildFacts& buildFacts();

/// Abbreviated hash of the commit, followed by "-dirty" if files were changed; "unknown" outside of a
/// repository.
std::string_view sourceCommit();

/// What --version prints: the version on the first line, then the facts above and the instruction sets, a
/// line each.
std::string buildFactsText();

}  // namespace noonmark
