#pragma once

#include <string>

#include "app/report/sheets/text_column.h"
#include "core/study/study.h"

namespace noonmark {

/// What the numbers of the table mean; before that, where many heights are assumed, that they are.
TextBlocks definitionBlocks(const Study& study);

/// How it was computed; how far it can be trusted; what it rests on: files with their hashes, sources of the
/// heights, warnings; what was left undone. Each section begins with its heading. Long lists are cut, and say
/// so. `errorOf`: a sentence that says of what the measured error is, where it is not of the study's field.
std::vector<TextBlocks> methodSections(const Study& study, const QString& errorOf = {});
std::vector<TextBlocks> sourceSections(const Study& study);

/// The command line that repeats it.
TextBlocks repeatBlocks(const Study& study);

/// How many letters of code a column of the page takes in one line: a command that is broken there without a
/// backslash would not run when it is copied.
inline constexpr std::size_t columnLetters = 80;

/// The same of any answer: its command, or why there is none.
TextBlocks repeatBlocks(const Result<std::string>& command, bool withRegionFile);

}  // namespace noonmark
