#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/study/provenance/command_text.h"
#include "core/study/provenance/provenance.h"
#include "core/study/review_study.h"
#include "core/study/study.h"

namespace noonmark {

/// Whether it is known which files the city was read from, and how.
bool namesCityFiles(const Provenance& provenance);

/// Adds these files and the options of reading them to a command line. Call it only if namesCityFiles().
void addCityFiles(CommandLineText& line, const Provenance& provenance);

/// A question in terms of the command line.
struct RepeatQuestion {
    std::string command;  ///< "study"
    StudySettings settings;
    Provenance provenance;                 ///< its region must be set
    std::string engineKey;                 ///< the engine that was used; empty: the one of the settings
    FlagNames flags{};                     ///< that differ on this command
    bool needsProject = false;             ///< the command takes no city files
    bool namesCity = true;                 ///< the options --scenario and --region; else `options` state both
    std::vector<CommandOption> options{};  ///< options of this command only
};

/// The noonmark-cli command line that reproduces the result, for a POSIX shell, in a folder with copies of
/// the inputs, or of the project file, and of region.geojson if only that file states the region. Settings
/// with default values, and those that do not affect the question, are left out. Lines longer than `width`
/// letters are continued on the next after a backslash. Error, with advice: the project was not saved in the
/// state that was measured, or the inputs of the city are not known.
Result<std::string> makeRepeatCommand(const RepeatQuestion& question, std::size_t width = 120);

/// The same for a study. `command`: "study", or another that takes its options plus `more`.
Result<std::string> makeRepeatCommand(const Study& study, std::size_t width = 120,
                                      const std::string& command = "study",
                                      std::vector<CommandOption> more = {});

/// Whether the command names region.geojson, which must then be written beside the outputs.
bool needsRegionFile(const Study& study);

/// What a review is stated with.
struct ReviewLabels {
    std::string from;  ///< name of the baseline
    std::string to;    ///< name of the scenario
    Provenance provenance;
    /// What was asked for: names, or "all". Empty: the places of the review by name.
    std::vector<std::string> places{};
    /// How the sheets are laid out, and other options of the command.
    std::vector<CommandOption> sheets{};
};

/// Adds the options that state a rule, the choices in it, and where it is found if it is one of the user's
/// own.
void addRule(CommandLineText& line, const Rule& rule);

/// The noonmark-cli command line that reproduces a review in a folder with a copy of the project file and of
/// the rule's file, if the rule is one of the user's own. Error, with advice: the project was not saved in
/// the state that was reviewed.
Result<std::string> makeRepeatCommand(const ReviewStudy& study, const ReviewLabels& labels,
                                      std::size_t width = 120);

}  // namespace noonmark
