#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/describe/command_options.h"
#include "core/io/read_city.h"

namespace noonmark {

/// A noonmark-cli command line for a POSIX shell, piece by piece: words are quoted where a shell could
/// misread them.
class CommandLineText {
public:
    explicit CommandLineText(std::string program) : pieces_{std::move(program)} {}

    void file(const std::string& name);
    void option(const char* name, const std::string& value);
    void option(const CommandOption& option);

    /// Lines longer than `width` letters are continued on the next after a backslash, between pieces.
    [[nodiscard]] std::string wrapped(std::size_t width) const;

private:
    std::vector<std::string> pieces_;
};

/// The command with more options at its end.
std::string extendCommand(const std::string& command, const std::vector<CommandOption>& options,
                          std::size_t width);

/// The same of the command that a record states as "repeat". A record without one stays as it is.
std::string extendRepeat(std::string record, const std::vector<CommandOption>& options);

/// The words of a command line as a POSIX shell splits it: single and double quotes, backslashes, continued
/// lines. Error: a quote that does not end, or a character outside quotes to which a shell gives another
/// meaning ($, `, |, ;, &, <, >, (, ), *, ?, #).
Result<std::vector<std::string>> splitCommand(const std::string& command);

/// What to do next with a city, as a command line that can be pasted into a POSIX shell.
struct NextStep {
    std::string why;      ///< "the ground is flat, since there is no terrain"
    std::string command;  ///< "noonmark-cli info town.gml TERRAIN.tif"
};

/// The most useful steps after a city was read, at most three: the field of heights that is not known, a
/// terrain, a first study of a box of 500 m, the window. `files`, `settings`: what it was read with. The
/// region is that of a city that is not empty.
std::vector<NextStep> listNextSteps(const CityRead& read, const std::vector<std::string>& files,
                                    const ReadSettings& settings);

}  // namespace noonmark
