#include "app/cli/options/overwrite_option.h"
#include "core/describe/command_flags.h"

namespace noonmark::cli {

void addOverwriteOption(CLI::App& command, bool& overwrite) {
    command.add_flag(flags::overwrite, overwrite,
                     "Replace existing outputs, but never an input, a project or a file of another kind");
}

void addProjectCopyOption(CLI::App& command, bool& withProject) {
    command.add_flag("--with-project", withProject,
                     "Also put a copy of the project into the folder, so that `verify` finds it");
}

}  // namespace noonmark::cli
