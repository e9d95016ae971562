#pragma once

#include <string>

#include "app/report/sheets/text_column.h"
#include "core/describe/command_options.h"
#include "core/describe/shown_as.h"
#include "core/study/study.h"

namespace noonmark {

/// Definitions of the figures, preceded by a warning where many heights are assumed.
TextBlocks definitionBlocks(const Study& study, ShownAs show = ShownAs::shadow);

/// The sections of a report. methodSections(): method and error; `errorOf`: a sentence that states what the
/// measured error refers to, if not to the study's field. sourceSections(): project, files with their hashes,
/// sources of the heights, warnings, and cost. Each section begins with its heading. Long lists are cut and
/// state that.
std::vector<TextBlocks> methodSections(const Study& study, const QString& errorOf = {});
/// A line for each error of what is shown; "not measured" where there is none.
TextBlocks errorBlocks(std::span<const ShownError> errors);
std::vector<TextBlocks> sourceSections(const Study& study);

/// The same one after the other, of a result that is no field of shadow: without cost. `sources` has the
/// city, warnings, heights and provenance of the result. `last`: a section behind them.
TextBlocks sourceBlocks(const Study& sources, const TextBlocks& last = {});

/// The command line that repeats the study, with the options that draw the same: `drawn`.
TextBlocks repeatBlocks(const Study& study, const std::vector<CommandOption>& drawn);

/// Characters per code line in a column of the page. A command that the column breaks without a backslash
/// would not run when copied.
inline constexpr std::size_t columnCharacters = 80;
/// The same in a column of a book's page.
inline constexpr std::size_t bookCharacters = 60;

/// The same for any result: its command, or the reason why there is none.
TextBlocks repeatBlocks(const Result<std::string>& command, bool withRegionFile,
                        const std::vector<CommandOption>& drawn = {}, std::size_t width = columnCharacters);

}  // namespace noonmark
