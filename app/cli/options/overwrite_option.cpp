#include "app/cli/options/overwrite_option.h"
#include "core/describe/command_flags.h"

namespace noonmark::cli {

void addOverwriteOption(CLI::App& command, bool& overwrite) {
    command.add_flag(flags::overwrite, overwrite,
                     "Replace existing outputs, but never an input, a project or a file of another kind");
}

}  // namespace noonmark::cli
