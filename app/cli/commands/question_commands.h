#pragma once

#include "app/cli/base/command.h"
#include "app/questions/question.h"

namespace noonmark::cli {

/// Adds a command for each question that needs no options but those of a study (Question::help). The
/// questions must outlive `run`.
void addQuestionCommands(CLI::App& app, Run& run, Questions questions = allQuestions());

}  // namespace noonmark::cli
