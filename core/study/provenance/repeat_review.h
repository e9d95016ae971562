#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/study/provenance/command_words.h"
#include "core/study/provenance/provenance.h"
#include "core/study/review_study.h"

namespace noonmark {

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
void addRule(CommandWords& line, const Rule& rule);

/// The noonmark-cli command line that reproduces a review in a folder with a copy of the project file and of
/// the rule's file, if the rule is one of the user's own. Error, with advice: the project was not saved in
/// the state that was reviewed.
Result<std::string> makeRepeatCommand(const ReviewStudy& study, const ReviewLabels& labels,
                                      std::size_t width = 120);

}  // namespace noonmark
