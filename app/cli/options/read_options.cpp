#include "app/cli/options/read_options.h"

#include "app/cli/options/field_options.h"
#include "core/io/settings/read_fields.h"

namespace noonmark::cli {

void addReadOptions(CLI::App& command, ReadOptions& options) {
    command.add_option("files", options.files, options.filesHelp)->required()->type_name("FILE");
    addFieldOptions(command, readSettingsFields().of(options.settings));
}

}  // namespace noonmark::cli
